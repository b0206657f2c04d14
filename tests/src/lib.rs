//! Proof of kin.

mod book;
pub mod notes;
