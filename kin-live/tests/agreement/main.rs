//! Declarations as texts, compared with the mechanisms that rustc compiled, to the last bit.

mod library;
mod own;
mod proofs;
mod tapes;
