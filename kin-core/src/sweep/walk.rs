//! The way from one pose of a sweep to the next, on which angles continue.
//!
//! A solver returns an angle in -π ..= π, and an output computed from such an angle jumps where the angle does. A walk unwraps them: it
//! predicts each angle from the rates at both ends of a step, and takes the turn nearest to the prediction. A step is too long if the
//! prediction is too coarse to tell turns apart; then the walk halves it. So no angle depends on the number of rows.

use alloc::vec::Vec;

use num_traits::Float;

use super::course::{AnyCourse, angles};
use super::footing::{Footing, LONGEST};
use crate::failure::{Failure, InputValues, SolveError};
use crate::number::Values;
use crate::track::TrackError;

/// The halvings that one step may take.
const MOST: usize = 256;

/// The end of a circuit of a coupled block, or the place where it was lost.
#[derive(Clone)]
pub(crate) struct Gap {
    block: &'static str,
    inputs: Values,
    /// The failure of the rows beyond, if the block may close there: the tracker gave up, and its place is no limit.
    lost: Option<Failure>,
}

/// A place on the way: the last pose, and the end of the circuit if it has been passed.
#[derive(Clone)]
pub(crate) struct Walk {
    pub(crate) last: Option<Footing>,
    /// A place behind the last pose at which the mechanism does not close.
    pub(super) open: Option<f64>,
    pub(super) gap: Option<Gap>,
}

impl Walk {
    pub(crate) const BEGINNING: Self = Self {
        last: None,
        open: None,
        gap: None,
    };

    /// A walk that goes on from a pose.
    pub(crate) fn from(last: Footing) -> Self {
        Self {
            last: Some(last),
            ..Self::BEGINNING
        }
    }

    /// The pose at a value of the variable, whose inputs have the given motions. A place that does not close leaves the walk where it was.
    ///
    /// Where an input turns far, the walk looks for gaps on the way.
    pub(crate) fn step(&mut self, course: &AnyCourse<'_>, at: f64, motions: &[f64]) -> Result<&Footing, SolveError> {
        // where it has come, whether or not the mechanism closes there
        if let Some(from) = self.open.or(self.last.as_ref().map(|last| last.at)) {
            let steps = Float::ceil(longest_way(course, &course.motions(from), motions) / LONGEST);
            let mut step = 1.0;
            while step < steps {
                let way = from + (at - from) * (step / steps);
                let _ = self.hop(course, way, &course.motions(way));
                step += 1.0;
            }
        }
        self.hop(course, at, motions)
    }

    fn hop(&mut self, course: &AnyCourse<'_>, at: f64, motions: &[f64]) -> Result<&Footing, SolveError> {
        let last = self.last.take();
        let reached = match &last {
            None => self.begin(course, at, motions),
            Some(last) => {
                let mut budget = MOST;
                match self.open {
                    Some(open) if course.has_assemblies() => self.across(course, last, open, at, motions, &mut budget),
                    _ => self.advance(course, last, at, motions, &mut budget),
                }
            }
        };
        match reached {
            Ok(reached) => {
                self.open = None;
                Ok(self.last.insert(reached))
            }
            Err(error) => {
                (self.last, self.open) = (last, Some(at));
                Err(error)
            }
        }
    }

    /// The first pose. If the mechanism did not close before, its angles follow from those where it begins to close.
    fn begin(&mut self, course: &AnyCourse<'_>, at: f64, motions: &[f64]) -> Result<Footing, SolveError> {
        let reached = Footing::new(course, at, course.solved(motions)?);
        let Some(open) = self.open.filter(|_| course.has_assemblies()) else {
            return Ok(reached);
        };
        let first = course.edge(at, open);
        let beginning = Footing::new(course, first, course.solved(&course.motions(first))?);
        let mut budget = MOST;
        self.advance(course, &beginning, at, motions, &mut budget)
    }

    /// The pose behind a gap. Each angle at the far edge of the gap is on the turn nearest to that at its near edge.
    fn across(
        &mut self,
        course: &AnyCourse<'_>,
        from: &Footing,
        open: f64,
        at: f64,
        motions: &[f64],
        budget: &mut usize,
    ) -> Result<Footing, SolveError> {
        // the most likely failure first
        course.solved(motions)?;
        let near = course.edge(from.at, open);
        let near = self.advance(course, from, near, &course.motions(near), budget);
        let near = near.unwrap_or_else(|_| from.clone()).without_rates();
        let far = course.edge(at, open);
        let beyond = course.motions(far);
        let far = unwrapped(
            course,
            Footing::new(course, far, course.solved(&beyond)?),
            &beyond,
            &near,
        );
        self.advance(course, &far, at, motions, budget)
    }

    /// The pose that follows from another one, by steps short enough to unwrap every angle.
    fn advance(
        &mut self,
        course: &AnyCourse<'_>,
        from: &Footing,
        at: f64,
        motions: &[f64],
        budget: &mut usize,
    ) -> Result<Footing, SolveError> {
        let mut reached = self.leap(course, from, at, motions)?;
        let middle = f64::midpoint(from.at, at);
        if reached.follows(from) {
            return Ok(reached);
        }
        if *budget == 0 || middle == from.at || middle == at {
            reached.has_jumped = true;
            return Ok(reached);
        }
        *budget -= 1;
        match self.advance(course, from, middle, &course.motions(middle), budget) {
            Ok(between) => {
                let mut reached = self.advance(course, &between, at, motions, budget)?;
                reached.has_jumped |= between.has_jumped;
                Ok(reached)
            }
            Err(error) if !course.has_assemblies() => Err(error),
            Err(_) => self.across(course, from, middle, at, motions, budget),
        }
    }

    /// The pose that follows from another one by a single step.
    fn leap(
        &mut self,
        course: &AnyCourse<'_>,
        from: &Footing,
        at: f64,
        motions: &[f64],
    ) -> Result<Footing, SolveError> {
        if course.has_assemblies() {
            let reached = Footing::new(course, at, course.solved(motions)?);
            return Ok(unwrapped(course, reached, motions, from));
        }
        let inputs = course.values(motions);
        if let Some(gap) = &self.gap {
            return Err(beyond(course, gap, &inputs));
        }
        let start = from.inputs();
        let found = course
            .mechanism
            .track_between(&course.parameters, &start, &from.unknowns(), &inputs);
        let unknowns = found.map_err(|error| {
            let (gap, failure) = stopped(course, &error, start, &inputs);
            self.gap = Some(gap);
            failure
        })?;
        let mut reached = Footing::new(course, at, course.solved_near(motions, &unknowns)?);
        reached.set_unknowns(&unknowns);
        reached.unwrap_outputs(from);
        reached.near = Some(unknowns.as_slice().into());
        Ok(reached)
    }
}

/// The same pose with the angles that follow from those of another one.
fn unwrapped(course: &AnyCourse<'_>, mut reached: Footing, motions: &[f64], from: &Footing) -> Footing {
    if reached.unwrap_unknowns(from) {
        // What depends on an angle itself, as the position of a rack does, depends on its turn.
        let near = reached.near(from);
        if let Ok(numbers) = course.solved_near(motions, &near) {
            let mut turned = Footing::new(course, reached.at, numbers);
            turned.unwrap_unknowns(from);
            // Where two assemblies meet, the solver may return the other one. Within a loop, a gear of half the speed exchanges their names.
            let inputs = course.values(motions);
            let own = course
                .mechanism
                .assembly_near(&course.parameters, &inputs, &turned.unknowns());
            if own == course.assembly() || (turned.unknowns_follow(from) && !reached.unknowns_follow(from)) {
                turned.near = Some(near);
                reached = turned;
            }
        }
    }
    reached.unwrap_outputs(from);
    reached
}

/// The largest change of an angle that is an input.
fn longest_way(course: &AnyCourse<'_>, from: &[f64], to: &[f64]) -> f64 {
    let orders = course.orders();
    let ways = angles(course.description.inputs).map(|input| (to[input * orders] - from[input * orders]).abs());
    ways.fold(0.0, f64::max)
}

/// The place where a track has stopped, and the error of the row behind it.
fn stopped(
    course: &AnyCourse<'_>,
    error: &TrackError<Vec<f64>, Vec<f64>>,
    from: Values,
    inputs: &[f64],
) -> (Gap, SolveError) {
    let blocks = course.description.blocks;
    match error {
        TrackError::Limit(obstacle) | TrackError::ChangePoint(obstacle) | TrackError::Unbounded(obstacle) => {
            let gap = Gap {
                block: obstacle.block,
                inputs: obstacle.inputs.as_slice().into(),
                lost: None,
            };
            let failure = beyond(course, &gap, inputs);
            (gap, failure)
        }
        TrackError::TooManySteps(halt) | TrackError::Lost(halt) => {
            let mut residuals = Values::splat(halt.unknowns.len(), 0.0);
            course
                .mechanism
                .residuals(&course.parameters, inputs, &halt.unknowns, &mut residuals);
            let largest = |largest: f64, residual: &f64| largest.max(residual.abs());
            let gap = Gap {
                block: blocks.last().map_or("", |block| block.unknowns),
                inputs: halt.inputs.as_slice().into(),
                lost: Some(Failure::NotConverged {
                    residual: residuals.iter().fold(0.0, largest),
                    iterations: halt.steps,
                    // a tracker has many Jacobians
                    condition: f64::NAN,
                }),
            };
            let failure = beyond(course, &gap, inputs);
            (gap, failure)
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
fn beyond(course: &AnyCourse<'_>, gap: &Gap, inputs: &[f64]) -> SolveError {
    let ways = inputs.iter().zip(gap.inputs.iter());
    let distance = ways.fold(0.0, |distance: f64, (input, end)| distance.max((input - end).abs()));
    let failure = gap.lost.unwrap_or(Failure::OutOfReach { margin: -distance });
    failure.at(gap.block, InputValues::new(course.description.inputs, inputs))
}
