//! The sizes of numbers.

use crate::solve::Scalar;
use crate::solve::check::{Measure, Real};

/// The sum of the magnitudes of some terms.
#[derive(Clone, Copy)]
pub(in crate::solve) struct SumOfSizes<T, const N: usize>(pub(in crate::solve) [T; N]);

impl<T: Scalar, const N: usize> Measure<T, N> for SumOfSizes<T, N> {
    fn name(&self) -> &'static str {
        "sizes of the terms"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; N] {
        self.0
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measure<R: Real>(&self, terms: [R; N]) -> R {
        let mut sum = R::of(0.0);
        for term in terms {
            sum = sum + term.magnitude();
        }
        sum
    }
}

/// The larger of a given size and the magnitude of a number.
#[derive(Clone, Copy)]
pub(in crate::solve) struct LargestSize<T> {
    pub(in crate::solve) size: T,
    pub(in crate::solve) number: T,
}

impl<T: Scalar> Measure<T, 2> for LargestSize<T> {
    fn name(&self) -> &'static str {
        "largest entry"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 2] {
        [self.size, self.number]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measure<R: Real>(&self, [largest, number]: [R; 2]) -> R {
        let size = number.magnitude();
        R::choose(size.exceeds(largest), || size, || largest)
    }
}

/// The largest magnitude of some lengths, or 1 if all of them are zero.
#[derive(Clone, Copy)]
pub(in crate::solve) struct LargestLength<T, const N: usize>(pub(in crate::solve) [T; N]);

impl<T: Scalar, const N: usize> Measure<T, N> for LargestLength<T, N> {
    fn name(&self) -> &'static str {
        "largest length"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; N] {
        self.0
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measure<R: Real>(&self, lengths: [R; N]) -> R {
        let zero = R::of(0.0);
        let mut largest = zero;
        for length in lengths {
            let size = length.magnitude();
            largest = R::choose(size.exceeds(largest), || size, || largest);
        }
        R::choose(largest.exceeds(zero), || largest, || R::of(1.0))
    }
}
