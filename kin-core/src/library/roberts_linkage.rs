//! Roberts's straight-line linkage.

crate::mechanism! {
    /// Roberts's straight-line linkage: a four-bar linkage whose coupler is the base of an isosceles triangle with
    /// sides as long as the arms. The apex is the tracer.
    ///
    /// The driven arm turns about the origin, the other arm about (2 `base`, 0). The tracer lies exactly on the line of
    /// the pivots at both pivots and halfway between them, and close to it in between. Longer arms bring it closer.
    ///
    /// Source: A. B. Kempe, How to Draw a Straight Line, Macmillan 1877. The largest deviation is 0.68 % of the stroke
    /// with `arm` = 1.2 `base`, and 0.11 % with 2 `base`.
    ///
    /// ```
    /// use kin_core::library::RobertsLinkage;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = RobertsLinkage { base: 1.0, arm: 2.0 };
    /// // in the middle the driven arm leads to the triangle's corner, half a base from the origin
    /// let middle = linkage.position((0.5_f64 / 2.0).acos(), Assembly::Open)?.tracer.value();
    /// assert!((middle.x - 1.0).abs() < 1e-14 && middle.y.abs() < 1e-14);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct RobertsLinkage {
        /// The coupler from joint to joint, half of the ground link.
        pub base: Length,
        /// Each of the two arms, and of the two sides of the triangle.
        pub arm: Length,
    }
    input
        /// The angle of the arm at the origin.
        theta2: Angle;
    unknown
        /// The coupler's angle, from the driven arm to the other.
        theta3: Angle,
        /// The other arm's angle.
        theta4: Angle;

    arm * cis(theta2) + base * cis(theta3) == 2 * base + arm * cis(theta4);

    let height = sqrt(arm.powi(2) - base.powi(2) / 4);
    /// The triangle's apex.
    output tracer: Point = arm * cis(theta2) + vec2(base / 2, -height) * cis(theta3);
}
