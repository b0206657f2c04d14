//! The check that a determinant may be a divisor.

use crate::solve::Scalar;
use crate::solve::check::{Check, Real};
use crate::solve::diagnosis::ordinary;
use crate::solve::doubt::size;

/// Whether a determinant is neither zero, nor so small that it has lost digits, nor too large to have a reciprocal.
#[derive(Clone, Copy)]
pub(in crate::solve) struct Regular<T>(pub(in crate::solve) T);

impl<T: Scalar> Check<T, 1, 2> for Regular<T> {
    fn name(&self) -> &'static str {
        "regular determinant"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 1] {
        [self.0]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [determinant]: [R; 1]) -> [R::Truth; 2] {
        ordinary(determinant.magnitude(), T::SMALLEST)
    }

    fn margin(&self) -> T {
        size(self.0)
    }
}
