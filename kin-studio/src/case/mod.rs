//! The question that a file or a person at the terminal asks of a mechanism: its dimensions, the motion of its inputs,
//! its assembly and its loads, each as typed, with its unit.

mod assembly;
pub(crate) mod columns;
mod design;
mod document;
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

pub use document::Document;
pub use language::Language;

/// The text of a `.kin` file as `kin fmt` writes it.
///
/// # Errors
/// Every mistake of a text whose statements cannot be told apart, each with its line under this name.
pub fn formatted(text: &str, name: &str) -> Result<String, String> {
    file::formatted(text, name)
}

/// The names of the units that a number can have, as in `45mm`.
pub fn unit_names() -> impl Iterator<Item = &'static str> {
    units::names()
}
