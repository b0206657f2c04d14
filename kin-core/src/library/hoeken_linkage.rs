//! Hoeken's straight-line linkage.

crate::mechanism! {
    /// Hoeken's straight-line linkage, also called Hoecken's linkage or Chebyshev's lambda linkage: a crank-rocker
    /// whose coupler is as long as the rocker, and as long as its extension to the tracer.
    ///
    /// The crank turns about the origin, the rocker about (`ground`, 0). While the crank passes through the half-plane
    /// away from the rocker's pivot, the tracer moves along a nearly straight line at a nearly constant speed.
    /// [`PUBLISHED`](HoekenLinkage::PUBLISHED) has the proportions 1 : 2 : 2.5 of crank, ground and coupler. Its tracer
    /// is exactly at the height 4 when the crank is at 90°, 180° and 270°, over x = 4, 2 and 0, and deviates from this
    /// height by less than 0.01 in between. It draws the same curve as its cognate
    /// [`ChebyshevLinkage::PUBLISHED`](super::ChebyshevLinkage::PUBLISHED) (E. A. Dijksman, Motion Geometry of
    /// Mechanisms, Cambridge University Press 1976).
    ///
    /// R. L. Norton, Design of Machinery, McGraw-Hill, tabulates proportions for other line lengths: with a ground link
    /// of 2.5 cranks and a coupler of 3.25 cranks, the line is 3.623 cranks long over 140° of the crank.
    ///
    /// ```
    /// use kin_core::library::HoekenLinkage;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = HoekenLinkage::PUBLISHED;
    /// for degrees in 90..=270 {
    ///     let tracer = linkage.position(f64::from(degrees).to_radians(), Assembly::Open)?.tracer.value();
    ///     assert!((tracer.y - 4.0).abs() < 0.01);
    /// }
    ///
    /// let longer = HoekenLinkage { ground: 2.5, crank: 1.0, coupler: 3.25 };
    /// let at = |degrees: f64| longer.position(degrees.to_radians(), Assembly::Open);
    /// let line = at(110.0)?.tracer.value().x - at(250.0)?.tracer.value().x;
    /// assert!((line - 3.623).abs() < 5e-4);
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct HoekenLinkage {
        /// Ground link.
        pub ground: Length,
        /// Crank.
        pub crank: Length,
        /// The coupler from crank to rocker; its extension from there to the tracer and the rocker have the same
        /// length.
        pub coupler: Length,
    }
    input
        /// The crank's angle.
        theta2: Angle;
    unknown
        /// The coupler's angle.
        theta3: Angle,
        /// The rocker's angle.
        theta4: Angle;

    crank * cis(theta2) + coupler * cis(theta3) == ground + coupler * cis(theta4);

    /// The end of the coupler's extension.
    output tracer: Point = crank * cis(theta2) + 2 * coupler * cis(theta3);
}

impl HoekenLinkage {
    /// The proportions 1 : 2 : 2.5, with which the crank makes full revolutions.
    pub const PUBLISHED: Self = Self {
        ground: 2.0,
        crank: 1.0,
        coupler: 2.5,
    };
}
