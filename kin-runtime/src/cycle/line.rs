//! The line in the space of the inputs over which a cycle is taken.

use alloc::vec::Vec;
use core::f64::consts::{PI, TAU};

use num_traits::Float;

use super::sought::{SoughtMechanism, sum_of_lengths};
use crate::bounds::Bounds;
use crate::law::Side;
use crate::number::NumberRow;
use crate::quantity::Dimension;
use crate::solve::Scalar;
use crate::sweep::{Drive, READ, SmoothDrive, Variable, write_steady};

/// The largest number of revolutions of the inputs after which the closure may repeat itself.
const MOST_REVOLUTIONS: u32 = 12;
/// The largest difference of two values of a row, as a part of them, that may be rounding.
const ROUNDING_OF_ROW: f64 = 1e-9;
/// The part of a revolution by which the samples of the search are shifted, so that symmetric linkages have no limit
/// exactly there.
const SHIFT: f64 = 0.061_803;

/// The largest [`distance`](SoughtMechanism::distance) of two positions next to the input at which they meet.
pub(super) const MEETING: f64 = 1e-3;

/// The inputs `from + s direction`, for s in a range.
#[derive(Clone, Debug)]
pub(super) struct InputLine {
    pub(super) from: NumberRow,
    pub(super) direction: NumberRow,
    /// The range of the search. A closed range is shifted against the one that is reported.
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) is_closed: bool,
    /// Whether only angles move along the line.
    pub(super) is_angle: bool,
}

impl InputLine {
    /// The line through a point in a direction, over all inputs at which the mechanism may close.
    fn whole(mechanism: &SoughtMechanism<'_>, from: NumberRow, direction: NumberRow) -> Self {
        let mut line = Self::over(mechanism, from, direction, [-PI, PI]);
        let direction = &line.direction;
        let moving = || {
            let inputs = mechanism.inputs().iter().zip(direction.iter());
            inputs.filter(|(_, rate)| **rate != 0.0)
        };
        if moving().any(|(input, _)| input.dimension == Dimension::Length) {
            let reach = 2.0 * (mechanism.reach() + sum_of_lengths(mechanism.inputs(), &line.from));
            let fastest = moving()
                .filter(|(input, _)| input.dimension == Dimension::Length)
                .fold(0.0, |fastest: f64, (_, rate)| fastest.max(rate.abs()));
            (line.low, line.high) = (-reach / fastest, reach / fastest);
        } else if let Some(revolutions) = (1..=MOST_REVOLUTIONS)
            .map(f64::from)
            .find(|revolutions| line.repeats(mechanism, revolutions * TAU))
        {
            let half = PI * revolutions;
            line.is_closed = true;
            (line.low, line.high) = (-half - SHIFT * TAU, half - SHIFT * TAU);
        }
        line
    }

    /// The line over a given range of s, or over all inputs at which the mechanism may close.
    pub(super) fn new(
        mechanism: &SoughtMechanism<'_>,
        from: NumberRow,
        direction: NumberRow,
        range: Option<[f64; 2]>,
    ) -> Self {
        match range {
            Some([start, end]) => Self::over(mechanism, from, direction, [start.min(end), end.max(start)]),
            None => Self::whole(mechanism, from, direction),
        }
    }

    fn over(mechanism: &SoughtMechanism<'_>, from: NumberRow, direction: NumberRow, [low, high]: [f64; 2]) -> Self {
        let moving = mechanism.inputs().iter().zip(direction.iter());
        let is_angle = moving
            .filter(|(_, rate)| **rate != 0.0)
            .all(|(input, _)| input.dimension == Dimension::Angle);
        Self {
            from,
            direction,
            low,
            high,
            is_closed: false,
            is_angle,
        }
    }

    pub(super) fn inputs(&self, s: f64) -> NumberRow {
        NumberRow::from_fn(self.from.len(), |index| self.from[index] + self.direction[index] * s)
    }

    /// The inputs of the line as another number, for a coordinate of that number.
    pub(super) fn inputs_at<B: Scalar>(&self, s: B) -> Vec<B> {
        let inputs = self.from.iter().zip(self.direction.iter());
        let inputs = inputs.map(|(from, rate)| {
            if *rate == 0.0 {
                B::constant(*from)
            } else if *from == 0.0 && *rate == 1.0 {
                s
            } else {
                B::constant(*from) + B::constant(*rate) * s
            }
        });
        inputs.collect()
    }

    /// The coordinate of some inputs on the line.
    pub(super) fn coordinate(&self, inputs: &[f64]) -> f64 {
        let rates = self.direction.iter().enumerate();
        let (lead, rate) = rates.fold((0, 0.0_f64), |best, (index, rate)| {
            if rate.abs() > best.1.abs() {
                (index, *rate)
            } else {
                best
            }
        });
        (inputs[lead] - self.from[lead]) / rate
    }

    pub(super) fn period(&self) -> Option<f64> {
        self.is_closed.then_some(self.high - self.low)
    }

    /// The coordinate in the range that differs by whole periods from another one.
    pub(super) fn reduced(&self, s: f64) -> f64 {
        match self.period() {
            Some(period) => {
                let periods = Float::floor((s + 0.5 * period) / period);
                s - periods * period
            }
            None => s,
        }
    }

    /// Whether the closure is the same after a given way, up to rounding, at some inputs that have nothing in common.
    /// An angle that is a multiple of an input, like that of a gear, may have made revolutions.
    fn repeats(&self, mechanism: &SoughtMechanism<'_>, way: f64) -> bool {
        let size = mechanism.reach().max(f64::MIN_POSITIVE);
        let (quantities, rounded) = (mechanism.unknowns(), mechanism.rounded());
        let agrees = |advanced: Option<(usize, f64)>| {
            (0..4).map(f64::from).all(|seed| {
                let unknowns = NumberRow::from_fn(quantities.len(), |index| {
                    let mixed = Float::sin((seed + 0.5) * (count(index) + 1.7) * 12.9898);
                    match quantities[index].dimension {
                        Dimension::Length => mixed * size,
                        _ => mixed,
                    }
                });
                let mut moved = unknowns.clone();
                if let Some((index, angle)) = advanced {
                    moved[index] += angle;
                }
                let s = 0.3 + 1.1 * seed;
                let is_same = |near: f64, far: f64, tolerance: f64| (near - far).abs() <= tolerance;
                let near = mechanism.residuals(&self.inputs(s), &unknowns);
                let far = mechanism.residuals(&self.inputs(s + way), &moved);
                let rows = || near.iter().zip(far.iter());
                if !rows().all(|(near, far)| is_same(*near, *far, ROUNDING_OF_ROW * (near.abs() + size.max(1.0)))) {
                    return false;
                }
                // Each row in the unit of the row: by the bounds of what rounding changes in it, a whole revolution
                // included.
                let errors = |s: f64, unknowns: &[f64]| {
                    let inputs = self.inputs_at(Bounds::rounded(s));
                    let unknowns: Vec<Bounds> = unknowns.iter().copied().map(Bounds::rounded).collect();
                    mechanism.bounded_residuals(&rounded, &inputs, &unknowns)
                };
                let (one, other) = (errors(s, &unknowns), errors(s + way, &moved));
                let errors = one.iter().zip(&other);
                let mut errors = errors.map(|(one, other)| one.error() + other.error());
                rows().all(|(near, far)| is_same(*near, *far, errors.next().unwrap_or(0.0)))
            })
        };
        let angles = || {
            let unknowns = quantities.iter().enumerate();
            let angles = unknowns.filter(|(_, unknown)| unknown.dimension == Dimension::Angle);
            angles.flat_map(|(index, _)| {
                let revolutions = (1..=MOST_REVOLUTIONS).map(|revolutions| TAU * f64::from(revolutions));
                revolutions.flat_map(move |angle| [(index, angle), (index, -angle)])
            })
        };
        agrees(None) || angles().any(|advanced| agrees(Some(advanced)))
    }
}

impl Drive for InputLine {
    /// The only input that moves, if it is the coordinate of the line itself.
    fn variable(&self) -> Variable {
        let mut moving = (0..self.direction.len()).filter(|input| self.direction[*input] != 0.0);
        match (moving.next(), moving.next()) {
            (Some(input), None) if self.direction[input] == 1.0 && self.from[input] == 0.0 => Variable::Input(input),
            _ => Variable::Time,
        }
    }

    fn motions(&self, at: f64, orders: usize, motions: &mut [f64]) {
        let values = self.inputs(at);
        for (input, motion) in motions.chunks_exact_mut(orders).enumerate() {
            write_steady(motion, values[input], self.direction[input]);
        }
    }
}

impl SmoothDrive for InputLine {
    fn derivatives(&self, at: f64, _: Side, derivatives: &mut [f64]) {
        self.motions(at, READ, derivatives);
    }
}

/// The same angle in -π ..= π.
pub(super) fn wrapped(angle: f64) -> f64 {
    angle - whole_revolutions(angle)
}

/// The whole revolutions that are nearest to an angle.
pub(super) fn whole_revolutions(angle: f64) -> f64 {
    TAU * Float::round(angle / TAU)
}

/// A small count as a number.
pub(super) fn count(count: usize) -> f64 {
    u32::try_from(count).map_or(f64::INFINITY, f64::from)
}
