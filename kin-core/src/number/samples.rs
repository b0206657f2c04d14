//! The number of samples that a test draws.

/// All of them with the environment variable `KIN_EVERY_CASE`, which `.ci/run` sets, and a quarter of them without it.
pub(crate) fn of(every: u32) -> u32 {
    if std::env::var_os("KIN_EVERY_CASE").is_some() {
        every
    } else {
        every.div_ceil(4)
    }
}
