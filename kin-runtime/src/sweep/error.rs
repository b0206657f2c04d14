//! The mistakes that end a sweep as a whole.

use core::error::Error;
use core::fmt;

use crate::batch::LengthMismatch;
use crate::quantity::{Digits, Name, WithUnit};

/// The reason why there is no table.
///
/// A mechanism that does not close is none: its rows say by how much.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum SweepError {
    /// An end of the range is not finite.
    NotFinite {
        /// The quantity at fault, in a few words.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// The tolerance of an adaptive table is not a positive, finite number.
    Tolerance {
        /// Its value.
        value: f64,
    },
    /// The speed is zero, with which the inputs do not move.
    NoSpeed,
    /// The value of a motion law jumps inside of the sweep.
    Jump {
        /// The input.
        input: Name,
        /// Whether it is an angle.
        is_angle: bool,
        /// The time.
        at: f64,
        /// The jump of the value.
        by: f64,
    },
    /// A sweep of no rows.
    NoRows,
    /// A column whose length differs from the number of rows.
    Columns(LengthMismatch),
    /// The sweep itself has more rows than its adaptive table may have.
    MoreRows {
        /// The largest number of rows allowed.
        most: usize,
        /// The number of rows of the sweep.
        rows: usize,
    },
    /// The rows towards a limit where the mechanism begins or ceases to close are not as dense as they shall be, and
    /// there may be no more.
    TooManyRowsAtLimit {
        /// The largest number of rows allowed.
        most: usize,
        /// The variable where the next row was needed.
        at: f64,
    },
    /// The straight lines between the rows are not within the tolerance, and there may be no more rows.
    TooManyRows {
        /// The largest number of rows allowed.
        most: usize,
        /// The variable where the next row was needed.
        at: f64,
        /// The column that deviates most there.
        column: Name,
        /// The order of that column.
        order: usize,
        /// The deviation of the straight line there, as a part of the column's range.
        deviation: f64,
    },
}

impl From<LengthMismatch> for SweepError {
    fn from(mismatch: LengthMismatch) -> Self {
        Self::Columns(mismatch)
    }
}

impl fmt::Display for SweepError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { quantity, value } => {
                write!(
                    formatter,
                    "the {quantity} of the sweep is {value}: give a finite number"
                )
            }
            Self::Tolerance { value } => write!(
                formatter,
                "the tolerance of the adaptive table is {value}: give a positive, finite number"
            ),
            Self::NoSpeed => formatter.write_str(
                "the speed of the sweep is zero, with which the inputs do not move: give a positive or negative one, \
                 or none for 1",
            ),
            Self::Jump {
                input,
                is_angle,
                at,
                by,
            } => write!(
                formatter,
                "the law of {input} jumps by {} at the time {}, and no mechanism does: let each law begin where the \
                 one before ends",
                WithUnit {
                    value: *by,
                    is_angle: *is_angle
                },
                Digits(*at)
            ),
            Self::NoRows => formatter.write_str("the sweep has no rows: give two or more"),
            Self::MoreRows { most, rows } => write!(
                formatter,
                "the sweep has {rows} rows, and its adaptive table may have {most}: allow more rows, or give the sweep \
                 fewer"
            ),
            Self::Columns(mismatch) => write!(formatter, "{mismatch}"),
            Self::TooManyRowsAtLimit { most, at } => write!(
                formatter,
                "{most} rows are not enough: the mechanism begins or ceases to close near {}, and the rows are to be \
                 denser there; allow more rows, or end the sweep short of it",
                Digits(*at)
            ),
            Self::TooManyRows {
                most,
                at,
                column,
                order,
                deviation,
            } => write!(
                formatter,
                "{most} rows are not enough: at {} the derivative of order {order} of {column} deviates from the \
                 straight line between its neighbours by {} of its range; allow more rows or a larger tolerance, or \
                 read fewer orders",
                Digits(*at),
                Digits(*deviation)
            ),
        }
    }
}

crate::__debug_by_display!(SweepError);

impl Error for SweepError {}
