//! Chebyshev's straight-line linkage.

crate::mechanism! {
    /// Chebyshev's straight-line linkage: a four-bar linkage with equal, crossed arms, whose coupler midpoint is the
    /// tracer.
    ///
    /// The driven arm turns about the origin, the other arm about (`ground`, 0).
    /// [`PUBLISHED`](ChebyshevLinkage::PUBLISHED) has the proportions 4 : 5 : 2 of ground, arms and coupler (A. B.
    /// Kempe, How to Draw a Straight Line, Macmillan 1877). The tracer is exactly at the height 4 over both pivots and
    /// halfway between them. On the stroke of 4 from one pivot to the other it deviates from this height by less than
    /// 0.01.
    ///
    /// The right end of the stroke is a limit position of the driven arm: arm and coupler lie on one line at atan2(3,
    /// 4) = 36.87°. At the left end the arm is upright.
    ///
    /// ```
    /// use kin_core::library::ChebyshevLinkage;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = ChebyshevLinkage::PUBLISHED;
    /// let left = linkage.position(90_f64.to_radians(), Assembly::Crossed)?.tracer;
    /// assert!(left.value().x.abs() < 1e-14 && (left.value().y - 4.0).abs() < 1e-14);
    /// let middle = linkage.position(f64::atan2(4.0, 3.0), Assembly::Crossed)?.tracer;
    /// assert!((middle.value().x - 2.0).abs() < 1e-14 && (middle.value().y - 4.0).abs() < 1e-14);
    /// for degrees in 37..=90 {
    ///     let tracer = linkage.position(f64::from(degrees).to_radians(), Assembly::Crossed)?.tracer;
    ///     assert!((tracer.value().y - 4.0).abs() < 0.01);
    /// }
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct ChebyshevLinkage {
        /// Ground link.
        pub ground: Length,
        /// Each of the two arms.
        pub arm: Length,
        /// Coupler.
        pub coupler: Length,
    }
    input
        /// The angle of the arm at the origin.
        theta2: Angle;
    unknown
        /// The coupler's angle, from the driven arm to the other.
        theta3: Angle,
        /// The other arm's angle.
        theta4: Angle;

    arm * cis(theta2) + coupler * cis(theta3) == ground + arm * cis(theta4);

    /// The coupler's midpoint.
    output tracer: Point = arm * cis(theta2) + coupler / 2 * cis(theta3);
}

impl ChebyshevLinkage {
    /// The proportions 4 : 5 : 2.
    pub const PUBLISHED: Self = Self {
        ground: 4.0,
        arm: 5.0,
        coupler: 2.0,
    };
}
