//! Why a mechanism cannot be tracked to where it is wanted.

use core::error::Error;
use core::fmt::{self, Debug};

use crate::figures::Figures;
use crate::{Quantity, SolveError};

/// A position on the way at which the motion ends, or is not determined.
///
/// `I` and `U` are rows of the mechanism's inputs and unknowns: arrays, of the declared lengths.
#[derive(Clone, Copy, PartialEq)]
pub struct Obstacle<I, U> {
    /// The unknowns of the block that is singular, separated by commas.
    pub block: &'static str,
    /// The part of the way that has been covered, from 0 to 1.
    pub fraction: f64,
    /// The inputs there: radians for angles, the mechanism's own unit for lengths.
    pub inputs: I,
    /// The unknowns there.
    pub unknowns: U,
    /// What the inputs are.
    pub(super) names: &'static [Quantity],
}

/// Why tracking ended before the inputs were where they were wanted.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum TrackError<I, U> {
    /// A limit position: two assemblies meet, and beyond it there is neither. The inputs can only turn back.
    ///
    /// Where the solution is drawn over the inputs, its curve turns round there.
    Limit(Obstacle<I, U>),
    /// A change point: the assembly meets another one, and both go on. Which of them the mechanism follows is not a
    /// matter of geometry.
    ///
    /// The place is that of a mechanism whose dimensions may differ by rounding errors: where the gap between two
    /// assemblies is that small, nothing else is known of it.
    ChangePoint(Obstacle<I, U>),
    /// The position could not be found, at the beginning, or on the way for another reason.
    Failed(SolveError),
}

impl<I, U> From<SolveError> for TrackError<I, U> {
    fn from(error: SolveError) -> Self {
        Self::Failed(error)
    }
}

impl<I: AsRef<[f64]>, U> Obstacle<I, U> {
    fn place(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, (name, value)) in self.names.iter().zip(self.inputs.as_ref()).enumerate() {
            let before = if index == 0 { " at " } else { ", " };
            write!(formatter, "{before}{} = {}", name.name, Figures(*value))?;
        }
        write!(formatter, ", after {} of the way", Figures(self.fraction))
    }
}

impl<I: AsRef<[f64]>, U> fmt::Display for TrackError<I, U> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Limit(limit) => {
                write!(formatter, "{} reach a limit position", limit.block)?;
                limit.place(formatter)?;
                formatter.write_str(
                    ": two assemblies meet there and neither goes on; stop short of it, or drive the mechanism by \
                     another input",
                )
            }
            Self::ChangePoint(point) => {
                write!(formatter, "{} reach a change point", point.block)?;
                point.place(formatter)?;
                formatter.write_str(
                    ": two assemblies cross there and geometry does not say which one is followed; stop short of it, \
                     change the dimensions a little, or start again on the other side",
                )
            }
            Self::Failed(error) => write!(formatter, "{error}"),
        }
    }
}

// By the slices, which every row has, so that code for any mechanism can unwrap a result.
impl<I: AsRef<[f64]>, U: AsRef<[f64]>> Debug for Obstacle<I, U> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Obstacle")
            .field("block", &self.block)
            .field("fraction", &self.fraction)
            .field("inputs", &self.inputs.as_ref())
            .field("unknowns", &self.unknowns.as_ref())
            .finish_non_exhaustive()
    }
}

impl<I: AsRef<[f64]>, U: AsRef<[f64]>> Debug for TrackError<I, U> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Limit(limit) => formatter.debug_tuple("Limit").field(limit).finish(),
            Self::ChangePoint(point) => formatter.debug_tuple("ChangePoint").field(point).finish(),
            Self::Failed(error) => formatter.debug_tuple("Failed").field(error).finish(),
        }
    }
}

impl<I: AsRef<[f64]>, U: AsRef<[f64]>> Error for TrackError<I, U> {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        // The message already holds that of the failure.
        None
    }
}
