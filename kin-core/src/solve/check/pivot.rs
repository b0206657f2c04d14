//! Whether a pivot serves.

use crate::solve::Scalar;
use crate::solve::check::Check;
use crate::solve::doubt;

/// Multipliers are at most 1, as the pivot is the largest of its column. A number that stands for several poses has the pivots of
/// one of them; the others go along as long as that does not cost them more than a digit or so.
const LARGEST_MULTIPLIER: f64 = 16.0;

/// Whether a pivot is not much smaller than the entry below it: the multiplier of a row is small.
#[derive(Clone, Copy)]
pub(in crate::solve) struct Multiplier<T>(pub(in crate::solve) T);

impl<T: Scalar> Check<T, 1, 1> for Multiplier<T> {
    fn name(&self) -> &'static str {
        "pivot"
    }

    #[inline(always)]
    fn operands(&self) -> [T; 1] {
        [self.0]
    }

    #[inline(always)]
    fn holds(&self, [multiplier]: [f64; 1]) -> [bool; 1] {
        [multiplier.abs() <= LARGEST_MULTIPLIER]
    }

    fn margin(&self) -> T {
        T::constant(LARGEST_MULTIPLIER) - doubt::size(self.0)
    }
}
