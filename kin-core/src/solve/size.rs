//! How large things are.

use crate::solve::Scalar;
use crate::solve::check::LargestLength;

/// The largest magnitude of some lengths: what a length of the mechanism is compared with. 1 if all of them are zero.
///
/// ```
/// use kin_core::solve;
///
/// assert_eq!(solve::largest([3.0, -5.0]), 5.0);
/// assert_eq!(solve::largest::<f64, 0>([]), 1.0);
/// ```
#[inline(always)]
#[must_use]
pub fn largest<T: Scalar, const N: usize>(lengths: [T; N]) -> T {
    T::measured(LargestLength(lengths))
}
