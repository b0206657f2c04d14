//! Solvers as data: recorded once, printed in other languages, run by themselves.
//!
//! A [`Tape`] is the solver of a mechanism as straight-line code. It is recorded by solving with a number that writes
//! down what is done with it, so it does what `solve` does, operation by operation. The choice between assemblies is an
//! argument, and so are the dimensions, unless they are folded in. A decision of the solver is a [`TapeCheck`] with its
//! margin, a block without a closed form is a [`NewtonSearch`], and a matrix whose pivots are chosen at run time is a
//! [`System`]. Who prints another language reads the [`structure`] of a tape.
//!
//! ```
//! use kin_core::library::SliderCrank;
//! use kin_core::tape::{self, Options};
//!
//! let tape = tape::record::<SliderCrank>(&Options::new().up_to(1))?;
//! println!("{tape}");
//! # Ok::<(), tape::RecordError>(())
//! ```

mod arrange;
mod body;
#[allow(clippy::format_push_string, reason = "a few kilobytes of text, piece by piece")]
mod c;
mod expression;
mod java_script;
mod node;
mod print;
mod python;
mod record;
mod recorded;
mod recorder;
mod recording;
mod run;
mod runtime;
mod signature;
mod spelling;
mod stages;
pub mod structure;
pub(crate) mod words;
mod writer;

#[cfg(test)]
mod printing_tests;
#[cfg(test)]
mod tests;

pub use c::C;
pub use java_script::JavaScriptNames;
pub use record::{Options, RecordError, record, record_with_sensitivities};
#[doc(hidden)]
pub use record::{Plain, RecordedFunctions, record_any, record_at};
pub use recorded::Recorded;
pub use run::Stop;
pub(crate) use structure::{
    Argument, Comparison, Condition, Constant, Function, LinearSolution, NewtonSearch, NumberType, Operator, ResultOf,
    Role, System, TapeCheck, TapeNode, TapeStep, Value,
};

/// The tape of a declared mechanism: see [`structure::Tape`].
pub type Tape = structure::Tape<'static>;
