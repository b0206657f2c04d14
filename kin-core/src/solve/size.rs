//! The size of a mechanism.

use crate::solve::Scalar;
use crate::solve::check::LargestLength;

/// The largest magnitude of some lengths, or 1 if all of them are zero. Lengths of the mechanism are compared with it.
///
/// ```
/// use kin_core::solve;
///
/// assert_eq!(solve::largest([3.0, -5.0]), 5.0);
/// assert_eq!(solve::largest::<f64, 0>([]), 1.0);
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
#[must_use]
pub fn largest<T: Scalar, const N: usize>(lengths: [T; N]) -> T {
    T::measured(LargestLength(lengths))
}
