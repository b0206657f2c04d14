//! The way from one pose of a sweep to the next.

use core::f64::consts::{PI, TAU};

use num_traits::Float;

use super::drive::InputMotions;
use crate::failure::{Failure, InputValues, SolveError};
use crate::mechanism::{Mechanism, Pose};
use crate::number::Row;
use crate::quantity::Dimension;
use crate::track::{TrackError, TrackErrorOf, track};

/// The end of a circuit of a coupled block, or the place where it was lost.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gap<M: Mechanism> {
    block: &'static str,
    inputs: M::Inputs<f64>,
    /// The failure of the rows beyond, if the block may close there: the tracker gave up, and its place is no limit.
    lost: Option<Failure>,
}

/// A place on the way: the last pose, and the end of the circuit if it has been passed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Walk<M: Mechanism> {
    /// The inputs and the unknowns of the last pose, with angles on the turns they have reached.
    pub(crate) last: Option<(M::Inputs<f64>, M::Unknowns<f64>)>,
    pub(crate) gap: Option<Gap<M>>,
}

/// A pose, and its unknowns with angles on the turns they have reached.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reached<M: Mechanism> {
    pub(crate) pose: M::Pose,
    pub(crate) unknowns: M::Unknowns<f64>,
}

impl<M: Mechanism<Scalar = f64>> Walk<M> {
    pub(crate) const BEGINNING: Self = Self { last: None, gap: None };

    /// The pose at the next place of the inputs. A place that does not close leaves the walk where it was.
    pub(crate) fn step(
        &mut self,
        mechanism: &M,
        assembly: M::Assembly,
        motions: InputMotions<M, f64>,
    ) -> Result<Reached<M>, SolveError> {
        let inputs = M::Inputs::from_fn(|input| motions[input][0]);
        let reached = match self.last {
            None => of(mechanism.solve_motion(motions, assembly)?),
            Some(last) if M::ASSEMBLY_COUNT > 0 => {
                continued::<M>(mechanism, motions, mechanism.solve_motion(motions, assembly)?, last.1)
            }
            Some(last) => {
                if let Some(gap) = self.gap {
                    return Err(beyond::<M>(gap, inputs));
                }
                let unknowns = track(mechanism, last.0, last.1, inputs).map_err(|error| {
                    let (gap, failure) = stopped(mechanism, &error, last.0, inputs);
                    self.gap = Some(gap);
                    failure
                })?;
                let pose = mechanism.solve_motion_near(motions, unknowns)?;
                Reached { pose, unknowns }
            }
        };
        self.last = Some((inputs, reached.unknowns));
        Ok(reached)
    }
}

fn of<M: Mechanism<Scalar = f64>>(pose: M::Pose) -> Reached<M> {
    let motions = pose.unknown_motions();
    Reached {
        pose,
        unknowns: Row::from_fn(|unknown| motions[unknown][0]),
    }
}

/// The pose with its angles on the turns closest to those of the last pose.
fn continued<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    motions: InputMotions<M, f64>,
    pose: M::Pose,
    last: M::Unknowns<f64>,
) -> Reached<M> {
    let mut reached = of::<M>(pose);
    let mut is_turned = false;
    for (unknown, quantity) in M::DESCRIPTION.unknowns.iter().enumerate() {
        let angle = &mut reached.unknowns[unknown];
        if quantity.dimension == Dimension::Angle && (*angle - last[unknown]).abs() > PI {
            *angle = nearest_turn(*angle, last[unknown]);
            is_turned = true;
        }
    }
    if is_turned {
        // The solvers place the angles themselves. Where two assemblies meet they may take the other one, which shows.
        if let Ok(turned) = mechanism.solve_motion_near(motions, reached.unknowns) {
            let near = turned.unknown_motions_near(Row::from_fn(|unknown| reached.unknowns[unknown]));
            let is_same = (0..M::DESCRIPTION.unknowns.len()).all(|unknown| {
                let (one, other) = (near[unknown][0], reached.unknowns[unknown]);
                (one - other).abs() <= 1e-9 * one.abs().max(1.0)
            });
            if is_same {
                reached.pose = turned;
            }
        }
    }
    reached
}

/// The angle on the turn closest to another angle.
pub(super) fn nearest_turn(angle: f64, near: f64) -> f64 {
    let turns = Float::round((near - angle) / TAU);
    if turns == 0.0 { angle } else { angle + turns * TAU }
}

/// The place where a track has stopped, and the error of the row behind it.
fn stopped<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    error: &TrackErrorOf<M>,
    from: M::Inputs<f64>,
    inputs: M::Inputs<f64>,
) -> (Gap<M>, SolveError) {
    let coupled = M::DESCRIPTION.blocks.last().map_or("", |block| block.unknowns);
    match error {
        TrackError::Limit(obstacle) | TrackError::ChangePoint(obstacle) | TrackError::Unbounded(obstacle) => {
            let gap = Gap {
                block: obstacle.block,
                inputs: obstacle.inputs,
                lost: None,
            };
            (gap, beyond::<M>(gap, inputs))
        }
        TrackError::TooManySteps(halt) | TrackError::Lost(halt) => {
            let residuals = mechanism.residuals(inputs, halt.unknowns);
            let largest = |largest: f64, residual: &f64| largest.max(residual.abs());
            let gap = Gap {
                block: coupled,
                inputs: halt.inputs,
                lost: Some(Failure::NotConverged {
                    residual: residuals.as_ref().iter().fold(0.0, largest),
                    iterations: halt.steps,
                    // a tracker has many Jacobians
                    condition: f64::NAN,
                }),
            };
            (gap, beyond::<M>(gap, inputs))
        }
        TrackError::Failed(failure) => {
            let mut place = from;
            for (input, (_, value)) in failure.inputs.iter().enumerate() {
                place[input] = value;
            }
            let gap = Gap {
                block: failure.block,
                inputs: place,
                lost: None,
            };
            (gap, *failure)
        }
    }
}

/// The error of a row beyond the end of its circuit. Its margin is the distance of the inputs to that end, unless the end is not known.
fn beyond<M: Mechanism<Scalar = f64>>(gap: Gap<M>, inputs: M::Inputs<f64>) -> SolveError {
    let ways = inputs.as_ref().iter().zip(gap.inputs.as_ref());
    let distance = ways.fold(0.0, |distance: f64, (input, end)| distance.max((input - end).abs()));
    let failure = gap.lost.unwrap_or(Failure::OutOfReach { margin: -distance });
    failure.at(gap.block, InputValues::new(M::DESCRIPTION.inputs, inputs.as_ref()))
}
