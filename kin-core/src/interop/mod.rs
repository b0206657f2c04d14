//! Conversions to and from other crates, one optional dependency per file.

#[cfg(feature = "approx")]
mod approx;
#[cfg(feature = "nalgebra")]
mod nalgebra;
#[cfg(feature = "num-dual")]
mod num_dual;
