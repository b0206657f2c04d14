//! A pose of a walk, with unwrapped angles.

use alloc::vec::Vec;
use core::f64::consts::{FRAC_PI_2, PI, TAU};

use num_traits::Float;

use super::drive::Variable;
use super::untyped::{UntypedSweep, angles};
use crate::mechanism::Description;
use crate::number::NumberRow;

/// The longest step of an angle that is an input.
pub(super) const LONGEST_INPUT_STEP: f64 = 1.0;
/// The largest difference between an angle and its prediction from the rates at both ends of a step. Half a revolution
/// would be ambiguous.
pub(super) const PREDICTION: f64 = 1.0;
/// The largest such difference by which a pose of the other assembly is still known to continue the motion.
const SURE_PREDICTION: f64 = 0.1;
/// The largest change that rates may predict: next to a limit they are far too large.
pub(super) const LONGEST_PREDICTION: f64 = 2.0;
/// The largest step of an angle without rates.
pub(super) const WITHOUT_RATES: f64 = FRAC_PI_2;
/// The part of a revolution within which half a revolution is ambiguous.
const AMBIGUOUS: f64 = 1e-6;

/// The pose at a point of a sweep, from which a walk goes on.
#[derive(Clone)]
pub(crate) struct Footing<'c> {
    /// The variable of the sweep.
    pub(crate) at: f64,
    /// The motions of inputs, unknowns and outputs, one after the other, each with the same number of orders.
    pub(crate) numbers: Vec<f64>,
    pub(super) orders: usize,
    /// The time for each unit of the variable, not a number if the rates are not known.
    pub(super) time: f64,
    pub(super) description: &'c Description<'c>,
    /// The values of the unknowns near which the pose has been found, unless it is that of the assembly itself.
    pub(super) near: Option<Vec<f64>>,
    /// Whether an angle has changed in a way that its rates do not predict, although the steps were as short as can be.
    pub(super) has_jumped: bool,
}

impl<'c> Footing<'c> {
    /// A pose with the angles that it returns.
    pub(super) fn new(sweep: &UntypedSweep<'c>, at: f64, numbers: Vec<f64>) -> Self {
        let orders = sweep.orders();
        // Exact tables give rates by the variable itself, others those by time: so it is the motion of the variable
        // that decides, and not the speed of the sweep.
        let rate_of_variable = match sweep.drive.variable() {
            Variable::Input(lead) if orders > 1 => Some(numbers[lead * orders + 1]),
            _ => None,
        };
        Self {
            at,
            numbers,
            orders,
            time: 1.0 / rate_of_variable.unwrap_or_else(|| sweep.drive.rate()),
            description: sweep.description,
            near: None,
            has_jumped: false,
        }
    }

    /// A position, whose rates are not known.
    pub(crate) fn of_position(
        description: &'c Description<'c>,
        at: f64,
        [inputs, unknowns, outputs]: [&[f64]; 3],
    ) -> Self {
        Self {
            at,
            numbers: [inputs, unknowns, outputs].concat(),
            orders: 1,
            time: f64::NAN,
            description,
            near: None,
            has_jumped: false,
        }
    }

    /// The motion of a quantity by its index among inputs, unknowns and outputs.
    pub(crate) fn motion(&self, index: usize) -> &[f64] {
        &self.numbers[index * self.orders..(index + 1) * self.orders]
    }

    /// The motions of unknowns and outputs.
    pub(crate) fn results(&self) -> impl Iterator<Item = &[f64]> {
        let [first, _] = self.firsts();
        self.numbers.chunks_exact(self.orders).skip(first)
    }

    fn values(&self, first: usize, count: usize) -> NumberRow {
        NumberRow::from_fn(count, |index| self.numbers[(first + index) * self.orders])
    }

    pub(crate) fn inputs(&self) -> NumberRow {
        self.values(0, self.description.inputs.len())
    }

    /// The index of the first unknown, and that of the first output.
    fn firsts(&self) -> [usize; 2] {
        let inputs = self.description.inputs.len();
        [inputs, inputs + self.description.unknowns.len()]
    }

    pub(crate) fn unknowns(&self) -> NumberRow {
        self.values(self.firsts()[0], self.description.unknowns.len())
    }

    pub(crate) fn outputs(&self) -> NumberRow {
        self.values(self.firsts()[1], self.description.outputs.len())
    }

    pub(super) fn set_unknowns(&mut self, unknowns: &[f64]) {
        let [first, _] = self.firsts();
        for (index, value) in unknowns.iter().enumerate() {
            self.numbers[(first + index) * self.orders] = *value;
        }
    }

    pub(crate) fn set_outputs(&mut self, outputs: &[f64]) {
        let [_, first] = self.firsts();
        for (index, value) in outputs.iter().enumerate() {
            self.numbers[(first + index) * self.orders] = *value;
        }
    }

    /// The indices of the unknowns that are angles, among all quantities.
    fn unknown_angles(&self) -> impl Iterator<Item = usize> + use<'c> {
        let [first, _] = self.firsts();
        angles(self.description.unknowns).map(move |unknown| first + unknown)
    }

    fn output_angles(&self) -> impl Iterator<Item = usize> + use<'c> {
        let [_, first] = self.firsts();
        angles(self.description.outputs).map(move |output| first + output)
    }

    fn angle(&self, index: usize) -> MovingAngle {
        let motion = self.motion(index);
        MovingAngle {
            value: motion[0],
            rate: motion.get(1).map_or(f64::NAN, |velocity| velocity * self.time),
        }
    }

    /// Moves the angles of the unknowns to the revolutions that follow from another footing.
    pub(super) fn unwrap_unknowns(&mut self, from: &Footing<'_>) -> Unwrapping {
        self.unwrap_all(from, self.unknown_angles())
    }

    pub(super) fn unwrap_outputs(&mut self, from: &Footing<'_>) -> Unwrapping {
        self.unwrap_all(from, self.output_angles())
    }

    /// Moves all angles to the revolutions that follow from another footing. It returns whether the step from there is
    /// short enough for that.
    pub(super) fn unwrap(&mut self, from: &Footing<'_>) -> bool {
        let [unknowns, outputs] = [self.unwrap_unknowns(from), self.unwrap_outputs(from)];
        unknowns.follows && outputs.follows && self.inputs_follow(from)
    }

    fn unwrap_all(&mut self, from: &Footing<'_>, angles: impl Iterator<Item = usize>) -> Unwrapping {
        let step = self.at - from.at;
        let mut unwrapping = Unwrapping {
            has_moved: false,
            follows: true,
            is_sure: true,
        };
        for index in angles {
            let (before, mut angle) = (from.angle(index), self.angle(index));
            let unwrapped = angle.unwrapped(before, step);
            unwrapping.has_moved |= unwrapped != angle.value;
            angle.value = unwrapped;
            unwrapping.follows &= angle.follows(before, step);
            unwrapping.is_sure &= angle.is_within(SURE_PREDICTION, before, step);
            self.numbers[index * self.orders] = unwrapped;
        }
        unwrapping
    }

    /// The unknowns, with predicted angles for those that do not follow from another footing by whole revolutions: a
    /// gear of half the speed is half a revolution away.
    pub(super) fn near(&self, from: &Footing<'_>) -> Vec<f64> {
        let step = self.at - from.at;
        let [first, _] = self.firsts();
        let mut near = self.unknowns().to_vec();
        for index in self.unknown_angles() {
            let (before, angle) = (from.angle(index), self.angle(index));
            if let (Some(predicted), false) = (angle.predicted(before, step), angle.follows(before, step)) {
                near[index - first] = predicted;
            }
        }
        near
    }

    /// The same footing whose rates are not known.
    pub(super) fn without_rates(mut self) -> Self {
        self.time = f64::NAN;
        self
    }

    /// Whether the revolutions of the unknowns are certain.
    pub(super) fn unknowns_follow(&self, from: &Footing<'_>) -> bool {
        let step = self.at - from.at;
        self.unknown_angles()
            .all(|index| self.angle(index).follows(from.angle(index), step))
    }

    /// Whether the step from another footing is short enough for the angles among the inputs.
    pub(super) fn inputs_follow(&self, from: &Footing<'_>) -> bool {
        from.is_near(&self.numbers, self.orders)
    }

    /// Whether motions of the inputs, in a number of orders, are so close that no angle among them moves far.
    pub(super) fn is_near(&self, motions: &[f64], orders: usize) -> bool {
        angles(self.description.inputs)
            .all(|input| (motions[input * orders] - self.numbers[input * self.orders]).abs() <= LONGEST_INPUT_STEP)
    }
}

/// What has become of the angles that follow from those of another footing.
#[derive(Clone, Copy)]
pub(super) struct Unwrapping {
    /// Whether one has moved to another revolution.
    pub(super) has_moved: bool,
    /// Whether each is so close to its prediction that its revolution is certain.
    pub(super) follows: bool,
    /// Whether each is so close to its prediction that its assembly is certain, too.
    pub(super) is_sure: bool,
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

    /// The angle unwrapped to the prediction, or to the angle before if there is none.
    fn unwrapped(self, before: Self, step: f64) -> f64 {
        let near = self.predicted(before, step).unwrap_or(before.value);
        unwrapped_to(self.value, near)
    }

    /// Whether the angle is so close to the prediction that its revolution is certain.
    fn follows(self, before: Self, step: f64) -> bool {
        match self.predicted(before, step) {
            Some(_) => self.is_within(PREDICTION, before, step),
            None => (self.value - before.value).abs() <= WITHOUT_RATES,
        }
    }

    /// Whether the angle is predicted up to a given difference. Without rates the angle before is the prediction.
    fn is_within(self, difference: f64, before: Self, step: f64) -> bool {
        let predicted = self.predicted(before, step).unwrap_or(before.value);
        (self.value - predicted).abs() <= difference && (predicted - before.value).abs() <= LONGEST_PREDICTION
    }
}

/// The angle unwrapped to another angle. Half a revolution apart, where rounding would decide, it moves less.
fn unwrapped_to(angle: f64, near: f64) -> f64 {
    if (near - angle).abs() <= PI {
        return angle;
    }
    let revolutions = (near - angle) / TAU;
    let revolutions = Float::ceil(revolutions.abs() - 0.5 - AMBIGUOUS)
        .max(0.0)
        .copysign(revolutions);
    if revolutions == 0.0 {
        angle
    } else {
        angle + revolutions * TAU
    }
}
