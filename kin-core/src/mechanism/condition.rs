//! The condition of a position: how strongly it depends on rounding of the numbers it was found from.

use crate::mechanism::Mechanism;
use crate::number::{Number, Row, series::Series};
use crate::quantity::{Dimension, Quantity};
use crate::solve::{LentFactors, lent_factors_length};

/// A value and its first-order change.
type FirstOrder = Series<2>;

/// The quantity that changes, by its index.
#[derive(Clone, Copy, PartialEq)]
enum Changed {
    Parameter(usize),
    Input(usize),
    Unknown(usize),
}

/// Computes [`Mechanism::conditions`](crate::Mechanism::conditions).
pub(crate) fn conditions<M: Mechanism>(
    mechanism: &M,
    inputs: &M::Inputs<M::Scalar>,
    unknowns: &M::Unknowns<M::Scalar>,
) -> M::Unknowns<f64> {
    let parameters = mechanism.parameters();
    let values = |row: &[M::Scalar], index: usize| row[index].real();
    // The change of each equation with a quantity, times a number.
    let response = |quantity: Changed, by: f64| {
        let series = |varied: Changed, value: f64| {
            let change = if varied == quantity { by } else { 0.0 };
            FirstOrder::from_coefficients([value, change])
        };
        let changed = <M::With<FirstOrder>>::from_parameters(Row::from_fn(|index| {
            series(Changed::Parameter(index), values(parameters.as_ref(), index))
        }));
        let residuals = changed.closure(
            Row::from_fn(|index| series(Changed::Input(index), values(inputs.as_ref(), index))),
            Row::from_fn(|index| series(Changed::Unknown(index), values(unknowns.as_ref(), index))),
        );
        M::Unknowns::<f64>::from_fn(|equation| residuals[equation].coefficients()[1])
    };

    let mut jacobian: M::Unknowns<M::Unknowns<f64>> = Row::splat(Row::splat(0.0));
    let mut terms: M::Unknowns<f64> = Row::splat(0.0);
    for (index, quantity) in M::DESCRIPTION.unknowns.iter().enumerate() {
        let column = response(Changed::Unknown(index), 1.0);
        // The direction of a link is rounded, not its angle.
        let size = match quantity.dimension {
            Dimension::Angle => 1.0,
            _ => values(unknowns.as_ref(), index).abs(),
        };
        let rows: &mut [M::Unknowns<f64>] = jacobian.as_mut();
        for ((row, terms), entry) in rows.iter_mut().zip(terms.as_mut()).zip(column.as_ref()) {
            row[index] = *entry;
            *terms += entry.abs() * size;
        }
    }
    let mut conditions = M::Unknowns::from_fn(|index| values(unknowns.as_ref(), index).abs());
    M::lend(|lent| {
        let count = M::DESCRIPTION.unknowns.len();
        let memory = &mut lent.numbers[..lent_factors_length(count)];
        let factored = LentFactors::new(memory, count, |row, column| jacobian[row][column]);
        let mut add = |right: M::Unknowns<f64>| {
            let mut change = right;
            factored.solve(right.as_ref(), change.as_mut());
            for (condition, change) in conditions.as_mut().iter_mut().zip(change.as_ref()) {
                *condition += change.abs();
            }
        };
        for (row, terms) in terms.as_ref().iter().enumerate() {
            add(Row::from_fn(|other| if other == row { *terms } else { 0.0 }));
        }
        for (index, value) in parameters.as_ref().iter().enumerate() {
            add(response(Changed::Parameter(index), value.real()));
        }
        for (index, value) in inputs.as_ref().iter().enumerate() {
            add(response(Changed::Input(index), value.real()));
        }
    });
    // A Jacobian that is singular to all digits determines nothing.
    M::Unknowns::from_fn(|index| {
        let condition: f64 = conditions[index];
        if condition.is_finite() {
            condition
        } else {
            f64::INFINITY
        }
    })
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
