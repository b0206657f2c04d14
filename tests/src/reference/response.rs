//! What rounding makes of a motion: the unit of error.
//!
//! An engine that is given rounded numbers and rounds what it finds cannot do better than their exact solution does. So the
//! condition of q⁽ⁿ⁾ is the sum, over everything that is rounded, of the change that this makes of q⁽ⁿ⁾ by itself, divided by the
//! relative error of rounding. What is rounded, each once:
//!
//! - every parameter, and every derivative of every input: |p ∂q⁽ⁿ⁾/∂p|;
//! - the position of every unknown, and the derivatives follow; an angle is rounded as a direction is, by a fraction of a radian;
//! - every entry of the Jacobian, in the linear equations of each order: |J⁻¹| |J| |q⁽ⁿ⁾|, the condition of R. D. Skeel, *Scaling
//!   for numerical stability in Gaussian elimination*, Journal of the ACM 26 (1979), pages 494 to 526;
//! - q⁽ⁿ⁾ itself.
//!
//! The changes are those of the linearised equations. With p₀ the derivative of the closure by p, as a series in time along the
//! motion, and J the Jacobian, likewise, the change x of the motion is the solution of J(t) x(t) = -p₀(t), order by order.

use std::iter;

use kin_core::{Dimension, Mechanism};
use kin_precise::Number;

use super::linear::{Matrix, inverse, product};
use super::series::{Series, number};
use super::solution::{Equations, MOVE, Stray, matrix};

/// The linearised equations along a motion.
struct Linearised {
    /// The Jacobian's coefficients, one for each power of time.
    jacobians: Vec<Matrix>,
    /// The inverse of the first.
    inverse: Matrix,
}

impl Linearised {
    /// The motion's change by a change of the equations, where that of the position may be given.
    fn response(&self, change: impl Fn(usize, usize) -> Number, position: Option<Vec<Number>>) -> Vec<Vec<Number>> {
        let mut response: Vec<Vec<Number>> = position.into_iter().collect();
        for power in response.len()..self.jacobians.len() {
            let mut left: Vec<Number> = (0..self.inverse.len()).map(|row| change(row, power)).collect();
            for above in 1..=power {
                let carried = product(&self.jacobians[above], &response[power - above]);
                for (left, carried) in left.iter_mut().zip(carried) {
                    *left = &*left + &carried;
                }
            }
            response.push(product(&self.inverse, &left).iter().map(|step| -step).collect());
        }
        response
    }

    /// What rounded entries of the Jacobian make of the solution of the linear equations at a power of time.
    fn skeel(&self, solution: &[Number]) -> Vec<f64> {
        let magnitudes = |matrix: &Matrix| -> Matrix {
            let row = |row: &Vec<Number>| row.iter().map(Number::abs).collect();
            matrix.iter().map(row).collect()
        };
        let solution: Vec<Number> = solution.iter().map(Number::abs).collect();
        let rounded = product(&magnitudes(&self.jacobians[0]), &solution);
        let response = product(&magnitudes(&self.inverse), &rounded);
        response.iter().map(Number::nearest).collect()
    }
}

/// The conditions of each unknown's coefficients.
pub(super) fn conditions<M: Mechanism>(equations: &Equations<M>, count: usize) -> Result<Vec<Vec<f64>>, Stray> {
    let arguments = &equations.arguments;
    let before = equations.left(arguments, count);
    let columns = equations.columns(&before, count);
    let jacobians: Vec<Matrix> = (0..count).map(|power| matrix(&columns, power)).collect();
    let inverse = inverse(jacobians[0].clone()).ok_or(Stray::Singular)?;
    let linearised = Linearised { jacobians, inverse };
    let size = arguments.unknowns.len();

    let orders: Vec<Vec<Number>> = (0..count)
        .map(|power| {
            arguments
                .unknowns
                .iter()
                .map(|unknown| unknown.coefficient(power))
                .collect()
        })
        .collect();
    // the position is no solution of linear equations
    let of_jacobian: Vec<Vec<f64>> = orders[1..].iter().map(|unknowns| linearised.skeel(unknowns)).collect();
    let mut sums: Vec<Vec<f64>> = (0..size)
        .map(|index| {
            let skeel = iter::once(0.0).chain(of_jacobian.iter().map(|unknowns| unknowns[index]));
            let own = orders.iter().map(|unknowns| unknowns[index].nearest().abs());
            own.zip(skeel).map(|(own, skeel)| own + skeel).collect()
        })
        .collect();
    let mut add = |response: Vec<Vec<Number>>| {
        for (power, unknowns) in response.iter().enumerate() {
            for (sum, unknown) in sums.iter_mut().zip(unknowns) {
                sum[power] += unknown.nearest().abs();
            }
        }
    };

    let by = number(1).doubled(MOVE);
    for index in 0..arguments.parameters.len() {
        let value = arguments.parameters[index].coefficient(0);
        if value.is_zero() {
            continue;
        }
        let mut moved = arguments.clone();
        moved.parameters[index] = Series::constant(&value + &(&value * &by));
        let change = equations.change(&moved, &by, &before, count);
        add(linearised.response(|row, power| change[row].coefficient(power), None));
    }
    for index in 0..arguments.inputs.len() {
        let mut moved = arguments.clone();
        moved.inputs[index] = moved.inputs[index].clone().shifted(0, &by);
        let change = equations.change(&moved, &by, &before, count);
        // a coefficient of the input carries the change to its own power of time
        for derivative in 0..count {
            let own = arguments.inputs[index].coefficient(derivative);
            if own.is_zero() {
                continue;
            }
            let change = |row: usize, power: usize| match power.checked_sub(derivative) {
                Some(power) => &change[row].coefficient(power) * &own,
                None => Number::zero(),
            };
            add(linearised.response(change, None));
        }
    }
    for (index, quantity) in M::DESCRIPTION.unknowns.iter().enumerate() {
        let mut position = vec![Number::zero(); size];
        position[index] = if quantity.dimension == Dimension::Angle {
            number(1)
        } else {
            arguments.unknowns[index].coefficient(0)
        };
        add(linearised.response(|_, _| Number::zero(), Some(position)));
    }
    Ok(sums)
}
