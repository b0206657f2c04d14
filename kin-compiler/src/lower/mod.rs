//! Programs with every decision made: fused operations, calls for two directions at once, the terms of decisive
//! numbers, tests, candidates, and the order of evaluation.
//!
//! The writer of Rust and the machine of kin-live read only the result, so a program means the same to both.

mod doubt;
mod mechanism;
mod prepared;
mod statement;
mod steps;
mod value;
#[cfg(feature = "text")]
mod whole;

pub(crate) use mechanism::most_positions;
pub use mechanism::{Closure, ClosureTerm, EveryPosition, Form, Mechanism, Routine, UnitVector};
pub(crate) use prepared::Extent;
pub use statement::{Argument, Decisive, Label, Range, Selection, Statement};
pub(crate) use steps::Lowering;
pub use value::Value;
#[cfg(feature = "text")]
pub(crate) use whole::mechanism;
