//! Whether a number is told from zero.

use crate::solve::Scalar;
use crate::solve::check::Check;
use crate::solve::doubt;

/// Whether a number is larger than [a part](Scalar::DOUBT) of the terms that it is the sum of.
#[derive(Clone, Copy)]
pub(in crate::solve) struct Told<T> {
    pub(in crate::solve) number: T,
    /// The sizes of the terms together.
    pub(in crate::solve) size: T,
}

impl<T: Scalar> Check<T, 2, 1> for Told<T> {
    fn name(&self) -> &'static str {
        "sum beyond doubt"
    }

    #[inline(always)]
    fn operands(&self) -> [T; 2] {
        [self.number, self.size]
    }

    #[inline(always)]
    fn holds(&self, [number, size]: [f64; 2]) -> [bool; 1] {
        [number.abs() >= T::DOUBT * size]
    }

    fn margin(&self) -> T {
        doubt::size(self.number) - self.size * T::constant(T::DOUBT)
    }
}
