//! Two independent oracles for any mechanism, and the tolerance that they are held to.
//!
//! (a) The position solution is run on nested dual numbers along the inputs' Taylor polynomials: its derivatives in time
//! are what the generated solvers should give. (b) The generated derivatives are put back as a truncated Taylor series
//! into the equations as they were declared: what is left must vanish at every order. The two share no code.
//!
//! # Tolerance
//! Let κ be the condition of the Jacobian, its columns scaled by the sizes of the unknowns and its rows by the terms of the
//! equations, w the largest |x⁽ᵏ⁾|^(1/k)
//! over all quantities x (lengths relative to the mechanism's size) and k, and no less than the rate at which the scaled
//! Jacobian changes, which is beyond that of the quantities where a function of them is steep. Every term of an n-th derivative is of the size
//! wⁿ at most, and is computed to a few ε. Solving J q = r multiplies the error of r by κ, and the position, in error
//! by ε κ itself, enters J: so an n-th derivative is known to ε κ² wⁿ times a number that depends on the count of
//! terms. Errors are given in these units.

use kin_core::prelude::*;

use crate::mechanisms::cases::ThroughSnap;
use kin_core::series::Series;
use num_dual::{Dual, Dual64, HyperDual, HyperDual64, HyperHyperDual64};

/// Motions of the unknowns through snap.
pub type Motions<M> = <M as Mechanism>::Unknowns<Motion<f64, 5>>;
/// Motions of the inputs through snap.
pub type Inputs<M> = <M as Mechanism>::Inputs<Motion<f64, 5>>;

/// The inputs at a time that is any kind of number, from their derivatives at zero.
fn at<M: ThroughSnap, S: Scalar>(inputs: &Inputs<M>, time: S) -> <M::With<S> as Mechanism>::Inputs<S> {
    <<M::With<S> as Mechanism>::Inputs<S> as Row<S>>::from_fn(|index| {
        let [x, v, a, j, s] = inputs.as_ref()[index].derivatives().map(S::constant);
        let term = |rate: S, below: f64| rate * S::constant(1.0 / below);
        x + time * (v + time * (term(a, 2.0) + time * (term(j, 6.0) + time * term(s, 24.0))))
    })
}

fn run<M: ThroughSnap, S: Scalar>(
    mechanism: &M,
    inputs: &Inputs<M>,
    assembly: M::Assembly,
    time: S,
) -> Result<Vec<S>, SolveError> {
    let lifted = mechanism.convert(S::constant);
    let unknowns = lifted.solve_position(at::<M, S>(inputs, time), assembly)?;
    Ok(unknowns.as_ref().to_vec())
}

/// How many units of error are allowed, order by order: the number of terms in an n-th derivative, generously. Bell's and
/// Leibniz's sums multiply it by about five an order.
pub const ALLOWED: [f64; 5] = [16.0, 32.0, 128.0, 512.0, 2048.0];

/// Oracle (a): the unknowns' derivatives by differentiating the position solution.
///
/// # Errors
/// As the position solver.
pub fn by_differentiation<M: ThroughSnap>(
    mechanism: &M,
    inputs: &Inputs<M>,
    assembly: M::Assembly,
) -> Result<Vec<[f64; 5]>, SolveError> {
    let second = run(mechanism, inputs, assembly, HyperDual64::new(0.0, 1.0, 1.0, 0.0))?;
    let third = run(
        mechanism,
        inputs,
        assembly,
        HyperHyperDual64::new(0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0),
    )?;
    let zero = HyperDual64::from(0.0);
    let one = HyperDual64::from(1.0);
    let time = HyperDual::new(HyperDual64::new(0.0, 1.0, 1.0, 0.0), one, one, zero);
    let fourth = run(mechanism, inputs, assembly, time)?;
    Ok((0..second.len())
        .map(|index| {
            [
                second[index].re,
                second[index].eps1,
                second[index].eps1eps2,
                third[index].eps1eps2eps3,
                fourth[index].eps1eps2.eps1eps2,
            ]
        })
        .collect())
}

/// Oracle (b): what is left of each equation, order by order, when the motions are put into it.
pub fn closure<M: ThroughSnap>(mechanism: &M, inputs: &Inputs<M>, unknowns: &Motions<M>) -> Vec<[f64; 5]> {
    type S = Series<5>;
    let lifted = mechanism.convert(S::constant);
    let series = |motion: &Motion<f64, 5>| S::from_derivatives(motion.derivatives());
    let inputs = <<M::With<S> as Mechanism>::Inputs<S> as Row<S>>::from_fn(|index| series(&inputs.as_ref()[index]));
    let unknowns =
        <<M::With<S> as Mechanism>::Unknowns<S> as Row<S>>::from_fn(|index| series(&unknowns.as_ref()[index]));
    lifted
        .residuals(inputs, unknowns)
        .as_ref()
        .iter()
        .map(|left| left.derivatives())
        .collect()
}

/// What errors are measured against at a pose.
pub struct Gauge {
    /// The condition of the scaled Jacobian.
    pub condition: f64,
    /// The largest rate, as a frequency.
    pub frequency: f64,
    /// The largest rate of an input.
    pub driving: f64,
    /// The natural size of each unknown.
    pub sizes: Vec<f64>,
    /// The size of each equation's terms.
    pub rows: Vec<f64>,
}

impl Gauge {
    /// The gauge at a pose.
    pub fn new<M: ThroughSnap>(mechanism: &M, inputs: &Inputs<M>, unknowns: &Motions<M>) -> Self {
        let description = M::DESCRIPTION;
        let is_length = |quantity: &kin_core::Quantity| quantity.dimension == kin_core::Dimension::Length;
        let parameters = mechanism.parameters();
        let lengths = description
            .parameters
            .iter()
            .zip(parameters.as_ref())
            .chain(description.inputs.iter().zip(values(inputs.as_ref()).iter()))
            .chain(description.unknowns.iter().zip(values(unknowns.as_ref()).iter()))
            .filter(|(quantity, _)| is_length(quantity))
            .fold(0.0_f64, |largest, (_, value)| largest.max(value.abs()));
        let natural = |quantity: &kin_core::Quantity, motion: &Motion<f64, 5>| {
            if is_length(quantity) {
                lengths
            } else {
                motion.value().abs().max(1.0)
            }
        };
        let sizes: Vec<f64> = description
            .unknowns
            .iter()
            .zip(unknowns.as_ref())
            .map(|(quantity, motion)| natural(quantity, motion))
            .collect();
        let frequency = |quantities: &[kin_core::Quantity], motions: &[Motion<f64, 5>]| {
            let mut largest = 0.0_f64;
            for (quantity, motion) in quantities.iter().zip(motions) {
                let size = natural(quantity, motion);
                for (rate, order) in motion.derivatives().into_iter().zip(0_i32..).skip(1) {
                    largest = largest.max((rate.abs() / size).powf(1.0 / f64::from(order)));
                }
            }
            largest
        };
        let driving = frequency(description.inputs, inputs.as_ref());
        let mut frequency = driving.max(frequency(description.unknowns, unknowns.as_ref()));
        let (mut jacobian, others) = gradients(mechanism, inputs, unknowns);
        let rates = jacobian_rates(mechanism, inputs, unknowns);
        let mut rows = Vec::new();
        for ((row, others), rates) in jacobian.iter_mut().zip(others).zip(rates) {
            for (entry, size) in row.iter_mut().zip(&sizes) {
                *entry *= size;
            }
            let size = row
                .iter()
                .chain(&others)
                .fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
            for entry in row.iter_mut() {
                *entry /= size;
            }
            for (rate, own) in rates.into_iter().zip(&sizes) {
                frequency = frequency.max(rate.abs() * own / size);
            }
            rows.push(size);
        }
        Self {
            condition: condition(jacobian),
            frequency,
            driving,
            sizes,
            rows,
        }
    }

    /// The unit of error of an unknown's n-th derivative, against oracle (a).
    #[must_use]
    pub fn unknown(&self, index: usize, order: usize) -> f64 {
        self.unit(order, self.frequency.max(self.condition * self.driving)) * self.sizes[index]
    }

    /// The unit of what is left of an equation's n-th derivative.
    #[must_use]
    pub fn equation(&self, index: usize, order: usize) -> f64 {
        self.unit(order, self.frequency) * self.rows[index]
    }

    fn unit(&self, order: usize, frequency: f64) -> f64 {
        let power = i32::try_from(order).expect("orders are small");
        f64::EPSILON * self.condition * self.condition * frequency.powi(power)
    }
}

fn values(motions: &[Motion<f64, 5>]) -> Vec<f64> {
    motions.iter().map(Motion::value).collect()
}

/// The equations' partial derivatives by dual numbers: by the unknowns, and by parameters and inputs times these themselves,
/// which is how much a relative error in one of them shifts an equation.
fn gradients<M: ThroughSnap>(
    mechanism: &M,
    inputs: &Inputs<M>,
    unknowns: &Motions<M>,
) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
    type D = Dual64;
    let (unknowns, inputs) = (values(unknowns.as_ref()), values(inputs.as_ref()));
    let parameters = mechanism.parameters().as_ref().to_vec();
    // the column of one quantity, counted through unknowns, parameters and inputs
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
            .residuals(lifted_inputs, lifted_unknowns)
            .as_ref()
            .iter()
            .map(|left| left.eps)
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

/// The time derivative of each of the equations' partial derivatives by the unknowns, row by row.
fn jacobian_rates<M: ThroughSnap>(mechanism: &M, inputs: &Inputs<M>, unknowns: &Motions<M>) -> Vec<Vec<f64>> {
    // outside along time, inside along one unknown
    type D = Dual<Dual64>;
    let lifted = mechanism.convert(<D as Scalar>::constant);
    let number = |motion: &Motion<f64, 5>, seed: f64| {
        D::new(Dual64::new(motion.value(), seed), Dual64::new(motion.velocity(), 0.0))
    };
    let inputs =
        <<M::With<D> as Mechanism>::Inputs<D> as Row<D>>::from_fn(|index| number(&inputs.as_ref()[index], 0.0));
    let columns: Vec<_> = (0..unknowns.as_ref().len())
        .map(|seeded| {
            let unknowns = <<M::With<D> as Mechanism>::Unknowns<D> as Row<D>>::from_fn(|index| {
                number(&unknowns.as_ref()[index], if index == seeded { 1.0 } else { 0.0 })
            });
            lifted.residuals(inputs, unknowns)
        })
        .collect();
    (0..columns.len())
        .map(|row| columns.iter().map(|column| column.as_ref()[row].eps.eps).collect())
        .collect()
}

/// ‖A⁻¹‖ in the maximum norm, which is the condition of a matrix scaled to rows of size 1, by Gauss-Jordan elimination with row pivoting.
fn condition(matrix: Vec<Vec<f64>>) -> f64 {
    let size = matrix.len();
    let norm = |rows: &[Vec<f64>]| {
        rows.iter()
            .map(|row| row.iter().map(|entry| entry.abs()).sum::<f64>())
            .fold(0.0_f64, f64::max)
    };
    let mut left = matrix;
    let mut inverse: Vec<Vec<f64>> = (0..size)
        .map(|row| (0..size).map(|column| if row == column { 1.0 } else { 0.0 }).collect())
        .collect();
    for step in 0..size {
        let pivot = (step..size)
            .max_by(|&a, &b| left[a][step].abs().total_cmp(&left[b][step].abs()))
            .expect("there is a row left");
        left.swap(step, pivot);
        inverse.swap(step, pivot);
        let scale = left[step][step];
        for column in 0..size {
            left[step][column] /= scale;
            inverse[step][column] /= scale;
        }
        for row in (0..size).filter(|&row| row != step) {
            let factor = left[row][step];
            for column in 0..size {
                left[row][column] -= factor * left[step][column];
                inverse[row][column] -= factor * inverse[step][column];
            }
        }
    }
    norm(&inverse).max(1.0)
}

/// The worst error seen, order by order, in the units of [`Gauge`].
#[derive(Clone, Copy, Debug, Default)]
pub struct Worst {
    /// Oracle (a).
    pub differentiation: [f64; 5],
    /// Oracle (b).
    pub closure: [f64; 5],
    /// How many poses were looked at.
    pub poses: usize,
}

impl Worst {
    /// Solves at one motion and holds the result against both oracles. Motions at which the mechanism does not close are
    /// passed over.
    ///
    /// # Panics
    /// If the position solution can be found, but not on dual numbers.
    pub fn check<M: ThroughSnap>(&mut self, mechanism: &M, inputs: Inputs<M>, assembly: M::Assembly) {
        let Ok(pose) = mechanism.solve_motion(inputs, assembly) else {
            return;
        };
        let unknowns = pose.unknown_motions();
        let gauge = Gauge::new(mechanism, &inputs, &unknowns);
        let expected = by_differentiation(mechanism, &inputs, assembly).expect("it closes on dual numbers, too");
        for (index, (motion, expected)) in unknowns.as_ref().iter().zip(expected).enumerate() {
            for (order, (own, other)) in motion.derivatives().into_iter().zip(expected).enumerate() {
                let error = (own - other).abs() / gauge.unknown(index, order);
                self.differentiation[order] = larger(self.differentiation[order], error);
            }
        }
        for (index, left) in closure(mechanism, &inputs, &unknowns).into_iter().enumerate() {
            for (order, left) in left.into_iter().enumerate() {
                let error = left.abs() / gauge.equation(index, order);
                self.closure[order] = larger(self.closure[order], error);
            }
        }
        self.poses += 1;
    }

    /// Prints the worst errors and asserts that they are small multiples of the unit.
    ///
    /// # Panics
    /// If one is not, or if there were hardly any poses.
    pub fn report(&self, name: &str) {
        let row = |errors: [f64; 5]| errors.map(|error| format!("{error:9.3}")).join(" ");
        println!(
            "{name:32} {:6} poses, differentiation {}",
            self.poses,
            row(self.differentiation)
        );
        println!("{:32} {:6}        closure         {}", "", "", row(self.closure));
        assert!(self.poses > 50, "{name}: only {} poses", self.poses);
        self.assert_allowed(name);
    }

    /// Asserts that the worst errors are small multiples of the unit.
    ///
    /// # Panics
    /// If one is not.
    pub fn assert_allowed(&self, name: &str) {
        for errors in [self.differentiation, self.closure] {
            for (order, (error, allowed)) in errors.into_iter().zip(ALLOWED).enumerate() {
                assert!(error <= allowed, "{name}, order {order}: {error} units of error");
            }
        }
    }
}

/// The larger of two numbers, and NaN if one of them is.
fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}
