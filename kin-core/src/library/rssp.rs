//! The spatial slider-crank RSSP: a crank, a rod between two ball joints, and a slider on a skew line.

crate::mechanism! {
    /// Spatial slider-crank RSSP: a crank drives a slider on a skew line by a rod with a ball joint at each end.
    ///
    /// The crank turns about the z axis. Its ball is at the distance `crank` from the origin, and on the x axis at
    /// angle 0. The slider's ball moves on the line through `start` in the direction of `rail`, whose length does not
    /// matter; `s` is the distance of the ball from `start`.
    ///
    /// The square of the rod's length is a quadratic equation in s.
    ///
    /// ```
    /// use kin_core::library::Rssp;
    /// use kin_core::prelude::*;
    ///
    /// // the slider moves upwards, 2 beside the crank's axis
    /// let linkage = Rssp {
    ///     crank: 1.0,
    ///     start: Space::new(2.0, 0.0, 0.0),
    ///     rail: Space::new(0.0, 0.0, 1.0),
    ///     rod: 3.0,
    /// };
    /// // crank straight back: the rod bridges 3 and lies flat; straight up: s² = 9 - 5
    /// let pose = linkage.solve(Motion::at_constant_speed(90_f64.to_radians(), 1.0), Assembly::Open)?;
    /// assert!((pose.s.position() - 2.0).abs() < 1e-15);
    /// // s s' = 2 cos(theta)' = -2
    /// assert!((pose.s.velocity() + 1.0).abs() < 1e-15);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct Rssp {
        /// Crank.
        pub crank: Length,
        /// A point on the slider's line.
        pub start: Point3,
        /// The direction of the slider's line, of any length but zero.
        pub rail: Vector3,
        /// Rod, from ball to ball.
        pub rod: Length,
    }
    input
        /// The crank's angle.
        theta: Angle;
    unknown
        /// The slider's distance from the start of its line.
        s: Length;

    let slider = start + s * (rail / norm(rail));
    let pin = rot_z(theta) * vec3(crank, 0, 0);
    let coupler = slider - pin;
    dot(coupler, coupler) == rod.powi(2);

    /// The slider's ball.
    output ball: Point3 = slider;

    ground 0;
    body crank: 0, pin;
    body rod: pin, ball;
    slide ball along rail;
}
