//! The question that a file or a person at the terminal asks of a mechanism: its dimensions, the motion of its inputs,
//! its assembly and its loads, each as typed, with its unit.

mod assembly;
pub(crate) mod columns;
pub(crate) mod document;
pub(crate) mod fault;
pub(crate) mod file;
mod functions;
pub(crate) mod language;
pub(crate) mod loads;
pub(crate) mod motion;
#[cfg(feature = "program")]
mod oracles;
pub(crate) mod page;
pub(crate) mod subject;
pub(crate) mod text;
mod typed;
pub(crate) mod units;
pub(crate) mod value;

pub(crate) use typed::{Case, Known, Typed};
