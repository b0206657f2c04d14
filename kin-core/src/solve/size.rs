//! How large things are.

/// The largest magnitude of some lengths: what a length of the mechanism is compared with. 1 if all of them are zero.
///
/// ```
/// use kin_core::solve;
///
/// assert_eq!(solve::largest(&[3.0, -5.0]), 5.0);
/// assert_eq!(solve::largest(&[]), 1.0);
/// ```
#[must_use]
pub fn largest(lengths: &[f64]) -> f64 {
    let largest = lengths
        .iter()
        .fold(0.0_f64, |largest, length| largest.max(length.abs()));
    if largest > 0.0 { largest } else { 1.0 }
}
