//! The texts that people read: the chapters of the book, and the messages about mistakes.

mod chapters;
mod examples;
#[cfg(feature = "other-crates")]
mod forward_dynamics;
#[cfg(feature = "other-crates")]
mod free_fall;
mod laws;
mod mistakes;
