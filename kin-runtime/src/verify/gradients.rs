//! The partial derivatives of a mechanism's equations, by numbers that carry a change, and the rounding errors of the
//! equations.

use std::vec;
use std::vec::Vec;

use super::carrier::Carrier;
use super::divisors::Divided;
use super::functions::VerifiedFunctions;
use super::motions::Motions;
use super::rounded::Rounded;
use crate::any::ClosureOver;
use crate::number::series::Series;
use crate::number::{Changing, Number};

/// The residuals in numbers of one type. There are as many as unknowns.
fn residuals<T: Number>(functions: &dyn ClosureOver<T>, parameters: &[T], inputs: &[T], unknowns: &[T]) -> Vec<T> {
    let mut residuals = vec![T::constant(0.0); unknowns.len()];
    functions.closure(parameters, inputs, unknowns, &mut residuals);
    residuals
}

/// The partial derivatives of the equations, one row for each equation: with respect to the unknowns, and with respect
/// to parameters and inputs, the latter multiplied by these quantities themselves. A product is the shift of the
/// equation caused by a relative error in the quantity.
pub(super) fn gradients(
    functions: &dyn VerifiedFunctions,
    parameters: &[f64],
    inputs: Motions<'_>,
    unknowns: Motions<'_>,
) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
    type D = Changing<f64>;
    let (unknowns, inputs) = (unknowns.values(), inputs.values());
    // The column of one quantity, counted through unknowns, parameters and inputs.
    let column = |seeded: usize| -> Vec<f64> {
        let mut next = 0;
        let [unknowns, parameters, inputs] = [&unknowns[..], parameters, &inputs].map(|values| {
            let numbers = values.iter().map(|value| {
                next += 1;
                D::new(*value, if next - 1 == seeded { 1.0 } else { 0.0 })
            });
            numbers.collect::<Vec<D>>()
        });
        let found = residuals::<D>(functions, &parameters, &inputs, &unknowns);
        found.iter().map(|left| left.change).collect()
    };
    let by_unknowns: Vec<Vec<f64>> = (0..unknowns.len()).map(column).collect();
    let by_others: Vec<Vec<f64>> = parameters
        .iter()
        .chain(&inputs)
        .enumerate()
        .map(|(index, value)| {
            column(unknowns.len() + index)
                .into_iter()
                .map(|partial| partial * value.abs())
                .collect()
        })
        .collect();
    let rows = |columns: &[Vec<f64>]| -> Vec<Vec<f64>> {
        (0..unknowns.len())
            .map(|row| columns.iter().map(|column| column[row]).collect())
            .collect()
    };
    (rows(&by_unknowns), rows(&by_others))
}

/// The first four time derivatives of each partial derivative of the equations with respect to the unknowns, row by
/// row.
pub(super) fn jacobian_rates(
    functions: &dyn VerifiedFunctions,
    parameters: &[f64],
    inputs: Motions<'_>,
    unknowns: Motions<'_>,
) -> Vec<Vec<[f64; 4]>> {
    // The outer number differentiates along one unknown, the inner one along time.
    type Time = Series<5>;
    type D = Changing<Time>;
    let parameters: Vec<D> = parameters.iter().map(|value| Number::constant(*value)).collect();
    let number = |motion: &[f64], seed: f64| D::new(Time::carrying(motion), <Time as Number>::constant(seed));
    let inputs: Vec<D> = inputs.each().map(|motion| number(motion, 0.0)).collect();
    let columns: Vec<Vec<D>> = (0..unknowns.count())
        .map(|seeded| {
            let unknowns = unknowns.each().enumerate();
            let unknowns: Vec<D> = unknowns
                .map(|(index, motion)| number(motion, if index == seeded { 1.0 } else { 0.0 }))
                .collect();
            residuals::<D>(functions, &parameters, &inputs, &unknowns)
        })
        .collect();
    let rates = |entry: &D| [1, 2, 3, 4].map(|order| entry.change.derivative(order));
    (0..columns.len())
        .map(|row| columns.iter().map(|column| rates(&column[row])).collect())
        .collect()
}

/// The equations with inputs and unknowns that move, and the rates of their divisors.
pub(super) fn equations_along(
    functions: &dyn VerifiedFunctions,
    parameters: &[f64],
    inputs: impl Iterator<Item = Series<5>>,
    unknowns: impl Iterator<Item = Series<5>>,
) -> Vec<Divided> {
    let parameters: Vec<Divided> = parameters.iter().map(|value| Number::constant(*value)).collect();
    let inputs: Vec<Divided> = inputs.map(Divided::given).collect();
    let unknowns: Vec<Divided> = unknowns.map(Divided::given).collect();
    residuals::<Divided>(functions, &parameters, &inputs, &unknowns)
}

/// A bound on the rounding error of each equation, in units of ε.
pub(super) fn rounding_errors(
    functions: &dyn VerifiedFunctions,
    parameters: &[f64],
    inputs: Motions<'_>,
    unknowns: Motions<'_>,
) -> Vec<f64> {
    let exactly = |values: &[f64]| values.iter().map(|value| Rounded::exactly(*value)).collect::<Vec<_>>();
    let (inputs, unknowns) = (inputs.values(), unknowns.values());
    let found = residuals::<Rounded>(functions, &exactly(parameters), &exactly(&inputs), &exactly(&unknowns));
    found.iter().map(|left| left.error()).collect()
}
