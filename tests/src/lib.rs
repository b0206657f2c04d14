//! Proof of kin.

pub mod notes;
