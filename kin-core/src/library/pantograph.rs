//! The pantograph.

use crate::Assembly;

crate::mechanism! {
    /// Pantograph: the pen draws `factor` times as large whatever the tracer draws.
    ///
    /// The pantograph has two long arms, joined by a hinge at B. One arm turns about the origin and carries the hinge
    /// A; the other carries the hinge D and ends in the pen. Two short links, from A and from D, meet at the tracer.
    /// `upper` is the part of the first arm from the origin to A, and `lower` the part of the other arm from B to D.
    /// Each short link is as long as the opposite part of an arm. In one of the assemblies A, B, D and the tracer
    /// therefore form a parallelogram, and origin, tracer and pen lie on one line.
    ///
    /// Source: C. Scheiner, Pantographice seu ars delineandi, Rome 1631.
    ///
    /// ```
    /// use kin_core::library::Pantograph;
    /// use kin_core::prelude::*;
    ///
    /// let pantograph = Pantograph { upper: 2.0, lower: 1.5, factor: 2.5 };
    /// let x = Motion::from((2.0_f64, 1.0, 0.5, -0.4, 0.3));
    /// let y = Motion::from((1.0_f64, -0.5, 0.2, 0.1, -0.6));
    /// let pen = pantograph.solve(x, y, Pantograph::SIMILAR)?.pen;
    /// for order in 0..5 {
    ///     assert!((pen.x().derivatives()[order] - 2.5 * x.derivatives()[order]).abs() < 1e-12);
    ///     assert!((pen.y().derivatives()[order] - 2.5 * y.derivatives()[order]).abs() < 1e-12);
    /// }
    /// # Ok::<(), SolveError>(())
    /// ```
    pub struct Pantograph {
        /// Distance from the origin to A; B is `factor` times as far.
        pub upper: Length,
        /// Distance from B to D; the pen is `factor` times as far.
        pub lower: Length,
        /// Ratio of the copy to the original.
        pub factor: Scalar,
    }
    input
        /// The tracer's first coordinate.
        x: Length,
        /// The tracer's second coordinate.
        y: Length;
    unknown
        /// The angle of the arm at the origin.
        alpha: Angle,
        /// The angle of the short link from A to the tracer.
        gamma: Angle,
        /// The angle of the arm from B to the pen.
        beta: Angle,
        /// The angle of the short link from the tracer to D.
        delta: Angle;

    upper * cis(alpha) + lower * cis(gamma) == vec2(x, y);
    vec2(x, y) + (factor - 1) * upper * cis(delta) == factor * upper * cis(alpha) + lower * cis(beta);

    /// The pen, which draws the copy.
    output pen: Point = factor * upper * cis(alpha) + factor * lower * cis(beta);
}

impl Pantograph {
    /// The assembly in which the copy is similar to the original. Its mirror image is another one of the four
    /// assemblies.
    pub const SIMILAR: PantographAssembly = PantographAssembly {
        alpha_gamma: Assembly::Open,
        beta_delta: Assembly::Open,
    };
}
