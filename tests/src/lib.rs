//! Proof of kin.

pub mod batches;
mod book;
pub mod calls;
pub mod carrier;
pub mod compare;
pub mod counting;
pub mod growth;
pub mod mechanisms;
pub mod nested;
pub mod notes;
pub mod oracles;
pub mod random;
pub mod reference;
pub mod samples;
pub mod sensitivities;
