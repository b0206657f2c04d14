//! What is done for no other reason than to make the generated program cheaper.
//!
//! All of it is always done. That each part saves what it is there for is measured by leaving out one at a time, over the whole
//! library: see `testing/optimiser.rs` and the chapter "The optimiser" of the book.

/// A pass, or a part of one, without which the same would be computed at greater expense.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Pass {
    /// Numbers are added and multiplied when the declaration is compiled, and what is multiplied by zero is dropped.
    ConstantFolding,
    /// Equations are multiplied out before they are differentiated, if that is cheaper than as they were typed.
    MultipliedOut,
    /// Equations are differentiated as they were typed, if that is cheaper than multiplied out.
    AsTyped,
    /// Everything that turns with one angle shares the P and Q of its rates.
    LinkVectors,
    /// A turning link is solved for its whole Q, from which lower rates are taken afterwards.
    WholeTurnings,
    /// What rates add to other rates is collected in coefficients that depend on the position alone, if that is cheaper.
    Influences,
    /// Coefficients that differ only by a number in front are one coefficient.
    CommonNumbers,
    /// A determinant or a coefficient of the form m cos² x + m sin² x is m.
    Radii,
    /// A Jacobian of more than three equations is reduced as far as that cannot fail.
    ReducedJacobians,
    /// Three equations are solved by Cramer's rule, and not by factors.
    CramerOfThree,
    /// Sines and cosines of unknown angles are read off vectors that the closed forms return.
    UnitVectors,
    /// The sine and the cosine of an angle are one call.
    SineCosinePairs,
    /// What is needed more than once is computed once.
    CommonSubexpressions,
    /// What a stage has computed is handed on to those after it.
    Carrying,
    /// Two factors, or two terms, that occur together more than once are multiplied, or added, once.
    SharedPairs,
    /// Terms with the same number in front are added before they are multiplied by it.
    SharedNumbers,
    /// A factor of several terms of a sum is taken out, if that is cheaper.
    SharedFactors,
    /// A factor of several terms of a sum stays in them, if that is cheaper.
    FactorsLeft,
    /// What a closed form takes the root of is inverted beside the root.
    InvertedRoots,
    /// What is divided by more than once is inverted once.
    SharedReciprocals,
}

/// The passes that run: all, or all but one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Passes {
    without: Option<Pass>,
}

impl Passes {
    pub(crate) const ALL: Self = Self { without: None };

    /// All but one.
    #[cfg(test)]
    pub(crate) const fn without(pass: Pass) -> Self {
        Self { without: Some(pass) }
    }

    /// Whether a pass is among them.
    pub(crate) fn include(self, pass: Pass) -> bool {
        self.without != Some(pass)
    }
}
