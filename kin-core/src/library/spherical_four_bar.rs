//! The spherical four-bar linkage: four hinges whose axes meet at one point.

crate::mechanism! {
    /// Spherical four-bar linkage: its links are arcs of great circles on a sphere, and its hinges point to the centre.
    ///
    /// The lengths of the links are the angles that they span. The directions of crank and rocker are angles too,
    /// counter-clockwise from the ground arc, seen from outside the sphere. If the links are small compared with the
    /// sphere, it is the plane four-bar linkage. If crank, coupler and rocker are 90 degrees, it is the universal
    /// joint.
    ///
    /// The only equation says that the angle between the coupler's two hinges is the coupler itself. It has the form a
    /// cos(rocker angle) + b sin(rocker angle) = c.
    ///
    /// ```
    /// use kin_core::library::SphericalFourBar;
    /// use kin_core::prelude::*;
    ///
    /// let [ground, crank, coupler, rocker] = [90_f64, 30.0, 90.0, 60.0].map(f64::to_radians);
    /// let linkage = SphericalFourBar { ground, crank, coupler, rocker };
    /// let pose = linkage.solve(Motion::at_constant_speed(90_f64.to_radians(), 1.0), Assembly::Open)?;
    /// // there sin(30) sin(60) sin(theta4) = cos(30) sin(60) cos(theta4)
    /// assert!((pose.theta4.position().tan() - 3_f64.sqrt()).abs() < 1e-14);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct SphericalFourBar {
        /// Ground arc, from the crank's axis to the rocker's.
        pub ground: Angle,
        /// Crank.
        pub crank: Angle,
        /// Coupler.
        pub coupler: Angle,
        /// Rocker.
        pub rocker: Angle,
    }
    input
        /// The crank's angle.
        theta2: Angle;
    unknown
        /// The rocker's angle.
        theta4: Angle;

    let axis = vec3(0, 0, 1);
    let crank_hinge = rot_z(theta2) * rot_y(crank) * axis;
    let rocker_hinge = rot_y(ground) * rot_z(theta4) * rot_y(rocker) * axis;
    dot(crank_hinge, rocker_hinge) == cos(coupler);

    // on the unit sphere, whose centre is a point of every link
    let rocker_pivot = rot_y(ground) * axis;
    ground axis, rocker_pivot;
    body crank: 0, axis, crank_hinge;
    body coupler: 0, crank_hinge, rocker_hinge;
    body rocker: 0, rocker_pivot, rocker_hinge;
}
