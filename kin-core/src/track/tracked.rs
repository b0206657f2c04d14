//! A track of a mechanism without its type.

use alloc::vec::Vec;

use super::{Halt, Obstacle, TrackError, track};
use crate::any::{AnyMechanism, Of};
use crate::mechanism::Mechanism;
use crate::number::Row;

/// What a track needs of a mechanism.
pub trait Tracked: AnyMechanism {
    /// Moves the mechanism on a straight line of inputs. See [`track`](crate::track()).
    ///
    /// # Errors
    /// Those of `track`.
    fn track_between(
        &self,
        parameters: &[f64],
        from: &[f64],
        unknowns: &[f64],
        to: &[f64],
    ) -> Result<Vec<f64>, TrackError<Vec<f64>, Vec<f64>>>;
}

impl<M: Mechanism<Scalar = f64>> Tracked for Of<M> {
    fn track_between(
        &self,
        parameters: &[f64],
        from: &[f64],
        unknowns: &[f64],
        to: &[f64],
    ) -> Result<Vec<f64>, TrackError<Vec<f64>, Vec<f64>>> {
        let mechanism = M::from_parameters(Row::from_fn(|index| parameters[index]));
        let inputs = |values: &[f64]| M::Inputs::from_fn(|index| values[index]);
        let near = Row::from_fn(|index| unknowns[index]);
        let found = track(&mechanism, inputs(from), near, inputs(to));
        let obstacle = |obstacle: Obstacle<M::Inputs<f64>, M::Unknowns<f64>>| Obstacle {
            block: obstacle.block,
            fraction: obstacle.fraction,
            inputs: obstacle.inputs.as_ref().to_vec(),
            unknowns: obstacle.unknowns.as_ref().to_vec(),
            names: obstacle.names,
        };
        let halt = |halt: Halt<M::Inputs<f64>, M::Unknowns<f64>>| Halt {
            steps: halt.steps,
            fraction: halt.fraction,
            inputs: halt.inputs.as_ref().to_vec(),
            unknowns: halt.unknowns.as_ref().to_vec(),
            rounding: halt.rounding,
            names: halt.names,
        };
        found.map(|found| found.as_ref().to_vec()).map_err(|error| match error {
            TrackError::Limit(limit) => TrackError::Limit(obstacle(limit)),
            TrackError::ChangePoint(point) => TrackError::ChangePoint(obstacle(point)),
            TrackError::Unbounded(pole) => TrackError::Unbounded(obstacle(pole)),
            TrackError::TooManySteps(place) => TrackError::TooManySteps(halt(place)),
            TrackError::Lost(place) => TrackError::Lost(halt(place)),
            TrackError::Failed(error) => TrackError::Failed(error),
        })
    }
}
