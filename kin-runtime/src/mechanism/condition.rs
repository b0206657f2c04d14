//! The condition of a position: how strongly it depends on rounding of the numbers it was found from.

use crate::mechanism::{Description, First, Mechanism};
use crate::number::{Number, Row};
use crate::quantity::{Dimension, Quantity};
use crate::solve::{LentFactors, lent_factors_length};

/// The quantity that changes, by its index.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Changed {
    Parameter(usize),
    Input(usize),
    Unknown(usize),
}

impl Changed {
    /// The value of a quantity, which changes by a number if it is this one.
    pub(crate) fn series(self, quantity: Self, value: f64, by: f64) -> First {
        First::from_coefficients([value, if self == quantity { by } else { 0.0 }])
    }
}

/// A position: all parameters, inputs and unknowns.
#[derive(Clone, Copy)]
pub(crate) struct At<'a> {
    pub(crate) parameters: &'a [f64],
    pub(crate) inputs: &'a [f64],
    pub(crate) unknowns: &'a [f64],
}

/// Memory for conditions: a number for each unknown in each of three rows, and that of [`LentFactors`].
pub(crate) struct ConditionMemory<'a> {
    pub(crate) rows: [&'a mut [f64]; 3],
    pub(crate) factors: &'a mut [f64],
}

/// Computes [`Mechanism::conditions`](crate::Mechanism::conditions).
pub(crate) fn conditions<M: Mechanism>(
    mechanism: &M,
    inputs: &M::Inputs<M::Scalar>,
    unknowns: &M::Unknowns<M::Scalar>,
) -> M::Unknowns<f64> {
    let parameters: M::Parameters<f64> = reals(mechanism.parameters().as_ref());
    let (inputs, unknowns): (M::Inputs<f64>, M::Unknowns<f64>) = (reals(inputs.as_ref()), reals(unknowns.as_ref()));
    let at = At {
        parameters: parameters.as_ref(),
        inputs: inputs.as_ref(),
        unknowns: unknowns.as_ref(),
    };
    let mut response = |changed: Changed, by: f64, response: &mut [f64]| {
        let series = |quantity, value| changed.series(quantity, value, by);
        let mechanism = <M::With<First>>::from_parameters(Row::from_fn(|index| {
            series(Changed::Parameter(index), at.parameters[index])
        }));
        let residuals = mechanism.closure(
            Row::from_fn(|index| series(Changed::Input(index), at.inputs[index])),
            Row::from_fn(|index| series(Changed::Unknown(index), at.unknowns[index])),
        );
        for (response, residual) in response.iter_mut().zip(residuals.as_ref()) {
            *response = residual.coefficients()[1];
        }
    };
    let mut conditions: M::Unknowns<f64> = Row::splat(0.0);
    let mut rows: [M::Unknowns<f64>; 3] = [Row::splat(0.0); 3];
    let [first, second, third] = &mut rows;
    M::lend(|lent| {
        let memory = ConditionMemory {
            rows: [first.as_mut(), second.as_mut(), third.as_mut()],
            factors: &mut lent.numbers[..lent_factors_length(at.unknowns.len())],
        };
        conditions_over(&M::DESCRIPTION, at, &mut response, memory, conditions.as_mut());
    });
    conditions
}

fn reals<T: Number, R: Row<f64>>(values: &[T]) -> R {
    Row::from_fn(|index| values[index].real())
}

/// The condition of each unknown. `response` writes the change of each equation with a quantity, times a number.
pub(crate) fn conditions_over(
    description: &Description<'_>,
    at: At<'_>,
    response: &mut dyn FnMut(Changed, f64, &mut [f64]),
    memory: ConditionMemory<'_>,
    conditions: &mut [f64],
) {
    let ConditionMemory {
        rows: [terms, right, change],
        factors,
    } = memory;
    let count = at.unknowns.len();
    terms.fill(0.0);
    for (index, (quantity, value)) in description.unknowns.iter().zip(at.unknowns).enumerate() {
        response(Changed::Unknown(index), 1.0, right);
        // The direction of a link is rounded, not its angle.
        let size = match quantity.dimension {
            Dimension::Angle => 1.0,
            _ => value.abs(),
        };
        for (row, (terms, entry)) in terms.iter_mut().zip(&*right).enumerate() {
            factors[row * count + index] = *entry;
            *terms += entry.abs() * size;
        }
        conditions[index] = value.abs();
    }
    let factored = LentFactors::of_entries(factors, count);
    let mut add = |right: &[f64]| {
        change.copy_from_slice(right);
        factored.solve(right, change);
        for (condition, change) in conditions.iter_mut().zip(&*change) {
            *condition += change.abs();
        }
    };
    for (row, term) in terms.iter().enumerate() {
        right.fill(0.0);
        right[row] = *term;
        add(right);
    }
    for (index, value) in at.parameters.iter().enumerate() {
        response(Changed::Parameter(index), *value, right);
        add(right);
    }
    for (index, value) in at.inputs.iter().enumerate() {
        response(Changed::Input(index), *value, right);
        add(right);
    }
    // A Jacobian that is singular to all digits determines nothing.
    for condition in conditions.iter_mut().filter(|condition| !condition.is_finite()) {
        *condition = f64::INFINITY;
    }
}

/// Computes [`Mechanism::condition`](crate::Mechanism::condition).
pub(crate) fn condition<M: Mechanism>(
    mechanism: &M,
    inputs: &M::Inputs<M::Scalar>,
    unknowns: &M::Unknowns<M::Scalar>,
) -> f64 {
    let description = M::DESCRIPTION;
    let parameters = mechanism.parameters();
    let lengths = |quantities: &'static [Quantity<'static>], values: &[M::Scalar]| {
        let lengths = quantities.iter().zip(values);
        lengths
            .filter(|(quantity, _)| quantity.dimension == Dimension::Length)
            .fold(0.0, |longest: f64, (_, value)| longest.max(value.real().abs()))
    };
    let longest = lengths(description.parameters, parameters.as_ref())
        .max(lengths(description.inputs, inputs.as_ref()))
        .max(lengths(description.unknowns, unknowns.as_ref()));
    let conditions = conditions(mechanism, inputs, unknowns);
    let unknowns = description.unknowns.iter().zip(unknowns.as_ref());
    unknowns
        .zip(conditions.as_ref())
        .fold(0.0, |largest, ((quantity, value), condition)| {
            let size = match quantity.dimension {
                Dimension::Angle => 1.0,
                Dimension::Length if longest > 0.0 => longest,
                Dimension::Length => 1.0,
                Dimension::Scalar => value.real().abs().max(1.0),
            };
            largest.max(condition / size)
        })
}
