//! The partial derivatives of a mechanism's equations, by numbers that carry a change, and the rounding errors of the equations.

use std::vec::Vec;

use super::carrier::Carrier;
use super::divisors::Divided;
use super::rounded::Rounded;
use super::{Inputs, Unknowns};
use crate::mechanism::Mechanism;
use crate::number::series::Series;
use crate::number::{Changing, Number, Row};

/// The value of each motion.
pub(super) fn values<R: Row<f64>>(motions: &[R]) -> Vec<f64> {
    motions.iter().map(|motion| derivative(motion, 0)).collect()
}

fn derivative<R: Row<f64>>(motion: &R, order: usize) -> f64 {
    motion.as_ref().get(order).copied().unwrap_or(0.0)
}

/// The partial derivatives of the equations, one row for each equation: with respect to the unknowns, and with respect
/// to parameters and inputs, the latter multiplied by these quantities themselves. A product is the shift of the
/// equation caused by a relative error in the quantity.
pub(super) fn gradients<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    inputs: &Inputs<M>,
    unknowns: &Unknowns<M>,
) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
    type D = Changing<f64>;
    let (unknowns, inputs) = (values(unknowns.as_ref()), values(inputs.as_ref()));
    let parameters = mechanism.parameters().as_ref().to_vec();
    // The column of one quantity, counted through unknowns, parameters and inputs.
    let column = |seeded: usize| -> Vec<f64> {
        let number = |index: usize, value: f64| D::new(value, if index == seeded { 1.0 } else { 0.0 });
        let mut next = unknowns.len();
        let lifted = mechanism.convert(|value| {
            next += 1;
            number(next - 1, value)
        });
        let first_input = unknowns.len() + parameters.len();
        let lifted_inputs = <<M::With<D> as Mechanism>::Inputs<D> as Row<D>>::from_fn(|index| {
            number(first_input + index, inputs[index])
        });
        let lifted_unknowns =
            <<M::With<D> as Mechanism>::Unknowns<D> as Row<D>>::from_fn(|index| number(index, unknowns[index]));
        lifted
            .closure(lifted_inputs, lifted_unknowns)
            .as_ref()
            .iter()
            .map(|left| left.change)
            .collect()
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
pub(super) fn jacobian_rates<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    inputs: &Inputs<M>,
    unknowns: &Unknowns<M>,
) -> Vec<Vec<[f64; 4]>> {
    // The outer number differentiates along one unknown, the inner one along time.
    type Time = Series<5>;
    type D = Changing<Time>;
    let lifted = mechanism.convert(<D as Number>::constant);
    let number =
        |motion: &M::Motion<f64>, seed: f64| D::new(Time::carrying(motion.as_ref()), <Time as Number>::constant(seed));
    let columns: Vec<Vec<D>> = (0..unknowns.as_ref().len())
        .map(|seeded| {
            let inputs = <<M::With<D> as Mechanism>::Inputs<D> as Row<D>>::from_fn(|index| number(&inputs[index], 0.0));
            let unknowns = <<M::With<D> as Mechanism>::Unknowns<D> as Row<D>>::from_fn(|index| {
                number(&unknowns[index], if index == seeded { 1.0 } else { 0.0 })
            });
            lifted.closure(inputs, unknowns).as_ref().to_vec()
        })
        .collect();
    let rates = |entry: &D| [1, 2, 3, 4].map(|order| entry.change.derivative(order));
    (0..columns.len())
        .map(|row| columns.iter().map(|column| rates(&column[row])).collect())
        .collect()
}

/// The equations with inputs and unknowns that move, and the rates of their divisors.
pub(super) fn equations_along<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    inputs: impl Fn(usize) -> Series<5>,
    unknowns: impl Fn(usize) -> Series<5>,
) -> Vec<Divided> {
    type D = Divided;
    let inputs = <<M::With<D> as Mechanism>::Inputs<D> as Row<D>>::from_fn(|index| D::given(inputs(index)));
    let unknowns = <<M::With<D> as Mechanism>::Unknowns<D> as Row<D>>::from_fn(|index| D::given(unknowns(index)));
    mechanism
        .convert(D::constant)
        .closure(inputs, unknowns)
        .as_ref()
        .to_vec()
}

/// A bound on the rounding error of each equation, in units of ε.
pub(super) fn rounding_errors<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    inputs: &Inputs<M>,
    unknowns: &Unknowns<M>,
) -> Vec<f64> {
    type R = Rounded;
    let exactly = |motion: &M::Motion<f64>| R::exactly(derivative(motion, 0));
    let inputs = <<M::With<R> as Mechanism>::Inputs<R> as Row<R>>::from_fn(|index| exactly(&inputs[index]));
    let unknowns = <<M::With<R> as Mechanism>::Unknowns<R> as Row<R>>::from_fn(|index| exactly(&unknowns[index]));
    mechanism
        .convert(R::exactly)
        .closure(inputs, unknowns)
        .as_ref()
        .iter()
        .map(|left| left.error())
        .collect()
}
