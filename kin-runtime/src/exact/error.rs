//! The reasons why bytes are no table, and why a parameter is in no table.

use core::error::Error;
use core::fmt;

use crate::quantity::Digits;

/// The reason why bytes or parts are no exact table.
#[derive(Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum ReadError {
    /// The first bytes are not those of an exact table.
    NotATable,
    /// The table was written by a newer version, in a format that this version does not know.
    Newer {
        /// The version of the format.
        found: u32,
        /// The newest version that is known here.
        known: u32,
    },
    /// The number of bytes is not the one that the head announces.
    Length {
        /// The number of bytes announced; `u64::MAX` if it is larger than any number of bytes.
        expected: u64,
        /// The number of bytes given.
        found: u64,
    },
    /// The bytes do not have the sum that was stored with them.
    Checksum {
        /// The sum that was stored.
        stored: u64,
        /// The sum of the bytes.
        found: u64,
    },
    /// The table contradicts itself.
    Contradiction {
        /// What is wrong, in a few words.
        what: &'static str,
    },
}

impl fmt::Display for ReadError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotATable => formatter.write_str("these bytes are no exact table: they do not begin with `kinExact`"),
            Self::Newer { found, known } => write!(
                formatter,
                "the exact table has version {found} of its format, and this version of kin reads versions up to \
                 {known}: read it with a newer version, or write it again"
            ),
            Self::Length { expected, found } => write!(
                formatter,
                "the exact table is damaged: its head announces {expected} bytes, and there are {found}"
            ),
            Self::Checksum { stored, found } => write!(
                formatter,
                "the exact table is damaged: its bytes have the sum {found:#018x}, and {stored:#018x} is stored with \
                 them"
            ),
            Self::Contradiction { what } => write!(formatter, "the exact table contradicts itself: {what}"),
        }
    }
}

crate::__debug_by_display!(ReadError);

impl Error for ReadError {}

/// The reason why a table has no number at a parameter.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum LookupError {
    /// The parameter is beyond the table, which does not repeat itself, or it is not finite.
    Beyond {
        /// The parameter.
        at: f64,
        /// The first and the last parameter of the table.
        range: [f64; 2],
    },
    /// The parameter is so many periods away from the table, which repeats itself, that numbers of its size do not
    /// distinguish one part of a period from another.
    TooManyPeriods {
        /// The parameter.
        at: f64,
        /// The period of the table.
        period: f64,
    },
    /// The speed is not finite.
    Speed {
        /// The speed.
        speed: f64,
    },
    /// More orders were asked for than the table has.
    Orders {
        /// The highest order that was asked for.
        asked: usize,
        /// The highest order of the table.
        order: usize,
    },
    /// The row for the result has another length than the columns need.
    Room {
        /// The number of numbers that are needed.
        needed: usize,
        /// The number given.
        given: usize,
    },
}

impl fmt::Display for LookupError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Beyond { at, range: [low, high] } => write!(
                formatter,
                "{} is not in the table, which runs from {} to {}",
                Digits(*at),
                Digits(*low),
                Digits(*high)
            ),
            Self::TooManyPeriods { at, period } => write!(
                formatter,
                "{} is so far from the table, which repeats itself after {}, that its part of a period cannot be \
                 determined: leave whole periods out",
                Digits(*at),
                Digits(*period)
            ),
            Self::Speed { speed } => write!(formatter, "the speed is {speed}: give a finite number"),
            Self::Orders { asked, order } => write!(
                formatter,
                "the table ends with the derivative of order {order}, and order {asked} is asked for"
            ),
            Self::Room { needed, given } => write!(
                formatter,
                "the columns of the table have {needed} numbers for one parameter, and there is room for {given}"
            ),
        }
    }
}

crate::__debug_by_display!(LookupError);

impl Error for LookupError {}
