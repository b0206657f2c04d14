//! What keeps the file of another program from being read.

use std::error::Error;
use std::fmt;

/// What keeps the file of another program from being read. The message of `Display` says where, and what to do.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum ForeignError {
    /// The text is in none of the known formats.
    Unknown,
    /// The text, or what it lists, is larger than any drawing.
    TooLarge(String),
    /// The text ends or goes wrong at a place of it.
    Syntax {
        /// The line, from 1.
        line: usize,
        /// The column, from 1.
        column: usize,
        /// What is wrong there.
        message: String,
    },
    /// Another version of the program wrote the file.
    Version(String),
    /// A part has no entry that it needs, or an entry of another kind.
    Entry {
        /// The part.
        part: String,
        /// What the part needs.
        message: String,
    },
    /// A part names another one that is not in the file.
    Missing {
        /// The part that names it.
        part: String,
        /// What is missing.
        missing: String,
    },
    /// Two parts have one name.
    Twice(String),
    /// A number is not finite, or no number.
    Number {
        /// The part.
        part: String,
        /// The number as it stands in the file.
        number: String,
    },
    /// Without this part nothing moves as in the other program, and a drawing has nothing like it.
    Unsupported {
        /// The part.
        part: String,
        /// What to do instead.
        advice: String,
    },
}

impl fmt::Display for ForeignError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown => f.write_str(
                "the format is not known: kin reads the JSON of pylinkage, addresses of PMKS+, the text of PMKS, and \
                 `.linkage2` files",
            ),
            Self::TooLarge(message) | Self::Version(message) => f.write_str(message),
            Self::Syntax { line, column, message } => write!(
                f,
                "line {line}, column {column}: {message}; the file may be cut off: save it again"
            ),
            Self::Entry { part, message } => write!(f, "{part} {message}"),
            Self::Missing { part, missing } => {
                write!(
                    f,
                    "{part} names {missing}, which is not in the file: save the file again"
                )
            }
            Self::Twice(part) => write!(f, "{part} is in the file twice: give the second another name"),
            Self::Number { part, number } => {
                write!(
                    f,
                    "{part} has `{number}`, which is no finite number: correct it in the program that wrote it"
                )
            }
            Self::Unsupported { part, advice } => write!(f, "{part} has no counterpart in kin: {advice}"),
        }
    }
}

impl Error for ForeignError {}
