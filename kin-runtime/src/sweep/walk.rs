//! The way from one pose of a sweep to the next, on which angles continue.
//!
//! A solver returns an angle in -π ..= π, and an output computed from such an angle jumps where the angle does. A walk
//! unwraps them: it predicts each angle from the rates at both ends of a step, and unwraps it to the prediction. A step
//! is too long if the prediction is too coarse to distinguish revolutions; then the walk halves it. So no angle depends
//! on the number of rows.

use alloc::rc::Rc;
use alloc::vec::Vec;
use core::mem::take;

use num_traits::Float;

use super::footing::{Footing, LONGEST_INPUT_STEP};
use super::untyped::{UntypedSweep, angles};
use crate::failure::{Failure, InputValues, SolveError};
use crate::number::NumberRow;
use crate::quantity::{Name, NameKind};
use crate::track::{TrackError, track_between};

/// The halvings that one step may take.
const MOST_HALVINGS: usize = 256;

/// The end of a circuit of a coupled block, or the point where it was lost.
pub(crate) struct Gap {
    block: Name,
    inputs: NumberRow,
    /// The failure of the rows beyond, if the block may close there: the tracker gave up, and its end is no limit.
    lost: Option<Failure>,
}

/// A point on the way: the last pose, and the end of the circuit if it has been passed.
#[derive(Clone)]
pub(crate) struct Walk<'c> {
    pub(crate) last: Option<Footing<'c>>,
    /// A point behind the last pose at which the mechanism does not close.
    pub(super) unclosed: Option<f64>,
    pub(super) gap: Option<Rc<Gap>>,
    /// A point with the numbers of its pose, if they are known in the assembly and need not be solved again.
    pub(super) known: Option<(f64, Vec<f64>)>,
    /// Memory for the numbers of the next pose.
    pub(super) spare: Vec<f64>,
}

impl<'c> Walk<'c> {
    pub(crate) const BEGINNING: Self = Self {
        last: None,
        unclosed: None,
        gap: None,
        known: None,
        spare: Vec::new(),
    };

    /// A walk that goes on from a pose.
    pub(crate) fn from(last: Footing<'c>) -> Self {
        Self {
            last: Some(last),
            ..Self::BEGINNING
        }
    }

    /// The pose at a value of the variable, whose inputs have the given motions. A point that does not close leaves the
    /// walk where it was.
    ///
    /// Where an input moves far, the walk looks for gaps on the way.
    pub(crate) fn step(
        &mut self,
        sweep: &UntypedSweep<'c>,
        at: f64,
        motions: &[f64],
    ) -> Result<&Footing<'c>, SolveError> {
        let (from, steps) = self.steps(sweep, motions);
        let mut step = 1.0;
        while step < steps {
            let way = from + (at - from) * (step / steps);
            let _ = self.hop(sweep, way, &sweep.motions(way));
            step += 1.0;
        }
        self.hop(sweep, at, motions)
    }

    /// The walk that is one [`step`](Self::step) further, and whether the mechanism closes there.
    pub(crate) fn stepped(&self, sweep: &UntypedSweep<'c>, at: f64, motions: &[f64]) -> (Self, Result<(), SolveError>) {
        if self.steps(sweep, motions).1 > 1.0 {
            let mut walk = self.clone();
            let result = walk.step(sweep, at, motions).map(|_| ());
            return (walk, result);
        }
        let mut walk = Self {
            unclosed: self.unclosed,
            gap: self.gap.clone(),
            ..Self::BEGINNING
        };
        let result = match walk.reach(sweep, self.last.as_ref(), at, motions) {
            Ok(reached) => {
                (walk.last, walk.unclosed) = (Some(reached), None);
                Ok(())
            }
            Err(error) => {
                (walk.last, walk.unclosed) = (self.last.clone(), Some(at));
                Err(error)
            }
        };
        (walk, result)
    }

    /// Where the walk has come, whether or not the mechanism closes there, and the number of steps in which no input
    /// moves far.
    fn steps(&self, sweep: &UntypedSweep<'c>, motions: &[f64]) -> (f64, f64) {
        let from = match (self.unclosed, &self.last) {
            (None, None) => return (0.0, 1.0),
            (None, Some(last)) if last.is_near(motions, sweep.orders()) => return (last.at, 1.0),
            (None, Some(last)) => last.at,
            (Some(unclosed), _) => unclosed,
        };
        let way = longest_way(sweep, &sweep.inputs(from), motions);
        (from, Float::ceil(way / LONGEST_INPUT_STEP))
    }

    fn hop(&mut self, sweep: &UntypedSweep<'c>, at: f64, motions: &[f64]) -> Result<&Footing<'c>, SolveError> {
        let last = self.last.take();
        match self.reach(sweep, last.as_ref(), at, motions) {
            Ok(reached) => {
                self.unclosed = None;
                self.spare = last.map(|last| last.numbers).unwrap_or_default();
                Ok(self.last.insert(reached))
            }
            Err(error) => {
                (self.last, self.unclosed) = (last, Some(at));
                Err(error)
            }
        }
    }

    fn reach(
        &mut self,
        sweep: &UntypedSweep<'c>,
        last: Option<&Footing<'c>>,
        at: f64,
        motions: &[f64],
    ) -> Result<Footing<'c>, SolveError> {
        let Some(last) = last else {
            return self.begin(sweep, at, motions);
        };
        let mut budget = MOST_HALVINGS;
        match self.unclosed {
            Some(unclosed) if sweep.has_assemblies() => self.across(sweep, last, unclosed, at, motions, &mut budget),
            _ => self.advance(sweep, last, at, motions, &mut budget),
        }
    }

    /// The pose in the assembly of the sweep, with the angles that it returns.
    fn solved(&mut self, sweep: &UntypedSweep<'c>, at: f64, motions: &[f64]) -> Result<Footing<'c>, SolveError> {
        let numbers = match self.known.take_if(|(known, _)| *known == at) {
            Some((_, numbers)) => numbers,
            None => sweep.solved(motions, take(&mut self.spare))?,
        };
        Ok(Footing::new(sweep, at, numbers))
    }

    /// The first pose. If the mechanism did not close before, its angles follow from those where it begins to close.
    fn begin(&mut self, sweep: &UntypedSweep<'c>, at: f64, motions: &[f64]) -> Result<Footing<'c>, SolveError> {
        let reached = self.solved(sweep, at, motions)?;
        let Some(unclosed) = self.unclosed.filter(|_| sweep.has_assemblies()) else {
            return Ok(reached);
        };
        let first = sweep.edge(at, unclosed);
        let beginning = self.solved(sweep, first, &sweep.motions(first))?;
        let mut budget = MOST_HALVINGS;
        self.advance(sweep, &beginning, at, motions, &mut budget)
    }

    /// The pose behind a gap. Each angle at the far edge of the gap is unwrapped to that at its near edge.
    fn across(
        &mut self,
        sweep: &UntypedSweep<'c>,
        from: &Footing<'c>,
        unclosed: f64,
        at: f64,
        motions: &[f64],
        budget: &mut usize,
    ) -> Result<Footing<'c>, SolveError> {
        // the most likely failure first
        self.solved(sweep, at, motions)?;
        let near = sweep.edge(from.at, unclosed);
        let near = self.advance(sweep, from, near, &sweep.motions(near), budget);
        let near = near.unwrap_or_else(|_| from.clone()).without_rates();
        let far = sweep.edge(at, unclosed);
        let beyond = sweep.motions(far);
        let far = self.solved(sweep, far, &beyond)?;
        let (far, _) = unwrapped(sweep, far, &beyond, &near);
        self.advance(sweep, &far, at, motions, budget)
    }

    /// The pose that follows from another one, by steps short enough to unwrap every angle.
    fn advance(
        &mut self,
        sweep: &UntypedSweep<'c>,
        from: &Footing<'c>,
        at: f64,
        motions: &[f64],
        budget: &mut usize,
    ) -> Result<Footing<'c>, SolveError> {
        let (mut reached, follows) = self.leap(sweep, from, at, motions)?;
        let middle = f64::midpoint(from.at, at);
        if follows && reached.inputs_follow(from) {
            return Ok(reached);
        }
        if *budget == 0 || middle == from.at || middle == at {
            reached.has_jumped = true;
            return Ok(reached);
        }
        *budget -= 1;
        match self.advance(sweep, from, middle, &sweep.motions(middle), budget) {
            Ok(between) => {
                let mut reached = self.advance(sweep, &between, at, motions, budget)?;
                reached.has_jumped |= between.has_jumped;
                Ok(reached)
            }
            Err(error) if !sweep.has_assemblies() => Err(error),
            Err(_) => self.across(sweep, from, middle, at, motions, budget),
        }
    }

    /// The pose that follows from another one by a single step, and whether the angles of its results do.
    fn leap(
        &mut self,
        sweep: &UntypedSweep<'c>,
        from: &Footing<'c>,
        at: f64,
        motions: &[f64],
    ) -> Result<(Footing<'c>, bool), SolveError> {
        if sweep.has_assemblies() {
            let reached = self.solved(sweep, at, motions)?;
            return Ok(unwrapped(sweep, reached, motions, from));
        }
        let inputs = sweep.values(motions);
        if let Some(gap) = &self.gap {
            return Err(beyond(sweep, gap, &inputs));
        }
        let start = from.inputs();
        let near = from.unknowns();
        let found = track_between(sweep.mechanism, &sweep.parameters, &start, &near, &inputs);
        let unknowns = found.map_err(|error| {
            let (gap, failure) = stopped(sweep, &error, start, &inputs);
            self.gap = Some(Rc::new(gap));
            failure
        })?;
        let numbers = sweep.solved_near(motions, &unknowns, take(&mut self.spare))?;
        let mut reached = Footing::new(sweep, at, numbers);
        reached.set_unknowns(&unknowns);
        let follows = reached.unknowns_follow(from) & reached.unwrap_outputs(from).follows;
        reached.near = Some(unknowns);
        Ok((reached, follows))
    }
}

/// The same pose with the angles that follow from those of another one, and whether the revolutions of all of them are
/// certain.
fn unwrapped<'c>(
    sweep: &UntypedSweep<'c>,
    mut reached: Footing<'c>,
    motions: &[f64],
    from: &Footing<'c>,
) -> (Footing<'c>, bool) {
    let mut unknowns = reached.unwrap_unknowns(from);
    if unknowns.has_moved {
        // What depends on an angle itself, as the position of a rack does, depends on its revolution.
        let near = reached.near(from);
        if let Ok(numbers) = sweep.solved_near(motions, &near, Vec::new()) {
            let mut again = Footing::new(sweep, reached.at, numbers);
            let unwrapping = again.unwrap_unknowns(from);
            // Where two assemblies meet, the solver may return the other one. Within a loop, a gear of half the speed
            // exchanges their names: only a short step that both rates predict well distinguishes the two cases.
            let continues = unwrapping.is_sure && again.inputs_follow(from);
            let inputs = sweep.values(motions);
            let assembly = sweep
                .mechanism
                .assembly_at(&sweep.parameters, &inputs, &again.unknowns());
            if assembly == sweep.assembly.index() || (continues && !unknowns.follows) {
                again.near = Some(near);
                (reached, unknowns) = (again, unwrapping);
            }
        }
    }
    let outputs = reached.unwrap_outputs(from);
    (reached, unknowns.follows && outputs.follows)
}

/// The largest change of an angle that is an input.
fn longest_way(sweep: &UntypedSweep<'_>, from: &[f64], motions: &[f64]) -> f64 {
    let orders = sweep.orders();
    let ways = angles(sweep.description.inputs).map(|input| (motions[input * orders] - from[input]).abs());
    ways.fold(0.0, f64::max)
}

/// The point where a track has stopped, and the error of the row behind it.
fn stopped(
    sweep: &UntypedSweep<'_>,
    error: &TrackError<Vec<f64>, Vec<f64>>,
    from: NumberRow,
    inputs: &[f64],
) -> (Gap, SolveError) {
    let last = sweep.description.blocks.len().saturating_sub(1);
    match error {
        TrackError::TurningPoint(obstacle) | TrackError::ChangePoint(obstacle) | TrackError::Pole(obstacle) => {
            let gap = Gap {
                block: obstacle.block,
                inputs: obstacle.inputs.as_slice().into(),
                lost: None,
            };
            let failure = beyond(sweep, &gap, inputs);
            (gap, failure)
        }
        TrackError::TooManySteps(stop) | TrackError::Lost(stop) => {
            let mut residuals = NumberRow::splat(stop.unknowns.len(), 0.0);
            sweep
                .mechanism
                .closure(&sweep.parameters, inputs, &stop.unknowns, &mut residuals);
            let largest = |largest: f64, residual: &f64| largest.max(residual.abs());
            let gap = Gap {
                block: sweep.mechanism.name(NameKind::Block, last),
                inputs: stop.inputs.as_slice().into(),
                lost: Some(Failure::NotConverged {
                    residual: residuals.iter().fold(0.0, largest),
                    iterations: stop.steps,
                    // a tracker has many Jacobians
                    condition: f64::NAN,
                }),
            };
            let failure = beyond(sweep, &gap, inputs);
            (gap, failure)
        }
        TrackError::Failed(failure) => {
            let mut inputs = from;
            for (input, (_, value)) in failure.inputs.iter().enumerate() {
                inputs[input] = value;
            }
            let gap = Gap {
                block: failure.block,
                inputs,
                lost: None,
            };
            (gap, *failure)
        }
    }
}

/// The error of a row beyond the end of its circuit. Its margin is the distance of the inputs to that end, unless the
/// end is not known.
fn beyond(sweep: &UntypedSweep<'_>, gap: &Gap, inputs: &[f64]) -> SolveError {
    let ways = inputs.iter().zip(gap.inputs.iter());
    let distance = ways.fold(0.0, |distance: f64, (input, end)| distance.max((input - end).abs()));
    let failure = gap.lost.unwrap_or(Failure::OutOfReach { margin: -distance });
    failure.at(gap.block, InputValues::of(sweep.mechanism.input_names(), inputs))
}
