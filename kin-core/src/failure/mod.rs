//! The failures of a solver, in numbers and words.

pub(crate) mod digits;
mod error;
mod inputs;

pub use error::{Failure, SolveError};
pub use inputs::InputValues;
