//! Conversions to and from other crates, one optional dependency per file: nalgebra 0.35 and num-dual 0.15.
//!
//! Their types are part of the interface. Another minor version of theirs is another type, and an incompatible version
//! of this crate.

#[cfg(feature = "approx")]
mod approx;
#[cfg(feature = "nalgebra")]
mod nalgebra;
#[cfg(feature = "num-dual")]
mod num_dual;
