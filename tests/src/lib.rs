//! Proof of kin.

pub mod mechanisms;
pub mod notes;
pub mod oracles;
pub mod random;
