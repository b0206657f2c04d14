//! How large things are.

use crate::solve::Scalar;

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
    T::constant_of(lengths, |lengths| {
        let largest = lengths
            .iter()
            .fold(0.0_f64, |largest, length| largest.max(length.abs()));
        if largest > 0.0 { largest } else { 1.0 }
    })
}
