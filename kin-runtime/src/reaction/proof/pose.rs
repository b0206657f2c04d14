//! The pose of a mechanism over a box of inputs and dimensions.
//!
//! Krawczyk's operator proves that there is one pose in a box of unknowns, for every place of the box of variables: it
//! maps the box of unknowns into its inner part. (R. Krawczyk, *Newton-Algorithmen zur Bestimmung von Nullstellen mit
//! Fehlerschranken*, Computing 4 (1969), 187-201; A. Neumaier, *Interval Methods for Systems of Equations*, Cambridge
//! 1990, section 5.1.) It needs the closure alone, so that a coupled block is no exception.

use alloc::vec;
use alloc::vec::Vec;

use super::super::frames::{MovedMechanism, MovingNumber, Shortened};
use super::super::{MovingBounds, ReactionFunctions};
use crate::any::{ClosureOver, PositionChoice};
use crate::bounds::Bounds;
use crate::bounds::linear::{RegularMatrix, inverse, times};
use crate::number::{Changing, Number};

impl MovingNumber for MovingBounds {
    type Still = f64;

    fn now(self) -> f64 {
        self.real()
    }

    fn slope(self) -> Self {
        let second = self.change.change;
        Changing::new(
            Changing::new(self.value.change, second),
            Changing::new(second, Bounds::constant(0.0)),
        )
    }
}

impl Shortened<Self> for MovingBounds {
    fn shortened(self) -> Self {
        self
    }
}

/// A number that moves in time, by its value and two derivatives.
pub(super) fn moving(value: Bounds, [rate, second]: [Bounds; 2]) -> MovingBounds {
    Changing::new(Changing::new(value, rate), Changing::new(rate, second))
}

pub(super) fn still(value: Bounds) -> MovingBounds {
    let zero = Bounds::constant(0.0);
    moving(value, [zero; 2])
}

/// The most attempts at a box of unknowns.
const ATTEMPTS: usize = 6;
/// The most steps by which errors are narrowed.
const STEPS: usize = 30;

/// What a pose depends on: the parameters, and the inputs in motion.
pub(super) struct Given {
    pub(super) parameters: Vec<MovingBounds>,
    pub(super) inputs: Vec<MovingBounds>,
}

/// The poses over a box of variables: for each place, there is one in the box of unknowns.
#[derive(Clone)]
pub(super) struct Enclosed {
    pub(super) centre: Vec<f64>,
    /// Within these distances from the centre, no place has another pose.
    alone: Vec<f64>,
    /// Within these, each has its pose.
    radii: Vec<f64>,
    inverse: Vec<f64>,
    /// The largest sizes of what the product of the inverse and the Jacobian differs by from the unit matrix.
    deviations: Vec<f64>,
}

/// The closure over a box of variables.
pub(super) struct Closure<'c> {
    functions: &'c dyn ReactionFunctions,
    given: &'c Given,
}

impl<'c> Closure<'c> {
    pub(super) fn new(functions: &'c dyn ReactionFunctions, given: &'c Given) -> Self {
        Self { functions, given }
    }

    /// The residuals with inputs that move.
    fn residuals(&self, unknowns: &[MovingBounds]) -> Vec<MovingBounds> {
        let mut residuals = vec![still(Bounds::constant(0.0)); unknowns.len()];
        let functions: &dyn ClosureOver<MovingBounds> = self.functions;
        functions.closure(&self.given.parameters, &self.given.inputs, unknowns, &mut residuals);
        residuals
    }

    /// The residuals while nothing moves.
    fn values(&self, unknowns: &[Bounds]) -> Vec<Bounds> {
        let unknowns: Vec<_> = unknowns.iter().copied().map(still).collect();
        self.residuals(&unknowns).iter().map(|one| one.value.value).collect()
    }

    /// The columns of the Jacobian with respect to the unknowns. Two are found at once.
    fn jacobian(&self, unknowns: &[Bounds]) -> Vec<Vec<Bounds>> {
        let inputs = self.given.inputs.iter().map(|input| still(input.value.value)).collect();
        let parameters = self.given.parameters.clone();
        let given = Given { parameters, inputs };
        let closure = Closure::new(self.functions, &given);
        let mut columns = Vec::with_capacity(unknowns.len());
        let one = Bounds::constant(1.0);
        while columns.len() < unknowns.len() {
            let mut varied: Vec<_> = unknowns.iter().copied().map(still).collect();
            let first = columns.len();
            varied[first].value.change = one;
            if let Some(second) = varied.get_mut(first + 1) {
                second.change.value = one;
            }
            let residuals = closure.residuals(&varied);
            columns.push(residuals.iter().map(|residual| residual.value.change).collect());
            if columns.len() < unknowns.len() {
                columns.push(residuals.iter().map(|residual| residual.change.value).collect());
            }
        }
        columns
    }

    /// The box around a pose in which there is one pose for every place, if it can be proved.
    pub(super) fn enclose(&self, centre: &[f64]) -> Option<Enclosed> {
        let count = centre.len();
        let middle: Vec<Bounds> = centre.iter().copied().map(Bounds::constant).collect();
        let columns = self.jacobian(&middle);
        let places = (0..count).flat_map(|row| (0..count).map(move |column| (row, column)));
        let real: Vec<f64> = places.map(|(row, column)| columns[column][row].real()).collect();
        let inverse = inverse(&real, count)?;
        let residuals = times(&inverse, &self.values(&middle));
        if !residuals.iter().all(|residual| residual.is_bounded()) {
            return None;
        }
        let sizes: Vec<f64> = residuals.iter().map(|residual| residual.size()).collect();
        let wider = |size: f64, centre: f64| 1.2 * size + f64::EPSILON * centre.abs() + SMALLEST;
        let mut radii: Vec<f64> = sizes
            .iter()
            .zip(centre)
            .map(|(size, own)| wider(1.5 * size, *own))
            .collect();
        for _ in 0..ATTEMPTS {
            let unknowns: Vec<_> = centre
                .iter()
                .zip(&radii)
                .map(|(own, by)| Bounds::around(*own, *by))
                .collect();
            let deviations = deviations(&inverse, &self.jacobian(&unknowns))?;
            let mapped = mapped(&sizes, &deviations, &radii);
            if mapped.iter().zip(&radii).all(|(mapped, radius)| mapped < radius) {
                return Some(Enclosed {
                    centre: centre.to_vec(),
                    alone: radii,
                    radii: narrowed(mapped, &sizes, &deviations),
                    inverse,
                    deviations,
                });
            }
            radii = mapped
                .iter()
                .zip(centre)
                .map(|(size, own)| wider(*size, *own))
                .collect();
        }
        None
    }
}

/// A radius below those of all unknowns, which still is above zero.
const SMALLEST: f64 = 1e-120;

/// More than the rounding of a sum of a thousand products.
const ROUNDED_UP: f64 = 1.0 + 1e-12;

/// The largest sizes by which the product of the inverse and a matrix differs from the unit matrix, row by row.
fn deviations(inverse: &[f64], columns: &[Vec<Bounds>]) -> Option<Vec<f64>> {
    let count = columns.len();
    let mut deviations = vec![0.0; count * count];
    for (index, column) in columns.iter().enumerate() {
        for (row, entry) in times(inverse, column).into_iter().enumerate() {
            if !entry.is_bounded() {
                return None;
            }
            let own = Bounds::constant(f64::from(u8::from(row == index)));
            deviations[row * count + index] = (entry - own).size();
        }
    }
    Some(deviations)
}

/// The errors into which Krawczyk's operator maps errors.
fn mapped(sizes: &[f64], deviations: &[f64], radii: &[f64]) -> Vec<f64> {
    let rows = deviations.chunks_exact(radii.len().max(1));
    let one = |(size, row): (&f64, &[f64])| {
        let products = row.iter().zip(radii).map(|(deviation, radius)| deviation * radius);
        products.fold(*size, |sum, product| sum + product) * ROUNDED_UP + SMALLEST * f64::EPSILON
    };
    sizes.iter().zip(rows).map(one).collect()
}

/// The same errors, mapped as long as this makes them smaller.
fn narrowed(mut radii: Vec<f64>, sizes: &[f64], deviations: &[f64]) -> Vec<f64> {
    for _ in 0..STEPS {
        let next = mapped(sizes, deviations, &radii);
        let mut is_narrower = false;
        for (radius, next) in radii.iter_mut().zip(next) {
            is_narrower |= next < 0.99 * *radius;
            *radius = radius.min(next);
        }
        if !is_narrower {
            break;
        }
    }
    radii
}

impl Enclosed {
    /// Whether a pose at a place of this box is certainly the one that is meant here, by the values of its unknowns.
    pub(super) fn holds(&self, pose: &[Bounds]) -> bool {
        let own = self.centre.iter().zip(&self.alone);
        let pose = pose.iter().map(|unknown| unknown.values());
        own.zip(pose).all(|((centre, radius), [low, high])| {
            let distance = (low - centre).abs().max((high - centre).abs());
            distance < radius * (1.0 - 4.0 * f64::EPSILON)
        })
    }

    /// The unknowns over a part of the box of variables, which contains its middle.
    pub(super) fn unknowns(&self, closure: &Closure<'_>) -> Option<Vec<Bounds>> {
        let middle: Vec<Bounds> = self.centre.iter().copied().map(Bounds::constant).collect();
        let residuals = times(&self.inverse, &closure.values(&middle));
        if !residuals.iter().all(|residual| residual.is_bounded()) {
            return None;
        }
        let sizes: Vec<f64> = residuals.iter().map(|residual| residual.size()).collect();
        let in_middle = |residual: &Bounds| residual.middle().abs() + residual.error();
        let in_middle: Vec<f64> = residuals.iter().map(in_middle).collect();
        let radii = narrowed(self.radii.clone(), &sizes, &self.deviations);
        let errors = narrowed(radii.clone(), &in_middle, &self.deviations);
        let within = self
            .centre
            .iter()
            .zip(&radii)
            .map(|(own, by)| Bounds::around(*own, *by));
        let within: Vec<Bounds> = within.collect();
        // the derivative of the closure while the unknowns stand anywhere in the box
        let slopes = closure.values(&within);
        let slopes: Vec<Bounds> = slopes.iter().map(|own| -Bounds::within(own.slopes())).collect();
        let jacobian = closure.jacobian(&within);
        let slopes = RegularMatrix::new(&self.inverse, jacobian.iter())?.solve(&slopes);
        let all = within.into_iter().zip(errors).zip(slopes);
        let all = all.map(|((within, error), slope)| within.sloped(error, slope.values()));
        Some(all.collect())
    }

    /// The mechanism in motion over a part of the box of variables.
    pub(super) fn moved(&self, closure: &Closure<'_>) -> Option<MovedMechanism<MovingBounds>> {
        let unknowns = self.unknowns(closure)?;
        let jacobian = closure.jacobian(&unknowns);
        let jacobian = RegularMatrix::new(&self.inverse, jacobian.iter())?;
        let solve = |lacking: Vec<Bounds>| {
            let right: Vec<Bounds> = lacking.into_iter().map(|own| -own).collect();
            jacobian.solve(&right)
        };
        let at_rest: Vec<_> = unknowns.iter().copied().map(still).collect();
        let residuals = closure.residuals(&at_rest);
        let rates = solve(residuals.iter().map(|residual| residual.value.change).collect());
        let zero = Bounds::constant(0.0);
        let steady = unknowns
            .iter()
            .zip(&rates)
            .map(|(own, rate)| moving(*own, [*rate, zero]));
        let residuals = closure.residuals(&steady.collect::<Vec<_>>());
        let seconds = solve(residuals.iter().map(|residual| residual.change.change).collect());
        let unknowns = unknowns.into_iter().zip(rates.into_iter().zip(seconds));
        let unknowns: Vec<_> = unknowns
            .map(|(own, (rate, second))| moving(own, [rate, second]))
            .collect();
        let Given { parameters, inputs } = closure.given;
        Some(MovedMechanism::of(
            closure.functions,
            parameters,
            inputs,
            &unknowns,
            &[],
        ))
    }
}

/// The pose near another one, in plain numbers.
pub(super) fn position(
    functions: &dyn ReactionFunctions,
    parameters: &[f64],
    inputs: &[f64],
    choice: PositionChoice<'_, f64>,
) -> Option<Vec<f64>> {
    let mut unknowns = vec![0.0; functions.description().unknowns.len()];
    functions.position(parameters, inputs, choice, &mut unknowns).ok()?;
    Some(unknowns)
}
