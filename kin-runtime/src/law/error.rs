//! The reasons why there is no such law.

use core::error::Error;
use core::fmt;

use crate::number::Number;
use crate::quantity::Digits;

/// The reason why a law cannot be made.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum LawError {
    /// A quantity that must be positive is not, or is not finite.
    NotPositive {
        /// The quantity, in a few words.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// A quantity is NaN or infinite.
    NotFinite {
        /// The quantity, in a few words.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// The shares of a law's duration are negative, or make more than the whole.
    Shares {
        /// The least of the shares.
        least: f64,
        /// Their sum.
        sum: f64,
    },
    /// The numbers are so far apart that a result is zero or infinite in the number type.
    OutOfRange {
        /// The result, in a few words.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// A motion within limits ends where it starts, which takes no time.
    NoMove {
        /// The value.
        value: f64,
    },
    /// A sequence has no laws.
    Empty,
}

impl fmt::Display for LawError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotPositive { quantity, value } => {
                write!(
                    formatter,
                    "the {quantity} is {}; it must be positive and finite",
                    Digits(value)
                )
            }
            Self::NotFinite { quantity, value } => {
                write!(formatter, "the {quantity} is {}; it must be finite", Digits(value))
            }
            Self::Shares { least, sum } => write!(
                formatter,
                "the least share of the duration is {} and the sum of the shares is {}; no share may be negative, and \
                 the sum may be 1 at most",
                Digits(least),
                Digits(sum)
            ),
            Self::OutOfRange { quantity, value } => write!(
                formatter,
                "the {quantity} becomes {}; choose units in which distance and limits are of a more similar size",
                Digits(value)
            ),
            Self::NoMove { value } => write!(
                formatter,
                "the S-curve starts and ends at {}, and no move takes no time: leave it out, or hold the value by a \
                 `Dwell`",
                Digits(value)
            ),
            Self::Empty => formatter.write_str("the sequence is empty; it needs one law at least"),
        }
    }
}

crate::__debug_by_display!(LawError);

impl Error for LawError {}

/// The number, if it is positive and finite.
pub(super) fn positive<T: Number>(quantity: &'static str, number: T) -> Result<T, LawError> {
    let value = number.real();
    if value > 0.0 && number.is_finite() {
        Ok(number)
    } else {
        Err(LawError::NotPositive { quantity, value })
    }
}

/// The number, if it is finite.
pub(super) fn finite<T: Number>(quantity: &'static str, number: T) -> Result<T, LawError> {
    if number.is_finite() {
        Ok(number)
    } else {
        Err(LawError::NotFinite {
            quantity,
            value: number.real(),
        })
    }
}
