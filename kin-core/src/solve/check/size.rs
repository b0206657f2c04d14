//! The sizes of numbers.

use crate::solve::Scalar;
use crate::solve::check::Measure;

/// The sum of the magnitudes of some terms.
#[derive(Clone, Copy)]
pub(in crate::solve) struct SumOfSizes<T, const N: usize>(pub(in crate::solve) [T; N]);

impl<T: Scalar, const N: usize> Measure<T, N> for SumOfSizes<T, N> {
    fn name(&self) -> &'static str {
        "sizes of the terms"
    }

    #[inline(always)]
    fn operands(&self) -> [T; N] {
        self.0
    }

    #[inline(always)]
    fn measure(&self, terms: [f64; N]) -> f64 {
        let mut sum = 0.0;
        for term in terms {
            sum += term.abs();
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

    #[inline(always)]
    fn operands(&self) -> [T; 2] {
        [self.size, self.number]
    }

    #[inline(always)]
    fn measure(&self, [largest, number]: [f64; 2]) -> f64 {
        let size = number.abs();
        if size > largest { size } else { largest }
    }
}

/// The largest magnitude of some lengths, or 1 if all of them are zero.
#[derive(Clone, Copy)]
pub(in crate::solve) struct LargestLength<T, const N: usize>(pub(in crate::solve) [T; N]);

impl<T: Scalar, const N: usize> Measure<T, N> for LargestLength<T, N> {
    fn name(&self) -> &'static str {
        "largest length"
    }

    #[inline(always)]
    fn operands(&self) -> [T; N] {
        self.0
    }

    #[inline(always)]
    fn measure(&self, lengths: [f64; N]) -> f64 {
        let largest = lengths
            .iter()
            .fold(0.0_f64, |largest, length| largest.max(length.abs()));
        if largest > 0.0 { largest } else { 1.0 }
    }
}
