//! A four-bar linkage with a point of its coupler, anywhere in the plane.

use kin_core::prelude::*;

mechanism! {
    /// A four-bar linkage with a tracer on its coupler, rotated and moved to any position in the plane.
    ///
    /// The crank's angle is measured from the ground link. These are the nine dimensions of the papers on path
    /// generation: r1, r2, r3, r4, the tracer's coordinates `r_cx` and `r_cy` along and beside the coupler, the angle
    /// θ0 of the ground link, and the coordinates (x0, y0) of the crank's pivot.
    ///
    /// ```
    /// use kin_core::prelude::*;
    /// use kin_fit::TracedFourBar;
    ///
    /// let linkage = TracedFourBar {
    ///     r1: 2.0, r2: 1.0, r3: 2.5, r4: 2.5,
    ///     point: Plane::new(5.0, 0.0), turn: 0.0, pivot: Plane::new(0.0, 0.0),
    /// };
    /// // Hoeken's linkage: the tracer is at the height 4 over the crank's pivot
    /// let tracer = linkage.position(std::f64::consts::PI, Assembly::Open)?.tracer.value();
    /// assert!((tracer.x - 2.0).abs() < 1e-12 && (tracer.y - 4.0).abs() < 1e-12);
    /// # Ok::<(), SolveError>(())
    /// ```
    #[derive(PartialEq)]
    pub struct TracedFourBar {
        /// Ground link.
        pub r1: Length,
        /// Crank.
        pub r2: Length,
        /// Coupler.
        pub r3: Length,
        /// Rocker.
        pub r4: Length,
        /// The tracer in the coupler's frame: from the crank's pin, x along the coupler.
        pub point: Vector,
        /// The angle of the ground link.
        pub turn: Angle,
        /// The crank's pivot.
        pub pivot: Point,
    }
    input
        /// The crank's angle from the ground link.
        theta2: Angle;
    unknown
        /// The coupler's angle from the ground link.
        theta3: Angle,
        /// The rocker's angle from the ground link.
        theta4: Angle;

    r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);

    /// The tracer.
    output tracer: Point = pivot + cis(turn) * (r2 * cis(theta2) + point * cis(theta3));

    with sensitivities;
}

impl TracedFourBar {
    /// By how much the crank fails to make full revolutions, as a share of the longest link; zero or less if it makes
    /// them.
    ///
    /// The crank makes full revolutions if the diagonal from its pin to the rocker's pivot, which lies between |r1 -
    /// r2| and r1 + r2, always stays between |r3 - r4| and r3 + r4.
    #[must_use]
    pub fn shortfall(&self) -> f64 {
        let longest = self.r1.max(self.r2).max(self.r3).max(self.r4);
        let far = self.r1 + self.r2 - self.r3 - self.r4;
        let near = (self.r3 - self.r4).abs() - (self.r1 - self.r2).abs();
        far.max(near) / longest
    }
}
