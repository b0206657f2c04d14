//! Declarations as texts, compared with the mechanisms that rustc compiled, to the last bit.

mod agreement;
mod batches;
mod bits;
mod library;
mod own;
mod random;
mod sheets;
mod solvers;
mod tapes;
