//! The reasons why there is no report, or no page.

use std::error::Error;
use std::fmt;
use std::io;
use std::path::PathBuf;

use kin_core::sweep::SweepError;
use kin_core::{InputValues, SolveError};

/// The reason why there is no report, or why it cannot be read or written.
#[non_exhaustive]
pub enum ReportError {
    /// The mechanism closes nowhere: at no value of the moving input, or not where it was asked for.
    ClosesNowhere {
        /// The error at the value that was tried last.
        error: SolveError,
    },
    /// No position of coupled equations was found, anywhere along the moving input.
    NoPosition {
        /// The inputs that were asked for.
        inputs: InputValues,
    },
    /// A parameter or an input is not finite.
    NotFinite {
        /// The quantity, in a few words.
        quantity: String,
    },
    /// The speed of the moving input is zero, with which nothing moves.
    NoSpeed,
    /// The mechanism has no input with this name.
    NoSuchInput {
        /// The name that was given.
        name: String,
        /// The names of the inputs.
        inputs: Vec<String>,
    },
    /// The mechanism has no unknown or output with this name.
    NoSuchQuantity {
        /// The name that was given.
        name: String,
        /// The names of the unknowns and outputs.
        quantities: Vec<String>,
    },
    /// The range of the moving input is empty.
    NoRange {
        /// Its start.
        from: f64,
        /// Its end.
        to: f64,
    },
    /// The two points between which the inputs would move are the same.
    NoWay {
        /// The inputs there.
        inputs: InputValues,
    },
    /// A wish about the motion beside another wish that already determines the motion.
    SaidTwice {
        /// The wish without an effect.
        wish: &'static str,
        /// The wish that determines the motion.
        beside: &'static str,
    },
    /// The inputs cannot move so: a law jumps.
    Motion(SweepError),
    /// The derivatives that a law writes are not those of its value.
    NotSmooth {
        /// The input.
        input: String,
        /// The time near which the derivatives differ.
        at: f64,
    },
    /// The laws have more pieces than a page can hold.
    TooManyPieces {
        /// The largest number of pieces.
        most: usize,
    },
    /// A report that was written by an earlier version, in another format.
    OlderFormat {
        /// The version of its format.
        found: u32,
        /// The version that this crate reads.
        known: u32,
    },
    /// A report that was written by a later version.
    NewerFormat {
        /// The version of its format.
        found: u32,
        /// The version that this crate reads.
        known: u32,
    },
    /// A text that is no report.
    Json(serde_json::Error),
    /// A file that cannot be written.
    File {
        /// Its path.
        path: PathBuf,
        /// The error of the file system.
        error: io::Error,
    },
}

impl fmt::Display for ReportError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ClosesNowhere { error } => write!(formatter, "the mechanism does not close: {error}"),
            Self::NoPosition { inputs } => write!(
                formatter,
                "the mechanism does not close at {inputs}: no position was found; change dimensions or inputs"
            ),
            Self::NotFinite { quantity } => write!(formatter, "{quantity} is not finite: give a number"),
            Self::NoSpeed => formatter.write_str(
                "the speed of the moving input is zero, with which nothing moves: give a positive or negative one, or \
                 none for 1",
            ),
            Self::NoSuchInput { name, inputs } => {
                write!(formatter, "no input is called `{name}`: there is {}", listed(inputs))
            }
            Self::NoSuchQuantity { name, quantities } => {
                write!(
                    formatter,
                    "no unknown or output is called `{name}`: there is {}",
                    listed(quantities)
                )
            }
            Self::NoRange { from, to } => write!(
                formatter,
                "the motion would go from {from} to {to}: give a range with the smaller number first"
            ),
            Self::NoWay { inputs } => write!(
                formatter,
                "nothing moves between two points that are the same, {inputs}: give `between` two different ones"
            ),
            Self::SaidTwice { wish, beside } => write!(
                formatter,
                "`{wish}` has no effect beside `{beside}`, which determines how all inputs move: leave one of them out"
            ),
            Self::Motion(error) => write!(formatter, "the inputs cannot move so: {error}"),
            Self::NotSmooth { input, at } => write!(
                formatter,
                "the derivatives that the law of `{input}` writes near the time {at} are not those of one smooth \
                 function: let it have a piece for each formula, and derivatives to the order 16"
            ),
            Self::TooManyPieces { most } => write!(
                formatter,
                "within the range the laws have more than {most} pieces, which a page cannot hold: give a shorter range"
            ),
            Self::OlderFormat { found, known } => write!(
                formatter,
                "the report has the format {found}, and this version of kin reads the format {known}: make the report \
                 again"
            ),
            Self::NewerFormat { found, known } => write!(
                formatter,
                "the report has the format {found}, and this version of kin reads formats up to {known}: use a later \
                 version"
            ),
            Self::Json(error) => write!(formatter, "this is no report: {error}"),
            Self::File { path, error } => write!(formatter, "{} cannot be written: {error}", path.display()),
        }
    }
}

fn listed(names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match quoted.as_slice() {
        [] => "none".to_owned(),
        [only] => only.clone(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    }
}

kin_core::__debug_by_display!(ReportError);

impl Error for ReportError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::ClosesNowhere { error } => Some(error),
            Self::Motion(error) => Some(error),
            Self::Json(error) => Some(error),
            Self::File { error, .. } => Some(error),
            _ => None,
        }
    }
}

impl From<serde_json::Error> for ReportError {
    fn from(error: serde_json::Error) -> Self {
        Self::Json(error)
    }
}
