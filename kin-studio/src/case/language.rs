//! Solvers in other languages, as files.

use kin_core::tape::structure::Tape;

/// A language into which solvers are translated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "program", derive(clap::ValueEnum))]
pub enum Language {
    /// C99, in two files and an example
    C,
    /// A JavaScript module
    #[cfg_attr(feature = "program", value(name = "js", alias = "javascript"))]
    JavaScript,
    /// A Python module for NumPy arrays
    #[cfg_attr(feature = "program", value(alias = "numpy", alias = "py"))]
    Python,
}

/// The file of the example in C. Many people's programs have one of this name.
pub(crate) const EXAMPLE: &str = "main.c";

/// The files of a solver, each with its name.
pub(crate) fn files(tape: &Tape<'_>, language: Language) -> Vec<(String, String)> {
    let c = tape.c();
    match language {
        Language::C => vec![
            (format!("{}.h", c.name), c.header),
            (format!("{}.c", c.name), c.source),
            (EXAMPLE.to_owned(), c.example),
        ],
        Language::JavaScript => vec![(format!("{}.mjs", c.name), tape.java_script())],
        Language::Python => vec![(format!("{}.py", c.name), tape.python())],
    }
}
