//! The reasons why no exact table could be made.

use alloc::boxed::Box;
use alloc::string::String;
use core::error::Error;
use core::fmt;

use super::error::ReadError;
use crate::failure::SolveError;
use crate::quantity::Digits;
use crate::sweep::SweepError;

/// The reason why there is no exact table of a motion.
#[derive(Clone, PartialEq)]
#[non_exhaustive]
pub enum ExactTableError {
    /// The sweep itself is at fault.
    Sweep(SweepError),
    /// The range has no length.
    NoRange {
        /// The parameter at which it begins and ends.
        at: f64,
    },
    /// The table shall end with the values, and its pieces need a derivative.
    Order {
        /// The highest order that was asked for.
        asked: usize,
    },
    /// The first rows of the table are more than it may have.
    MoreRows {
        /// The largest number of rows allowed.
        most: usize,
        /// The number of the first rows.
        rows: usize,
    },
    /// A tolerance is not a positive number.
    Tolerance {
        /// Its order.
        order: usize,
        /// Its value.
        tolerance: f64,
    },
    /// The mechanism does not close somewhere in the range, or is too close to a limit there.
    NotClosed {
        /// The parameter.
        at: f64,
        /// The reason.
        error: Box<SolveError>,
    },
    /// The pieces do not agree with the poses within the tolerance, and there may be no more rows, or more rows make it
    /// worse.
    Unreached {
        /// The column that deviates most, as a part of its tolerance.
        column: String,
        /// The order of its derivative.
        order: usize,
        /// The parameter.
        at: f64,
        /// Twice the difference there.
        error: f64,
        /// The error that is allowed, in the unit of the column.
        allowed: f64,
        /// The number of rows that were made.
        rows: usize,
        /// Whether it is rounding that is in the way, and not the number of rows.
        is_rounding: bool,
    },
    /// Branches of the motion cross here, and geometry does not determine which one the mechanism follows.
    ChangePoint {
        /// The input.
        input: f64,
    },
    /// The curve of the motion could not be followed any further, or has no end.
    Lost {
        /// The input at the last point.
        input: f64,
        /// The length of the curve up to there.
        length: f64,
    },
    /// The table contradicts itself, for example because of a name that a table cannot hold.
    Read(ReadError),
}

impl From<SweepError> for ExactTableError {
    fn from(error: SweepError) -> Self {
        Self::Sweep(error)
    }
}

impl From<ReadError> for ExactTableError {
    fn from(error: ReadError) -> Self {
        Self::Read(error)
    }
}

impl fmt::Display for ExactTableError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sweep(error) => write!(formatter, "{error}"),
            Self::NoRange { at } => write!(
                formatter,
                "the range begins and ends at {}: give a range with a length",
                Digits(*at)
            ),
            Self::Order { asked } => write!(
                formatter,
                "the table shall end with order {asked}, and its pieces need a derivative: end it with order 1 or a \
                 higher one"
            ),
            Self::MoreRows { most, rows } => write!(
                formatter,
                "the table begins with {rows} rows, and it may have {most}: allow more rows, or give the sweep fewer"
            ),
            Self::Tolerance { order, tolerance } => write!(
                formatter,
                "the tolerance of order {order} is {tolerance}: give a positive number"
            ),
            Self::NotClosed { at, error } => write!(
                formatter,
                "at {}: {error}; end the range short of it, or let `exact_circuit` lead the table through the limit",
                Digits(*at)
            ),
            Self::Unreached {
                column,
                order,
                at,
                error,
                allowed,
                rows,
                is_rounding,
            } => {
                write!(
                    formatter,
                    "with {rows} rows, the derivative of order {order} of {column} has the error {} at {}, and {} is \
                     allowed: ",
                    Digits(*error),
                    Digits(*at),
                    Digits(*allowed)
                )?;
                formatter.write_str(if *is_rounding {
                    "rounding is in the way, so allow a larger error in this order, or end the table with a lower one"
                } else {
                    "allow more rows, or a larger error"
                })
            }
            Self::ChangePoint { input } => write!(
                formatter,
                "branches of the motion cross at the input {}: change a dimension, or end the range short of it",
                Digits(*input)
            ),
            Self::Lost { input, length } => write!(
                formatter,
                "the motion does not come back to its start: it was followed over the length {} up to the input {}",
                Digits(*length),
                Digits(*input)
            ),
            Self::Read(error) => write!(formatter, "{error}"),
        }
    }
}

crate::__debug_by_display!(ExactTableError);

impl Error for ExactTableError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Sweep(error) => Some(error),
            Self::NotClosed { error, .. } => Some(&**error),
            Self::Read(error) => Some(error),
            _ => None,
        }
    }
}
