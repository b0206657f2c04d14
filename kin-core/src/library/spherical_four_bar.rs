//! The spherical four-bar linkage: four hinges whose axes meet in one point.

crate::mechanism! {
    /// Spherical four-bar linkage: its links are arcs of great circles on a sphere, its hinges point to the centre.
    ///
    /// The links are measured by the angles that they span, like the crank's and the rocker's directions: both angles are
    /// counter-clockwise from the ground arc, seen from outside of the sphere. For links that are small beside the
    /// sphere it is the plane four-bar linkage; with crank, coupler and rocker of 90 degrees, the universal joint.
    ///
    /// The only equation: the angle between the coupler's two hinges is the coupler itself. It is
    /// a cos(rocker angle) + b sin(rocker angle) = c.
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
}
