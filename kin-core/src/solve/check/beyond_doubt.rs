//! The check that a number differs clearly from zero.

use crate::solve::Scalar;
use crate::solve::check::{Check, Real};
use crate::solve::doubt;

/// Whether a sum is larger than [a part](Scalar::DOUBT) of its terms.
#[derive(Clone, Copy)]
pub(in crate::solve) struct BeyondDoubt<T> {
    pub(in crate::solve) number: T,
    /// The sum of the magnitudes of the terms.
    pub(in crate::solve) size: T,
}

impl<T: Scalar> Check<T, 2, 1> for BeyondDoubt<T> {
    fn name(&self) -> &'static str {
        "sum beyond doubt"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 2] {
        [self.number, self.size]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [number, size]: [R; 2]) -> [R::Truth; 1] {
        [number.magnitude().is_at_least(R::of(T::DOUBT) * size)]
    }

    fn margin(&self) -> T {
        doubt::size(self.number) - self.size * T::constant(T::DOUBT)
    }
}
