//! The number of samples that a test draws.

/// All of them with the environment variable `KIN_EVERY_CASE`, which `.ci/run samples` sets, and a tenth without it.
pub(crate) fn of(every: u32) -> u32 {
    if are_all() { every } else { every.div_ceil(10) }
}

/// All of them with that variable, and so many without it: for tests of which a tenth still takes many seconds.
pub(crate) fn some_of(some: u32, every: u32) -> u32 {
    if are_all() { every } else { some }
}

/// Whether tests draw all samples.
pub(crate) fn are_all() -> bool {
    std::env::var_os("KIN_EVERY_CASE").is_some()
}
