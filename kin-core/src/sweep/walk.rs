//! The way from one pose of a sweep to the next, on which angles continue.
//!
//! A solver returns an angle in -π ..= π, and an output computed from such an angle jumps where the angle does. A walk unwraps them: it
//! predicts each angle from the rates at both ends of a step, and takes the turn nearest to the prediction. A step is too long if the
//! prediction is too coarse to tell turns apart; then the walk halves it. So no angle depends on the number of rows.

use core::f64::consts::{FRAC_PI_2, TAU};

use num_traits::Float;

use super::Course;
use super::drive::{Drive, InputMotions, Variable};
use crate::failure::{Failure, InputValues, SolveError};
use crate::mechanism::{Mechanism, Pose};
use crate::number::Row;
use crate::quantity::{Dimension, Quantity};
use crate::track::{TrackError, TrackErrorOf, track};

/// The longest step of an angle that is an input.
pub(super) const LONGEST: f64 = 1.0;
/// The largest difference between an angle and its prediction from the rates at both ends of a step. Half a turn would be ambiguous.
pub(super) const PREDICTION: f64 = 1.0;
/// The largest change that rates may predict: next to a limit they are far too large.
pub(super) const LONGEST_PREDICTION: f64 = 2.0;
/// The largest step of an angle without rates.
pub(super) const WITHOUT_RATES: f64 = FRAC_PI_2;
/// The halvings that find the edge of a gap. Angles there differ from those at the limit by some 10⁻⁵.
const EDGE: usize = 32;
/// The part of a turn within which half a turn is ambiguous.
const AMBIGUOUS: f64 = 1e-6;
/// The halvings that one step may take.
const MOST: usize = 256;

/// The end of a circuit of a coupled block, or the place where it was lost.
#[derive(Clone, Copy)]
pub(crate) struct Gap<M: Mechanism> {
    block: &'static str,
    inputs: M::Inputs<f64>,
    /// The failure of the rows beyond, if the block may close there: the tracker gave up, and its place is no limit.
    lost: Option<Failure>,
}

/// A value for each scalar output of a mechanism.
pub(crate) type OutputsOf<M, V> = <<M as Mechanism>::Pose as Pose>::Outputs<V>;

/// The numbers of a pose from which a walk goes on, with unwrapped angles. Rates are those with respect to the variable of the sweep.
#[derive(Clone, Copy)]
pub(crate) struct Footing<M: Mechanism> {
    /// The variable of the sweep.
    pub(crate) at: f64,
    pub(crate) inputs: M::Inputs<f64>,
    pub(crate) unknowns: M::Unknowns<f64>,
    pub(crate) unknown_rates: M::Unknowns<f64>,
    pub(crate) outputs: OutputsOf<M, f64>,
    pub(crate) output_rates: OutputsOf<M, f64>,
}

/// A pose with its unwrapped angles.
#[derive(Clone, Copy)]
pub(crate) struct Reached<M: Mechanism> {
    pub(crate) pose: M::Pose,
    pub(crate) footing: Footing<M>,
    /// Whether an angle has changed in a way that its rates do not tell, although the steps were as short as can be.
    pub(crate) has_jumped: bool,
}

/// A place on the way: the last pose, and the end of the circuit if it has been passed.
#[derive(Clone, Copy)]
pub(crate) struct Walk<M: Mechanism> {
    pub(crate) last: Option<Footing<M>>,
    /// A place behind the last pose at which the mechanism does not close.
    pub(crate) open: Option<f64>,
    pub(crate) gap: Option<Gap<M>>,
}

impl<M: Mechanism<Scalar = f64>> Walk<M> {
    pub(crate) const BEGINNING: Self = Self {
        last: None,
        open: None,
        gap: None,
    };

    /// The pose at a value of the variable, whose inputs have the given motions. A place that does not close leaves the walk where it was.
    ///
    /// Where an input turns far, the walk looks for gaps on the way.
    pub(crate) fn step<D: Drive<M>>(
        &mut self,
        course: &Course<M, D>,
        at: f64,
        motions: InputMotions<M, f64>,
    ) -> Result<Reached<M>, SolveError> {
        // where it has come, whether or not the mechanism closes there
        if let Some(from) = self.open.or(self.last.map(|last| last.at)) {
            let inputs = values::<M>(course.drive.motions(from));
            let steps = Float::ceil(longest_way::<M>(&inputs, &values::<M>(motions)) / LONGEST);
            let mut step = 1.0;
            while step < steps {
                let way = from + (at - from) * (step / steps);
                let _ = self.hop(course, way, course.drive.motions(way));
                step += 1.0;
            }
        }
        self.hop(course, at, motions)
    }

    fn hop<D: Drive<M>>(
        &mut self,
        course: &Course<M, D>,
        at: f64,
        motions: InputMotions<M, f64>,
    ) -> Result<Reached<M>, SolveError> {
        let reached = match self.last {
            None => self.begin(course, at, motions),
            Some(last) => {
                let mut budget = MOST;
                match self.open {
                    Some(open) if M::ASSEMBLY_COUNT > 0 => self.across(course, &last, open, at, motions, &mut budget),
                    _ => self.advance(course, &last, at, motions, &mut budget),
                }
            }
        };
        match &reached {
            Ok(reached) => (self.last, self.open) = (Some(reached.footing), None),
            Err(_) => self.open = Some(at),
        }
        reached
    }

    /// The first pose. If the mechanism did not close before, its angles follow from those where it begins to close.
    fn begin<D: Drive<M>>(
        &mut self,
        course: &Course<M, D>,
        at: f64,
        motions: InputMotions<M, f64>,
    ) -> Result<Reached<M>, SolveError> {
        let pose = solved(course, motions)?;
        let reached = Reached::of(course, at, motions, pose);
        let Some(open) = self.open.filter(|_| M::ASSEMBLY_COUNT > 0) else {
            return Ok(reached);
        };
        let first = course.edge(at, open);
        let beginning = course.drive.motions(first);
        let pose = solved(course, beginning)?;
        let beginning = Reached::of(course, first, beginning, pose);
        let mut budget = MOST;
        self.advance(course, &beginning.footing, at, motions, &mut budget)
    }

    /// The pose behind a gap. Each angle at the far edge of the gap is on the turn nearest to that at its near edge.
    fn across<D: Drive<M>>(
        &mut self,
        course: &Course<M, D>,
        from: &Footing<M>,
        open: f64,
        at: f64,
        motions: InputMotions<M, f64>,
        budget: &mut usize,
    ) -> Result<Reached<M>, SolveError> {
        // the most likely failure first
        solved(course, motions)?;
        let near = course.edge(from.at, open);
        let near = match self.advance(course, from, near, course.drive.motions(near), budget) {
            Ok(near) => near.footing,
            Err(_) => *from,
        };
        let far = course.edge(at, open);
        let beyond = course.drive.motions(far);
        let pose = solved(course, beyond)?;
        let far = Reached::of(course, far, beyond, pose).unwrapped(course, beyond, &near.without_rates());
        self.advance(course, &far.footing, at, motions, budget)
    }

    /// The pose that follows from another one, by steps short enough to unwrap every angle.
    fn advance<D: Drive<M>>(
        &mut self,
        course: &Course<M, D>,
        from: &Footing<M>,
        at: f64,
        motions: InputMotions<M, f64>,
        budget: &mut usize,
    ) -> Result<Reached<M>, SolveError> {
        let mut reached = self.leap(course, from, at, motions)?;
        let middle = f64::midpoint(from.at, at);
        if reached.footing.follows(from) {
            return Ok(reached);
        }
        if *budget == 0 || middle == from.at || middle == at {
            reached.has_jumped = true;
            return Ok(reached);
        }
        *budget -= 1;
        let between = self.advance(course, from, middle, course.drive.motions(middle), budget);
        match between {
            Ok(between) => {
                let mut reached = self.advance(course, &between.footing, at, motions, budget)?;
                reached.has_jumped |= between.has_jumped;
                Ok(reached)
            }
            Err(error) if M::ASSEMBLY_COUNT == 0 => Err(error),
            Err(_) => self.across(course, from, middle, at, motions, budget),
        }
    }

    /// The pose that follows from another one by a single step.
    fn leap<D: Drive<M>>(
        &mut self,
        course: &Course<M, D>,
        from: &Footing<M>,
        at: f64,
        motions: InputMotions<M, f64>,
    ) -> Result<Reached<M>, SolveError> {
        let mechanism = &course.mechanism;
        if M::ASSEMBLY_COUNT > 0 {
            let pose = solved(course, motions)?;
            return Ok(Reached::of(course, at, motions, pose).unwrapped(course, motions, from));
        }
        let inputs = values::<M>(motions);
        if let Some(gap) = self.gap {
            return Err(beyond::<M>(gap, inputs));
        }
        let unknowns = track(mechanism, from.inputs, from.unknowns, inputs).map_err(|error| {
            let (gap, failure) = stopped(mechanism, &error, from.inputs, inputs);
            self.gap = Some(gap);
            failure
        })?;
        let pose = mechanism.solve_motion_near(motions, unknowns)?;
        let mut reached = Reached::of(course, at, motions, pose);
        reached.footing.unknowns = unknowns;
        reached.footing.unwrap_outputs(from);
        Ok(reached)
    }
}

/// The time for each unit of the variable, in the rates of some motions of the inputs. Exact tables give rates by the variable itself, others
/// those by time: so it is the motion of the variable that tells, and not the speed of the sweep.
fn time_of<M: Mechanism<Scalar = f64>, D: Drive<M>>(course: &Course<M, D>, motions: InputMotions<M, f64>) -> f64 {
    let own = match course.drive.variable() {
        Variable::Input(lead) => motions[lead].as_ref().get(1).copied(),
        _ => None,
    };
    1.0 / own.unwrap_or_else(|| course.drive.rate())
}

/// The pose of the sweep for some inputs. It stands in one place, as each copy of the solver is compiled anew.
#[inline(never)]
fn solved<M: Mechanism<Scalar = f64>, D>(
    course: &Course<M, D>,
    motions: InputMotions<M, f64>,
) -> Result<M::Pose, SolveError> {
    course.mechanism.solve_motion(motions, course.assembly)
}

impl<M: Mechanism<Scalar = f64>> Reached<M> {
    /// A pose with the angles that it returns.
    fn of<D: Drive<M>>(course: &Course<M, D>, at: f64, motions: InputMotions<M, f64>, pose: M::Pose) -> Self {
        Self::with_unknowns(course, at, motions, pose, &pose.unknown_motions())
    }

    fn with_unknowns<D: Drive<M>>(
        course: &Course<M, D>,
        at: f64,
        motions: InputMotions<M, f64>,
        pose: M::Pose,
        unknowns: &M::Unknowns<M::Motion<f64>>,
    ) -> Self {
        let time = time_of(course, motions);
        let outputs = pose.output_motions();
        let rate = |motion: &[f64]| motion.get(1).map_or(f64::NAN, |velocity| velocity * time);
        let footing = Footing {
            at,
            inputs: values::<M>(motions),
            unknowns: Row::from_fn(|unknown| unknowns[unknown][0]),
            unknown_rates: Row::from_fn(|unknown| rate(unknowns[unknown].as_ref())),
            outputs: Row::from_fn(|output| outputs[output][0]),
            output_rates: Row::from_fn(|output| rate(outputs[output].as_ref())),
        };
        Self {
            pose,
            footing,
            has_jumped: false,
        }
    }

    /// The same pose with the angles that follow from those of another one.
    fn unwrapped<D: Drive<M>>(
        mut self,
        course: &Course<M, D>,
        motions: InputMotions<M, f64>,
        from: &Footing<M>,
    ) -> Self {
        if self.footing.unwrap_unknowns(from) {
            // What depends on an angle itself, as the position of a rack does, depends on its turn.
            let near = self.footing.near(from);
            if let Ok(pose) = course.mechanism.solve_motion_near(motions, near) {
                let unknowns = pose.unknown_motions_near(Row::from_fn(|unknown| near[unknown]));
                let mut turned = Self::with_unknowns(course, self.footing.at, motions, pose, &unknowns);
                turned.footing.unwrap_unknowns(from);
                // Where two assemblies meet, the solver may return the other one. Within a loop, a gear of half the speed exchanges their names.
                let inputs = values::<M>(motions);
                let is_same = course.mechanism.assembly_near(inputs, turned.footing.unknowns) == course.assembly;
                if is_same || (turned.footing.unknowns_follow(from) && !self.footing.unknowns_follow(from)) {
                    self = turned;
                }
            }
        }
        self.footing.unwrap_outputs(from);
        self
    }
}

impl<M: Mechanism> Footing<M> {
    fn unknown(&self, index: usize) -> MovingAngle {
        MovingAngle {
            value: self.unknowns[index],
            rate: self.unknown_rates[index],
        }
    }

    fn output(&self, index: usize) -> MovingAngle {
        MovingAngle {
            value: self.outputs[index],
            rate: self.output_rates[index],
        }
    }

    /// Moves the angles of the unknowns to the turns that follow from another footing; returns whether one has moved.
    fn unwrap_unknowns(&mut self, from: &Self) -> bool {
        let step = self.at - from.at;
        let mut has_moved = false;
        for unknown in angles(M::DESCRIPTION.unknowns) {
            let before = from.unknown(unknown);
            let unwrapped = self.unknown(unknown).unwrapped(before, step);
            has_moved |= unwrapped != self.unknowns[unknown];
            self.unknowns[unknown] = unwrapped;
        }
        has_moved
    }

    /// The unknowns, with predicted angles for those that do not follow from another footing by whole turns: a gear of half the speed is
    /// half a turn away.
    fn near(&self, from: &Self) -> M::Unknowns<f64> {
        let step = self.at - from.at;
        let mut near = self.unknowns;
        for unknown in angles(M::DESCRIPTION.unknowns) {
            let before = from.unknown(unknown);
            let angle = self.unknown(unknown);
            if let (Some(predicted), false) = (angle.predicted(before, step), angle.follows(before, step)) {
                near[unknown] = predicted;
            }
        }
        near
    }

    /// Moves all angles to the turns that follow from another footing.
    #[cfg(feature = "alloc")]
    pub(super) fn unwrap(&mut self, from: &Self) {
        self.unwrap_unknowns(from);
        self.unwrap_outputs(from);
    }

    fn unwrap_outputs(&mut self, from: &Self) {
        let step = self.at - from.at;
        for output in angles(M::DESCRIPTION.outputs) {
            let before = from.output(output);
            let angle = self.output(output);
            self.outputs[output] = angle.unwrapped(before, step);
        }
    }

    /// The same footing whose rates are not known.
    fn without_rates(&self) -> Self {
        Self {
            unknown_rates: Row::splat(f64::NAN),
            output_rates: Row::splat(f64::NAN),
            ..*self
        }
    }

    /// Whether the step from another footing is short enough to unwrap every angle.
    pub(super) fn follows(&self, from: &Self) -> bool {
        let step = self.at - from.at;
        let inputs = M::DESCRIPTION.inputs;
        angles(inputs).all(|input| (self.inputs[input] - from.inputs[input]).abs() <= LONGEST)
            && self.unknowns_follow(from)
            && angles(M::DESCRIPTION.outputs).all(|output| {
                let before = from.output(output);
                self.output(output).follows(before, step)
            })
    }

    fn unknowns_follow(&self, from: &Self) -> bool {
        let step = self.at - from.at;
        angles(M::DESCRIPTION.unknowns).all(|unknown| {
            let before = from.unknown(unknown);
            self.unknown(unknown).follows(before, step)
        })
    }
}

/// An angle with its rate, which is not finite if it is not known.
#[derive(Clone, Copy)]
struct MovingAngle {
    value: f64,
    rate: f64,
}

impl MovingAngle {
    /// The change since another angle that both rates predict, by the trapezoid rule.
    fn predicted(self, before: Self, step: f64) -> Option<f64> {
        let change = 0.5 * step * (before.rate + self.rate);
        change.is_finite().then_some(before.value + change)
    }

    /// The angle on the turn nearest to the prediction, or to the angle before if there is none.
    fn unwrapped(self, before: Self, step: f64) -> f64 {
        let near = self.predicted(before, step).unwrap_or(before.value);
        nearest_turn(self.value, near)
    }

    /// Whether the angle is so close to the prediction that its turn is certain.
    fn follows(self, before: Self, step: f64) -> bool {
        match self.predicted(before, step) {
            Some(predicted) => {
                (self.value - predicted).abs() <= PREDICTION && (predicted - before.value).abs() <= LONGEST_PREDICTION
            }
            None => (self.value - before.value).abs() <= WITHOUT_RATES,
        }
    }
}

/// The indices of the quantities that are angles.
pub(super) fn angles(quantities: &[Quantity]) -> impl Iterator<Item = usize> + '_ {
    let is_angle = |(index, quantity): (usize, &Quantity)| (quantity.dimension == Dimension::Angle).then_some(index);
    quantities.iter().enumerate().filter_map(is_angle)
}

impl<M: Mechanism<Scalar = f64>, D: Drive<M>> Course<M, D> {
    /// The last place at which the mechanism closes, from one that closes to one that does not.
    pub(crate) fn edge(&self, mut closed: f64, mut open: f64) -> f64 {
        for _ in 0..EDGE {
            let middle = f64::midpoint(closed, open);
            let inputs = values::<M>(self.drive.motions(middle));
            if self.mechanism.solve_position(inputs, self.assembly).is_ok() {
                closed = middle;
            } else {
                open = middle;
            }
        }
        closed
    }
}

fn values<M: Mechanism>(motions: InputMotions<M, f64>) -> M::Inputs<f64> {
    Row::from_fn(|input| motions[input][0])
}

/// The largest change of an angle that is an input.
fn longest_way<M: Mechanism>(from: &M::Inputs<f64>, to: &M::Inputs<f64>) -> f64 {
    let ways = angles(M::DESCRIPTION.inputs).map(|input| (to[input] - from[input]).abs());
    ways.fold(0.0, f64::max)
}

/// The angle on the turn closest to another angle. Half a turn apart, where rounding would decide, it stays on the smaller turn.
fn nearest_turn(angle: f64, near: f64) -> f64 {
    let turns = (near - angle) / TAU;
    let turns = Float::ceil(turns.abs() - 0.5 - AMBIGUOUS).max(0.0).copysign(turns);
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
