//! The reasons why a track ended.

use core::fmt::Display;

use serde::ser::{Serialize, Serializer};

use super::lenient::{self, Lenient};
use super::solve_error::Message;
use crate::failure::SolveError;
use crate::quantity::Name;
use crate::track::{TrackError, TrackLimit, TrackStop};

/// The values of a row, of which the unknowns near a pole may overflow.
struct Values<'a>(&'a [f64]);

impl Serialize for Values<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.iter().map(|value| Lenient(*value)))
    }
}

#[derive(serde::Serialize)]
#[serde(rename = "TrackLimit")]
struct ObstacleForm<'a> {
    block: Name,
    #[serde(serialize_with = "lenient::serialize")]
    fraction: f64,
    inputs: Values<'a>,
    unknowns: Values<'a>,
}

#[derive(serde::Serialize)]
#[serde(rename = "TrackStop")]
struct HaltForm<'a> {
    steps: u32,
    #[serde(serialize_with = "lenient::serialize")]
    fraction: f64,
    inputs: Values<'a>,
    unknowns: Values<'a>,
    #[serde(serialize_with = "lenient::serialize")]
    rounding: f64,
}

#[derive(serde::Serialize)]
enum Reason<'a> {
    TurningPoint(ObstacleForm<'a>),
    ChangePoint(ObstacleForm<'a>),
    Pole(ObstacleForm<'a>),
    TooManySteps(HaltForm<'a>),
    Lost(HaltForm<'a>),
    Failed(SolveError),
}

#[derive(serde::Serialize)]
#[serde(rename = "TrackError")]
struct Form<'a, M: Display> {
    reason: Reason<'a>,
    message: Message<M>,
}

fn obstacle<I: AsRef<[f64]>, U: AsRef<[f64]>>(obstacle: &TrackLimit<I, U>) -> ObstacleForm<'_> {
    ObstacleForm {
        block: obstacle.block,
        fraction: obstacle.fraction,
        inputs: Values(obstacle.inputs.as_ref()),
        unknowns: Values(obstacle.unknowns.as_ref()),
    }
}

fn halt<I: AsRef<[f64]>, U: AsRef<[f64]>>(halt: &TrackStop<I, U>) -> HaltForm<'_> {
    HaltForm {
        steps: halt.steps,
        fraction: halt.fraction,
        inputs: Values(halt.inputs.as_ref()),
        unknowns: Values(halt.unknowns.as_ref()),
        rounding: halt.rounding,
    }
}

/// The reason with its numbers, and the message.
impl<I: AsRef<[f64]>, U: AsRef<[f64]>> Serialize for TrackError<I, U> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let reason = match self {
            Self::TurningPoint(limit) => Reason::TurningPoint(obstacle(limit)),
            Self::ChangePoint(point) => Reason::ChangePoint(obstacle(point)),
            Self::Pole(pole) => Reason::Pole(obstacle(pole)),
            Self::TooManySteps(last) => Reason::TooManySteps(halt(last)),
            Self::Lost(last) => Reason::Lost(halt(last)),
            Self::Failed(error) => Reason::Failed(*error),
        };
        let message = Message(self);
        Form { reason, message }.serialize(serializer)
    }
}
