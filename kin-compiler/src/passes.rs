//! The passes that only make the generated program cheaper.
//!
//! All passes always run. Tests leave out one pass at a time to measure its savings over the whole library: see
//! `testing/optimiser.rs` and the chapter "The macro, pass by pass" of the book.

/// A pass, or a part of one. Without it the same values would be computed at greater cost.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Pass {
    /// Numbers are added and multiplied at compile time, and products with zero are dropped.
    ConstantFolding,
    /// Equations are multiplied out before they are differentiated, if this is cheaper than leaving their products.
    MultipliedOut,
    /// Products of varying expressions are left when equations are differentiated, if this is cheaper.
    ProductsLeft,
    /// All vectors that rotate with one angle share the P and Q of its rates.
    LinkVectors,
    /// The equations are solved for the whole Q of a rotating link, and the contributions of lower rates are subtracted
    /// afterwards.
    WholeTurnings,
    /// The influences of rates on other rates are collected in coefficients that depend on the position alone, if that
    /// is cheaper.
    Influences,
    /// Coefficients that differ only by a number in front are one coefficient.
    CommonNumbers,
    /// A determinant or a coefficient of the form m cos² x + m sin² x is m.
    Radii,
    /// A Jacobian of more than three equations is reduced as far as no step can fail.
    ReducedJacobians,
    /// Three equations are solved by Cramer's rule instead of by factors.
    CramerOfThree,
    /// Sines and cosines of unknown angles are read off vectors that the closed forms return.
    UnitVectors,
    /// The sine and the cosine of an angle are one call.
    SineCosinePairs,
    /// A value that is needed more than once is computed once.
    CommonSubexpressions,
    /// A value that one stage has computed is handed to later stages.
    Carrying,
    /// Two factors, or two terms, that occur together more than once are multiplied, or added, once.
    SharedPairs,
    /// Terms with the same number in front are added before they are multiplied by it.
    SharedNumbers,
    /// A factor that several terms of a sum share is taken out, if that is cheaper.
    SharedFactors,
    /// A factor that several terms of a sum share stays in them, if that is cheaper.
    FactorsLeft,
    /// The radicand of a closed form's root is inverted beside the root.
    InvertedRoots,
    /// A divisor that is used more than once is inverted once.
    SharedReciprocals,
}

/// The passes that run: all, or all but one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Passes {
    without: Option<Pass>,
}

impl Passes {
    pub(crate) const ALL: Self = Self { without: None };

    /// All passes except one.
    #[cfg(test)]
    pub(crate) const fn without(pass: Pass) -> Self {
        Self { without: Some(pass) }
    }

    /// Whether a pass runs.
    pub(crate) fn include(self, pass: Pass) -> bool {
        self.without != Some(pass)
    }
}
