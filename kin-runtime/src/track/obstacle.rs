//! The reasons why a track ends before its target.

use core::error::Error;
use core::fmt::{self, Debug};

use crate::curve::LimitKind;
use crate::failure::{InputNames, SolveError};
use crate::quantity::{Digits, Name};

/// The largest effect of rounding errors on the unknowns. Beyond it, nothing is certain about the neighbourhood.
pub(super) const FIRM: f64 = 1e-3;

/// A position on the track at which the motion ends or is not determined.
///
/// `I` and `U` are rows of the mechanism's inputs and unknowns: arrays of the declared lengths.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct TrackLimit<I, U> {
    /// The unknowns of the singular block, separated by commas.
    pub block: Name,
    /// The part of the track that has been covered, from 0 to 1.
    pub fraction: f64,
    /// The inputs at this position: radians for angles, the mechanism's unit for lengths.
    pub inputs: I,
    /// The unknowns at this position.
    pub unknowns: U,
    pub(super) names: InputNames,
}

/// The position where tracking stopped without a known obstacle.
///
/// `I` and `U` are rows of the mechanism's inputs and unknowns: arrays of the declared lengths.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct TrackStop<I, U> {
    /// The number of steps taken or tried.
    pub steps: u32,
    /// The part of the track that has been covered, from 0 to 1.
    pub fraction: f64,
    /// The inputs of the last position: radians for angles, the mechanism's unit for lengths.
    pub inputs: I,
    /// The unknowns of the last position.
    pub unknowns: U,
    /// The effect of rounding errors on the unknowns there: in radians for an angle, relative to its size for a length
    /// or a number.
    pub rounding: f64,
    pub(super) names: InputNames,
}

/// The reason why a track ended before the inputs reached their target.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum TrackError<I, U> {
    /// A limit position: two assemblies meet, and neither exists beyond it. The inputs can only reverse.
    ///
    /// In a plot of the solution over the inputs, the curve reverses there.
    TurningPoint(TrackLimit<I, U>),
    /// A change point: the assembly meets another one, and both continue. Geometry does not determine which one the
    /// mechanism follows.
    ///
    /// The position belongs to a mechanism whose dimensions may differ by rounding errors. If the gap between two
    /// assemblies is that small, nothing else is known about it.
    ChangePoint(TrackLimit<I, U>),
    /// A length or a number goes to infinity, for example where a slide becomes parallel to its guide.
    ///
    /// The inputs are those at the pole, the unknowns those of the last position before it.
    Pole(TrackLimit<I, U>),
    /// The track takes more than 100 000 steps. The error contains the last
    /// position, and another track may continue from there.
    TooManySteps(TrackStop<I, U>),
    /// No step, however short, certainly stays in the assembly, and no obstacle explains why. Rounding errors may move
    /// the unknowns by more than steps do, for example if the rounding of one link of a loop is as long as another
    /// link. If rounding moves them only a little, an unknown jumps, for example an angle declared by `atan2` that
    /// jumps by a revolution.
    Lost(TrackStop<I, U>),
    /// A position could not be found, at the start, or on the way for another reason.
    Failed(SolveError),
}

impl TrackError<(), ()> {
    /// The error at a position.
    pub(super) fn with_position<I, U>(self, inputs: I, unknowns: U) -> TrackError<I, U> {
        match self {
            Self::TurningPoint(limit) => TrackError::TurningPoint(limit.with_position(inputs, unknowns)),
            Self::ChangePoint(point) => TrackError::ChangePoint(point.with_position(inputs, unknowns)),
            Self::Pole(pole) => TrackError::Pole(pole.with_position(inputs, unknowns)),
            Self::TooManySteps(stop) => TrackError::TooManySteps(stop.with_position(inputs, unknowns)),
            Self::Lost(stop) => TrackError::Lost(stop.with_position(inputs, unknowns)),
            Self::Failed(error) => TrackError::Failed(error),
        }
    }
}

impl TrackLimit<(), ()> {
    fn with_position<I, U>(self, inputs: I, unknowns: U) -> TrackLimit<I, U> {
        TrackLimit {
            block: self.block,
            fraction: self.fraction,
            inputs,
            unknowns,
            names: self.names,
        }
    }
}

impl TrackStop<(), ()> {
    fn with_position<I, U>(self, inputs: I, unknowns: U) -> TrackStop<I, U> {
        TrackStop {
            steps: self.steps,
            fraction: self.fraction,
            inputs,
            unknowns,
            rounding: self.rounding,
            names: self.names,
        }
    }
}

impl<I, U> TrackError<I, U> {
    /// The kind of the limit at which the track has ended, and its position; `None` if it ended for another reason.
    ///
    /// The end of a domain or of a declared range is [`TrackError::Failed`], with the error of the first point beyond
    /// it.
    #[must_use]
    pub fn limit(&self) -> Option<(LimitKind, &TrackLimit<I, U>)> {
        match self {
            Self::TurningPoint(obstacle) => Some((LimitKind::TurningPoint, obstacle)),
            Self::ChangePoint(obstacle) => Some((LimitKind::ChangePoint, obstacle)),
            Self::Pole(obstacle) => Some((LimitKind::Pole, obstacle)),
            Self::TooManySteps(_) | Self::Lost(_) | Self::Failed(_) => None,
        }
    }
}

impl<I, U> From<SolveError> for TrackError<I, U> {
    fn from(error: SolveError) -> Self {
        Self::Failed(error)
    }
}

/// The position of an event, for use after its description.
struct Location<'a> {
    names: InputNames,
    inputs: &'a [f64],
    fraction: f64,
}

impl fmt::Display for Location<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        if !self.inputs.is_empty() {
            formatter.write_str(" at ")?;
            self.names.write(self.inputs, formatter)?;
        }
        write!(formatter, ", after {} of the way", Digits(self.fraction))
    }
}

impl<I: AsRef<[f64]>, U> TrackLimit<I, U> {
    fn location(&self) -> Location<'_> {
        Location {
            names: self.names,
            inputs: self.inputs.as_ref(),
            fraction: self.fraction,
        }
    }
}

impl<I: AsRef<[f64]>, U> TrackStop<I, U> {
    fn location(&self) -> Location<'_> {
        Location {
            names: self.names,
            inputs: self.inputs.as_ref(),
            fraction: self.fraction,
        }
    }
}

impl<I: AsRef<[f64]>, U> fmt::Display for TrackError<I, U> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TurningPoint(limit) => write!(
                formatter,
                "limit position of {}{}: two assemblies meet there and neither continues; stop short of it, or \
                 drive the mechanism by another input",
                limit.block,
                limit.location()
            ),
            Self::ChangePoint(point) => write!(
                formatter,
                "change point of {}{}: two assemblies cross there and geometry does not determine which one the \
                 mechanism follows; stop short of it, change the dimensions a little, or start again on the other side",
                point.block,
                point.location()
            ),
            Self::Pole(pole) => write!(
                formatter,
                "an unknown of {} runs to infinity{}; stop short of it, or drive the mechanism by another input",
                pole.block,
                pole.location()
            ),
            Self::TooManySteps(stop) => write!(
                formatter,
                "{} steps were not enough, the last ended{}; continue from there, or divide the motion into shorter \
                 ones",
                stop.steps,
                stop.location()
            ),
            Self::Lost(stop) if stop.rounding < FIRM => write!(
                formatter,
                "no step, however short, is certain to stay in the assembly{} and {} steps: an unknown jumps there, as \
                 an angle declared by atan2 jumps by a turn; stop short of it, and start again on the other side",
                stop.location(),
                stop.steps
            ),
            Self::Lost(stop) => write!(
                formatter,
                "no step, however short, is certain to stay in the assembly{} and {} steps: rounding errors may move \
                 the unknowns there by {} (radians, or parts of a length); use lengths in each loop that differ less",
                stop.location(),
                stop.steps,
                Digits(stop.rounding)
            ),
            Self::Failed(error) => write!(formatter, "{error}"),
        }
    }
}

// Format the slices, which every row has, so that code for any mechanism can unwrap a result.
impl<I: AsRef<[f64]>, U: AsRef<[f64]>> Debug for TrackLimit<I, U> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("TrackLimit")
            .field("block", &self.block)
            .field("fraction", &self.fraction)
            .field("inputs", &self.inputs.as_ref())
            .field("unknowns", &self.unknowns.as_ref())
            .finish_non_exhaustive()
    }
}

impl<I: AsRef<[f64]>, U: AsRef<[f64]>> Debug for TrackStop<I, U> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("TrackStop")
            .field("steps", &self.steps)
            .field("fraction", &self.fraction)
            .field("inputs", &self.inputs.as_ref())
            .field("unknowns", &self.unknowns.as_ref())
            .field("rounding", &self.rounding)
            .finish_non_exhaustive()
    }
}

crate::__debug_by_display!([I: AsRef<[f64]>, U] TrackError<I, U>);

impl<I: AsRef<[f64]>, U: AsRef<[f64]>> Error for TrackError<I, U> {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        // The message already contains the message of the failure.
        None
    }
}
