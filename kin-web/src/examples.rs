//! The mechanisms of the library as files that can be changed.

use kin_studio::library::DESIGNS;
use serde::Serialize;

/// A file with its name.
#[derive(Clone, Debug, Serialize)]
pub struct Example {
    /// The name of the mechanism.
    pub name: &'static str,
    /// The text of the file.
    pub text: String,
}

/// All mechanisms of the library, in the order of the book's table.
pub(crate) fn examples() -> Vec<Example> {
    let example = |design: &kin_studio::library::Design| Example {
        name: design.name,
        text: design.file(),
    };
    DESIGNS.iter().map(example).collect()
}
