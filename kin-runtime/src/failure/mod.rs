//! The failures of a solver, in numbers and words.

mod error;
mod input_names;
mod inputs;

pub use error::{Failure, SolveError};
#[doc(hidden)]
pub use input_names::InputNames;
pub use inputs::InputValues;
