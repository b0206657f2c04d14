//! The check that a pivot is large enough.

use crate::solve::Scalar;
use crate::solve::check::{Check, Real};
use crate::solve::doubt;

/// The largest multiplier. One pose has multipliers of at most 1, because each pivot is the largest entry of its
/// column. A number that holds several poses takes the pivots of one of them; the others follow as long as this costs
/// them little more than a digit.
const LARGEST_MULTIPLIER: f64 = 16.0;

/// Whether the multiplier of a row is small, that is, whether the pivot is not much smaller than the entry below it.
#[derive(Clone, Copy)]
pub(in crate::solve) struct Multiplier<T>(pub(in crate::solve) T);

impl<T: Scalar> Check<T, 1, 1> for Multiplier<T> {
    fn name(&self) -> &'static str {
        "pivot"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 1] {
        [self.0]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [multiplier]: [R; 1]) -> [R::Truth; 1] {
        [multiplier.magnitude().is_at_most(R::of(LARGEST_MULTIPLIER))]
    }

    fn margin(&self) -> T {
        T::constant(LARGEST_MULTIPLIER) - doubt::size(self.0)
    }
}
