//! Proof of kin.

mod book;
pub mod mechanisms;
pub mod notes;
pub mod oracles;
pub mod random;
