//! Proof of kin.

// Documentation tests need the book alone. The mechanisms would be expanded once more for them.

#[cfg(not(doctest))]
pub mod batches;
mod book;
#[cfg(not(doctest))]
pub mod calls;
#[cfg(not(doctest))]
pub mod carrier;
#[cfg(not(doctest))]
pub mod compare;
#[cfg(not(doctest))]
pub mod counting;
#[cfg(not(doctest))]
pub mod growth;
#[cfg(not(doctest))]
pub mod mechanisms;
#[cfg(not(doctest))]
pub mod nested;
#[cfg(not(doctest))]
pub mod notes;
#[cfg(not(doctest))]
pub mod oracles;
#[cfg(not(doctest))]
pub mod random;
#[cfg(not(doctest))]
pub mod reference;
pub mod samples;
#[cfg(not(doctest))]
pub mod sensitivities;
