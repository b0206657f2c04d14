//! The texts that people read: the chapters of the book, with their programs.

mod chapters;
mod examples;
#[cfg(feature = "other-crates")]
mod forward_dynamics;
#[cfg(feature = "other-crates")]
mod free_fall;
mod laws;
