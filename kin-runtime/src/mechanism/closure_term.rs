//! The closure as trigonometric polynomials.

/// A term of a scalar equation of the closure, which is a sum of such terms: a number times a coefficient, powers of
/// inputs and unknowns, and the sine or cosine of a combination of them.
///
/// Quantities are counted from the first input through the last unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ClosureTerm<'d> {
    /// The index of its scalar equation.
    pub equation: u16,
    /// The number.
    pub factor: f64,
    /// The index of its coefficient, which depends on the parameters alone.
    pub coefficient: u16,
    /// The index and power of each quantity.
    pub powers: &'d [(u16, u8)],
    /// The sine or cosine.
    pub harmonic: ClosureHarmonic<'d>,
}

/// The sine or cosine of a whole combination of angles, given by the index and multiple of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ClosureHarmonic<'d> {
    /// Neither: 1.
    One,
    /// A cosine.
    Cosine(&'d [(u16, i8)]),
    /// A sine.
    Sine(&'d [(u16, i8)]),
}

/// Indices of quantities with their powers.
type Powers<'d> = &'d [(u16, u8)];
/// Indices of angles with their multiples.
type Multiples<'d> = &'d [(u16, i8)];

/// The terms that generated code makes.
#[doc(hidden)]
impl<'d> ClosureTerm<'d> {
    #[must_use]
    pub const fn __one(equation: u16, factor: f64, coefficient: u16, powers: Powers<'d>) -> Self {
        Self {
            equation,
            factor,
            coefficient,
            powers,
            harmonic: ClosureHarmonic::One,
        }
    }

    #[must_use]
    pub const fn __cosine(
        equation: u16,
        factor: f64,
        coefficient: u16,
        powers: Powers<'d>,
        angle: Multiples<'d>,
    ) -> Self {
        Self::__one(equation, factor, coefficient, powers).times(ClosureHarmonic::Cosine(angle))
    }

    #[must_use]
    pub const fn __sine(
        equation: u16,
        factor: f64,
        coefficient: u16,
        powers: Powers<'d>,
        angle: Multiples<'d>,
    ) -> Self {
        Self::__one(equation, factor, coefficient, powers).times(ClosureHarmonic::Sine(angle))
    }

    const fn times(self, harmonic: ClosureHarmonic<'d>) -> Self {
        Self { harmonic, ..self }
    }
}
