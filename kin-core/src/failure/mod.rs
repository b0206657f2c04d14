//! The failures of a solver, in numbers and words.

mod error;
mod inputs;

pub use error::{Failure, SolveError};
pub use inputs::InputValues;
