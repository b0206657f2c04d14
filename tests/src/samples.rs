//! The number of samples that a test draws.

/// The number of samples that the feature `every-case` asks for, or a tenth of it.
///
/// ```
/// assert!([40, 400].contains(&kin_tests::samples::of(400)));
/// ```
#[must_use]
pub const fn of(every: usize) -> usize {
    if cfg!(feature = "every-case") {
        every
    } else {
        every.div_ceil(10)
    }
}
