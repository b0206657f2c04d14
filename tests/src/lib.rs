//! Proof of kin.

mod book;
pub mod compare;
pub mod mechanisms;
pub mod notes;
pub mod oracles;
pub mod random;
pub mod reference;
pub mod sensitivities;
