//! The spatial four-bar linkage RSSR: two skew shafts, and a rod between two ball joints.

crate::mechanism! {
    /// Spatial four-bar linkage RSSR: crank and rocker turn about skew axes, and a rod with a ball joint at each end
    /// connects them.
    ///
    /// The crank turns about the z axis. Its ball is at the distance `crank` from the origin, and on the x axis at
    /// angle 0. The rocker's axis passes through the point `pivot` in the direction of `axis`, whose length does not
    /// matter. `arm` is the vector from the pivot to the rocker's ball at the rocker's angle 0; it need not be at right
    /// angles to the axis. The rod may spin about its length without any effect.
    ///
    /// The square of the rod's length gives the equation a cos phi + b sin phi = c in the rocker's angle phi. It has
    /// two solutions, like Freudenstein's equation in the plane. (R. S. Hartenberg and J. Denavit, "Kinematic Synthesis
    /// of Linkages", 1964, treat the linkage by matrices; here the vectors are used directly.)
    ///
    /// ```
    /// use kin_core::library::Rssr;
    /// use kin_core::prelude::*;
    ///
    /// // the rocker's axis is the line x = 3, z = 0; at angle 0 its arm points upwards
    /// let linkage = Rssr {
    ///     crank: 1.0,
    ///     pivot: Space::new(3.0, 0.0, 0.0),
    ///     axis: Space::new(0.0, 1.0, 0.0),
    ///     arm: Space::new(0.0, 0.0, 2.0),
    ///     rod: 13_f64.sqrt(),
    /// };
    /// // crank at 90 degrees: from (0, 1, 0) to (3, 0, 0) + 2 (sin phi, 0, cos phi), squared 14 + 12 sin phi
    /// let pose = linkage.solve(Motion::at_constant_speed(90_f64.to_radians(), 1.0), Assembly::Open)?;
    /// assert!((pose.phi.position().sin() + 1.0 / 12.0).abs() < 1e-15);
    /// // the ball moves in the rocker's plane, y = 0
    /// assert_eq!(pose.ball.y().derivatives(), [0.0; 5]);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct Rssr {
        /// Crank.
        pub crank: Length,
        /// A point on the rocker's axis.
        pub pivot: Point3,
        /// The direction of the rocker's axis, of any length but zero.
        pub axis: Vector3,
        /// The vector from the pivot to the rocker's ball at angle 0.
        pub arm: Vector3,
        /// Rod, from ball to ball.
        pub rod: Length,
    }
    input
        /// The crank's angle.
        theta: Angle;
    unknown
        /// The rocker's angle.
        phi: Angle;

    let rocker = pivot + rot(axis, phi) * arm;
    let pin = rot_z(theta) * vec3(crank, 0, 0);
    let coupler = rocker - pin;
    dot(coupler, coupler) == rod.powi(2);

    /// The rocker's ball.
    output ball: Point3 = rocker;

    ground 0, pivot;
    body crank: 0, pin;
    body rod: pin, ball;
    body arm: pivot, ball;
}
