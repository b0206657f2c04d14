//! The effect of rounding on a motion: the unit of error.
//!
//! An engine that is given rounded numbers and rounds what it finds cannot do better than their exact solution does. So
//! the condition of q⁽ⁿ⁾ is the sum, over everything that is rounded, of the change that this makes of q⁽ⁿ⁾ by itself,
//! divided by the relative error of rounding. What is rounded, each once:
//!
//! - every parameter, and every derivative of every input: |p ∂q⁽ⁿ⁾/∂p|;
//! - every term of every equation, and of its derivatives, by itself: in the n-th derivative the terms J⁽ᵏ⁾ q⁽ⁿ⁻ᵏ⁾ of
//!   Leibniz's sum, where an angle's own term is that of a radian, as its direction is rounded. For the linear
//!   equations of one order this is the condition |J⁻¹| |J| |q⁽ⁿ⁾| of R. D. Skeel, *Scaling for numerical stability in
//!   Gaussian elimination*, Journal of the ACM 26 (1979), pages 494 to 526;
//! - q⁽ⁿ⁾ itself.
//!
//! The changes are those of the linearised equations. With p₀ the derivative of the closure by p, as a series in time
//! along the motion, and J the Jacobian, likewise, the change x of the motion is the solution of J(t) x(t) = -p₀(t),
//! order by order.

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
    /// The motion's change by a change of the equations, told by row and power of time.
    fn response(&self, change: impl Fn(usize, usize) -> Number) -> Vec<Vec<Number>> {
        let mut response: Vec<Vec<Number>> = Vec::new();
        for power in 0..self.jacobians.len() {
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

    /// The size of the terms of each equation at a power of time, for unknowns of given sizes at each power.
    fn terms(&self, sizes: &[Vec<f64>], power: usize) -> Vec<f64> {
        let term = |row: usize| {
            let jacobians = self.jacobians[..=power].iter().zip(sizes[..=power].iter().rev());
            let entries = jacobians.flat_map(|(jacobian, sizes)| jacobian[row].iter().zip(sizes));
            entries.map(|(entry, size)| entry.nearest().abs() * size).sum()
        };
        (0..self.inverse.len()).map(term).collect()
    }
}

/// The conditions of each unknown's coefficients, first as they are, and then with each coefficient rounded before it
/// is used for the next power of time.
pub(super) fn conditions<M: Mechanism>(equations: &Equations<M>, count: usize) -> Result<[Vec<Vec<f64>>; 2], Stray> {
    let arguments = &equations.arguments;
    let before = equations.left(arguments, count);
    let columns = equations.columns(&before, count);
    let jacobians: Vec<Matrix> = (0..count).map(|power| matrix(&columns, power)).collect();
    let inverse = inverse(jacobians[0].clone()).ok_or(Stray::Singular)?;
    let linearised = Linearised { jacobians, inverse };
    let size = arguments.unknowns.len();

    let own = |index: usize, power: usize| arguments.unknowns[index].coefficient(power).nearest().abs();
    let mut sums: Vec<Vec<f64>> = (0..size)
        .map(|index| (0..count).map(|power| own(index, power)).collect())
        .collect();

    let sizes: Vec<Vec<f64>> = (0..count)
        .map(|power| {
            let unknowns = M::DESCRIPTION.unknowns.iter().enumerate();
            unknowns
                .map(|(index, quantity)| {
                    let is_direction = power == 0 && quantity.dimension == Dimension::Angle;
                    if is_direction { 1.0 } else { own(index, power) }
                })
                .collect()
        })
        .collect();
    let terms: Vec<Vec<f64>> = (0..count).map(|power| linearised.terms(&sizes, power)).collect();
    for row in 0..size {
        // what a change at one power of time makes of the powers above, it makes of them at any
        let response = linearised.response(|other, power| number(usize::from(other == row && power == 0)));
        for (above, unknowns) in response.iter().enumerate() {
            for (sums, unknown) in sums.iter_mut().zip(unknowns) {
                let unknown = unknown.nearest().abs();
                for (sum, terms) in sums[above..].iter_mut().zip(&terms) {
                    *sum += unknown * terms[row];
                }
            }
        }
    }

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
        add(linearised.response(|row, power| change[row].coefficient(power)));
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
            add(linearised.response(change));
        }
    }
    let carried = carried(&linearised, &sums);
    Ok([sums, carried])
}

/// The conditions of coefficients if each unknown's derivatives are off by the whole of their condition, each by
/// itself, and are carried to the powers above.
///
/// The condition proper takes the unknowns of one power together, as the solution of one and the same equations: their
/// changes may be such that they cancel in the equations of the next power. Solutions that are rounded one by one need
/// not.
fn carried(linearised: &Linearised, conditions: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mut carried = conditions.to_vec();
    for (unknown, own) in conditions.iter().enumerate() {
        // the change that makes this unknown's coefficient 1, and no other one's of that power
        let change = |row: usize, power: usize| match power {
            0 => -&linearised.jacobians[0][row][unknown],
            _ => Number::zero(),
        };
        for (above, others) in linearised.response(change).iter().enumerate().skip(1) {
            for (carried, other) in carried.iter_mut().zip(others) {
                let other = other.nearest().abs();
                for (carried, own) in carried[above..].iter_mut().zip(own).skip(1) {
                    *carried += other * own;
                }
            }
        }
    }
    carried
}
