//! Position and derivatives to 50 digits and more.

use std::marker::PhantomData;

use kin_core::{Dimension, Mechanism};
use kin_precise::Number;

use super::closure::{Arguments, Given, closure};
use super::linear::{Matrix, inverse, product};
use super::response::conditions;
use super::series::{Series, number};

/// Steps of Newton's method at most.
const STEPS: usize = 60;

/// Solutions of the linear equations of a power of time at most.
const REFINEMENTS: usize = 6;

/// Steps of this size, relative to the unknowns' own, are rounding: 54 digits are right.
fn rounding() -> f64 {
    2.0_f64.powi(-180)
}

/// How far an unknown is moved to see the equations change, relative to its size: half of the digits are left for the
/// change.
pub(super) const MOVE: i16 = -128;

/// The motion of a mechanism.
#[derive(Clone, Debug)]
pub struct Solution {
    /// Position and time derivatives of each unknown.
    pub motions: Vec<Vec<Number>>,
    /// The condition of each of them: by how much its rounding, and the rounding of what it is computed from, can
    /// change it, divided by the relative error of rounding.
    pub conditions: Vec<Vec<f64>>,
    /// The same where the derivatives of each order are rounded one by one before those of the next are found from
    /// them.
    pub carried: Vec<Vec<f64>>,
}

/// Why there is no reference.
#[derive(Clone, Debug, PartialEq)]
pub enum Stray {
    /// Not as many equations as unknowns.
    NotSquare,
    /// The Jacobian is singular to all digits.
    Singular,
    /// The last step is larger than rounding would make it, relative to the unknowns.
    NotConverged(f64),
}

/// The equations about a position.
pub(super) struct Equations<M> {
    pub(super) arguments: Arguments,
    /// Whole turns by which an equation of angles is off.
    turns: Vec<Number>,
    /// The size of each unknown.
    sizes: Vec<f64>,
    mechanism: PhantomData<M>,
}

impl<M: Mechanism> Equations<M> {
    /// The residuals of the equations, to `count` coefficients.
    pub(super) fn left(&self, arguments: &Arguments, count: usize) -> Vec<Series> {
        let mut left = closure::<M>(arguments, count);
        for (own, turns) in left.iter_mut().zip(&self.turns) {
            *own = own.clone().shifted(0, &-turns);
        }
        left
    }

    /// How the equations change with a quantity that is moved.
    pub(super) fn change(&self, moved: &Arguments, by: &Number, before: &[Series], count: usize) -> Vec<Series> {
        let over = Series::constant(by.clone());
        self.left(moved, count)
            .iter()
            .zip(before)
            .map(|(after, before)| after.minus(before).over(&over, count))
            .collect()
    }

    /// The Jacobian's columns, as series.
    pub(super) fn columns(&self, before: &[Series], count: usize) -> Vec<Vec<Series>> {
        (0..self.sizes.len())
            .map(|index| {
                let by = Number::exactly(self.sizes[index]).doubled(MOVE);
                let mut moved = self.arguments.clone();
                moved.unknowns[index] = moved.unknowns[index].clone().shifted(0, &by);
                self.change(&moved, &by, before, count)
            })
            .collect()
    }

    /// Newton's method for the position. The Jacobian is evaluated anew at the first two steps, after which it is good
    /// enough for the rest.
    fn converge(&mut self) -> Result<(), Stray> {
        let mut inverted = Matrix::new();
        let mut last = f64::INFINITY;
        for step in 0..STEPS {
            let left = self.left(&self.arguments, 1);
            if step < 2 {
                inverted = inverse(matrix(&self.columns(&left, 1), 0)).ok_or(Stray::Singular)?;
            }
            last = self.step(&inverted, &left, 0);
            if step >= 2 && last < rounding() {
                return Ok(());
            }
        }
        Err(Stray::NotConverged(last))
    }

    /// The coefficients of a power of time, those of the lower powers being known. The equations are linear in them;
    /// the first solution has as many digits as the Jacobian, and further ones supply the rest.
    fn follow(&mut self, inverse: &Matrix, power: usize) -> Result<(), Stray> {
        let mut first = 0.0;
        let mut last = 0.0;
        for step in 0..REFINEMENTS {
            let left = self.left(&self.arguments, power + 1);
            last = self.step(inverse, &left, power);
            if step == 0 {
                first = last;
            } else if last <= rounding() * first {
                return Ok(());
            }
        }
        Err(Stray::NotConverged(last / first))
    }

    /// Moves the coefficients of a power of time by one step of Newton's method, and tells the largest step.
    fn step(&mut self, inverse: &Matrix, left: &[Series], power: usize) -> f64 {
        let left: Vec<Number> = left.iter().map(|left| left.coefficient(power)).collect();
        let mut largest: f64 = 0.0;
        for ((unknown, step), size) in self
            .arguments
            .unknowns
            .iter_mut()
            .zip(product(inverse, &left))
            .zip(&self.sizes)
        {
            *unknown = unknown.clone().shifted(power, &-&step);
            largest = largest.max((&step / &Number::exactly(*size)).nearest().abs());
        }
        largest
    }
}

/// The entries of a Jacobian at a power of time.
pub(super) fn matrix(columns: &[Vec<Series>], power: usize) -> Matrix {
    (0..columns.len())
        .map(|row| columns.iter().map(|column| column[row].coefficient(power)).collect())
        .collect()
}

/// The motion nearest to a position, and its condition.
///
/// # Errors
/// If there is no position, or a singular one.
pub fn solution<M: Mechanism>(given: &Given, position: &[f64]) -> Result<Solution, Stray> {
    let count = M::DESCRIPTION.order + 1;
    let mut equations = start::<M>(given, position)?;

    equations.converge()?;
    let left = equations.left(&equations.arguments, 1);
    let inverted = inverse(matrix(&equations.columns(&left, 1), 0)).ok_or(Stray::Singular)?;
    for power in 1..count {
        equations.follow(&inverted, power)?;
    }

    let factorials: Vec<Number> = (0..count)
        .scan(number(1), |factorial, power| {
            *factorial = &*factorial * &number(power.max(1));
            Some(factorial.clone())
        })
        .collect();
    let motions: Vec<Vec<Number>> = equations
        .arguments
        .unknowns
        .iter()
        .map(|unknown| {
            (0..count)
                .map(|power| &unknown.coefficient(power) * &factorials[power])
                .collect()
        })
        .collect();
    let [conditions, carried] = conditions(&equations, count)?.map(|of_coefficients| {
        let of_derivatives = |own: &Vec<f64>| {
            let both = own.iter().zip(&factorials);
            both.map(|(own, factorial)| own * factorial.nearest()).collect()
        };
        of_coefficients.iter().map(of_derivatives).collect()
    });
    Ok(Solution {
        motions,
        conditions,
        carried,
    })
}

/// The whole turns in what is left of an equation at a position, none if it is no equation of angles.
fn whole_turns(left: f64) -> Number {
    let turns = left / std::f64::consts::TAU;
    let whole = if (turns - turns.round()).abs() < 1e-4 {
        turns.round()
    } else {
        0.0
    };
    &Number::exactly(whole) * &Number::pi().doubled(1)
}

/// The equations at the start, their whole turns taken off.
fn start<M: Mechanism>(given: &Given, position: &[f64]) -> Result<Equations<M>, Stray> {
    let description = M::DESCRIPTION;
    let length = description
        .parameters
        .iter()
        .zip(given.parameters.iter().copied())
        .chain(
            description
                .inputs
                .iter()
                .zip(given.inputs.iter().map(|motion| motion[0])),
        )
        .chain(description.unknowns.iter().zip(position.iter().copied()))
        .filter(|(quantity, _)| quantity.dimension == Dimension::Length)
        .fold(0.0_f64, |largest, (_, value)| largest.max(value.abs()));
    let sizes = description.unknowns.iter().zip(position).map(|(quantity, value)| {
        if quantity.dimension == Dimension::Length {
            length
        } else {
            value.abs().max(1.0)
        }
    });
    let arguments = Arguments::new(given, position);
    let left = closure::<M>(&arguments, 1);
    let turns: Vec<Number> = left
        .iter()
        .map(|left| whole_turns(left.coefficient(0).nearest()))
        .collect();
    if turns.len() != position.len() {
        return Err(Stray::NotSquare);
    }
    Ok(Equations {
        sizes: sizes.collect(),
        arguments,
        turns,
        mechanism: PhantomData,
    })
}
