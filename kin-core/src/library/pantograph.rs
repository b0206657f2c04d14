//! The pantograph.

use crate::assembly::Assembly;

crate::mechanism! {
    /// Pantograph: whatever the tracer draws, the pen draws `factor` times as large.
    ///
    /// Two long arms, hinged to each other at B: one turns about the origin and carries A on the way, the other
    /// carries D on the way and ends in the pen. Two short links, from A and from D, meet in the tracer. `upper` is
    /// the long arm's part from the origin to A, and `lower` the other arm's part from B to D, both equal to the
    /// opposite short links' parts: A, B, D and the tracer are a parallelogram, in one of the assemblies, and so
    /// origin, tracer and pen lie on one line.
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
        /// From the origin to A; `factor` times as much to B.
        pub upper: Length,
        /// From B to D; `factor` times as much to the pen.
        pub lower: Length,
        /// How many times as large the copy is.
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
    /// The assembly in which the copy is similar; its mirror image is the other one of the four.
    pub const SIMILAR: PantographAssembly = PantographAssembly {
        alpha_gamma: Assembly::Open,
        beta_delta: Assembly::Open,
    };
}
