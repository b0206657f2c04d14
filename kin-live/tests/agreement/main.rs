//! Declarations as texts, compared with the mechanisms that rustc compiled, to the last bit.

mod constructs;
mod library;
mod proofs;
mod tapes;
