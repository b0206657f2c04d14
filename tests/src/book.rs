//! The code in the README and in the book, compiled and run as documentation tests.

#[cfg(doctest)]
#[doc = include_str!("../../README.md")]
mod readme {}
