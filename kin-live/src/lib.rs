//! Runs the declaration of a mechanism without the compiler of Rust.
//!
//! `kin-compiler` reads the text, and its data becomes flat code that calls the functions of `kin-core` in the order in
//! which generated code calls them. So the results are those of `kin_core::mechanism!` to the last bit, for every number
//! type.

#[doc(hidden)]
pub mod sheet;
