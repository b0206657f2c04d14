//! The check that numbers are finite.

use crate::solve::Scalar;
use crate::solve::check::{Check, Real};

/// Whether the real parts of some numbers are all finite.
#[derive(Clone, Copy)]
pub(in crate::solve) struct Finite<T, const N: usize>(pub(in crate::solve) [T; N]);

impl<T: Scalar, const N: usize> Check<T, N, N> for Finite<T, N> {
    fn name(&self) -> &'static str {
        "finite numbers"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; N] {
        self.0
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, numbers: [R; N]) -> [R::Truth; N] {
        numbers.map(R::is_finite)
    }

    /// The margin is infinite or NaN.
    fn margin(&self) -> T {
        let sum = self
            .0
            .into_iter()
            .fold(T::constant(0.0), |sum, number| sum + number - number);
        T::constant(f64::INFINITY) + sum
    }
}
