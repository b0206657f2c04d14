//! The units in which errors are measured.

use std::vec;
use std::vec::Vec;

use super::carrier::Carrier;
use super::functions::VerifiedFunctions;
use super::gradients::{equations_along, gradients, jacobian_rates, rounding_errors};
use super::matrix_condition::condition;
use super::motions::{Motions, flat};
use super::{Inputs, Unknowns};
use crate::any::Of;
use crate::mechanism::Mechanism;
use crate::number::Number;
use crate::number::series::Series;
use crate::quantity::{Dimension, Quantity};

/// The units of error at a pose.
///
/// Let κ be the condition of the Jacobian, with columns scaled by the sizes of the unknowns and rows by the terms of
/// the equations. Let w be the largest |x⁽ᵏ⁾|^(1/k) over all quantities x (lengths relative to the mechanism's size)
/// and orders k. These quantities include the entries of the scaled Jacobian up to the fourth order, because the
/// entries change faster than the unknowns where a function of the unknowns is steep. They also include the divisors of
/// the equations, relative to themselves, because the n-th derivative of a/b has terms of size (b'/b)ⁿ. Every term of
/// an n-th derivative is at most of size wⁿ, and is computed with an error of a few ε. Solving J q = r multiplies the
/// error of r by κ, and J contains the position, whose error is itself ε κ. So the error of an n-th derivative is
///
/// ```text
/// ε κ² wⁿ
/// ```
///
/// times a number that depends on the count of terms, [`allowed`]. A term of an equation is the amount by which the
/// equation changes when one of its quantities has a relative error of one. Larger terms that cancel within the
/// equation show up in a bound on its rounding error, and the size of a row is at least so large that this bound is
/// allowed. The quadratic term of its Taylor polynomial exceeds the linear one near a double root, where rounding moves
/// a root further than the linear term says. The size of a row is at least that of the quadratic term.
#[derive(Clone, Debug, PartialEq)]
pub struct Gauge {
    /// The condition κ of the scaled Jacobian.
    pub condition: f64,
    /// The largest rate w, as a frequency.
    pub frequency: f64,
    /// The largest rate of an input.
    pub driving: f64,
    /// The largest rate of an equation, or of an entry of the scaled Jacobian, while the unknowns stand still.
    pub forcing: f64,
    /// The largest length.
    pub length: f64,
    /// The natural size of each unknown.
    pub sizes: Vec<f64>,
    /// The size of each equation's terms.
    pub rows: Vec<f64>,
}

impl Gauge {
    /// The gauge at a pose.
    #[must_use]
    pub fn new<M: Mechanism<Scalar = f64>>(mechanism: &M, inputs: &Inputs<M>, unknowns: &Unknowns<M>) -> Self {
        let (inputs, unknowns) = (flat(inputs.as_ref()), flat(unknowns.as_ref()));
        Self::at(Of::<M>::FUNCTIONS, mechanism.parameters().as_ref(), &inputs, &unknowns)
    }

    /// The same for a mechanism without its type.
    pub(super) fn at(functions: &dyn VerifiedFunctions, parameters: &[f64], inputs: &[f64], unknowns: &[f64]) -> Self {
        let description = functions.description();
        let orders = description.order + 1;
        let [inputs, unknowns] = [inputs, unknowns].map(|numbers| Motions::new(numbers, orders));
        let length = description
            .parameters
            .iter()
            .zip(parameters)
            .chain(description.inputs.iter().zip(&inputs.values()))
            .chain(description.unknowns.iter().zip(&unknowns.values()))
            .filter(|(quantity, _)| quantity.dimension == Dimension::Length)
            .fold(0.0_f64, |largest, (_, value)| largest.max(value.abs()));
        let fastest = |quantities: &[Quantity<'_>], motions: Motions<'_>| {
            let motions = quantities.iter().zip(motions.each());
            motions
                .map(|(quantity, motion)| frequency(motion, natural(length, quantity, motion)))
                .fold(0.0_f64, f64::max)
        };
        let sizes = description.unknowns.iter().zip(unknowns.each());
        let sizes: Vec<f64> = sizes
            .map(|(quantity, motion)| natural(length, quantity, motion))
            .collect();
        let driving = fastest(description.inputs, inputs);
        let mut frequency = driving.max(fastest(description.unknowns, unknowns));
        let (mut jacobian, others) = gradients(functions, parameters, inputs, unknowns);
        let rates = jacobian_rates(functions, parameters, inputs, unknowns);
        let rounding = rounding_errors(functions, parameters, inputs, unknowns);
        let moving = || inputs.each().map(Series::carrying);
        for equation in equations_along(functions, parameters, moving(), unknowns.each().map(Series::carrying)) {
            frequency = frequency.max(equation.frequency);
        }
        let at = unknowns.values();
        let still = at.iter().map(|value| Number::constant(*value));
        let forced = equations_along(functions, parameters, moving(), still);
        let still = at
            .iter()
            .flat_map(|value| (0..orders).map(move |order| if order == 0 { *value } else { 0.0 }));
        let still: Vec<f64> = still.collect();
        let forced_rates = jacobian_rates(functions, parameters, inputs, Motions::new(&still, orders));
        let bends = bends(functions, parameters, &inputs.values(), &at);
        let mut forcing = 0.0_f64;
        let mut rows = Vec::new();
        let beyond = rounding.into_iter().zip(bends).zip(forced).zip(forced_rates);
        for (((row, others), rates), (((rounding, bend), forced), forced_rates)) in
            jacobian.iter_mut().zip(others).zip(rates).zip(beyond)
        {
            for (entry, size) in row.iter_mut().zip(&sizes) {
                *entry *= size;
            }
            let shifts = row
                .iter()
                .chain(&others)
                .fold(0.0_f64, |largest, entry| largest.max(entry.abs()));
            for ((rates, forced_rates), size) in rates.into_iter().zip(forced_rates).zip(&sizes) {
                frequency = frequency.max(fastest_of(rates, shifts / size));
                forcing = forcing.max(fastest_of(forced_rates, shifts / size));
            }
            // Terms that cancel count too.
            let size = shifts.max(rounding / allowed(0)).max(bend);
            forcing = forcing.max(fastest_of(forced.value.derivatives().into_iter().skip(1), size));
            for entry in row.iter_mut() {
                *entry /= size;
            }
            rows.push(size);
        }
        Self {
            condition: condition(jacobian),
            frequency,
            driving,
            forcing,
            length,
            sizes,
            rows,
        }
    }

    /// The unit of error of an unknown's n-th derivative, compared with differentiation of the position. That
    /// differentiation has intermediate results that change κ times as fast as the inputs. Newton's method begins with
    /// unknowns that stand still, and so with equations that change as fast as the inputs alone drive them.
    #[must_use]
    pub fn unknown(&self, index: usize, order: usize) -> f64 {
        self.unit(order, self.solving()) * self.sizes[index]
    }

    /// The unit of error of the residual of an equation's n-th derivative.
    #[must_use]
    pub fn equation(&self, index: usize, order: usize) -> f64 {
        self.unit(order, self.frequency) * self.rows[index]
    }

    /// The unit of error of an output's n-th derivative, given its motion. If an output changes faster than the inputs,
    /// its error is larger by the same factor.
    #[must_use]
    pub fn output(&self, quantity: &Quantity<'_>, motion: &[f64], order: usize) -> f64 {
        let size_of_position = motion.first().copied().unwrap_or(0.0).abs();
        let size = natural(self.length, quantity, motion).max(size_of_position);
        let frequency_of_motion = frequency(motion, size);
        let steepness = if frequency_of_motion > self.driving && self.driving > 0.0 {
            frequency_of_motion / self.driving
        } else {
            1.0
        };
        self.unit(order, self.solving().max(frequency_of_motion)) * size * steepness
    }

    fn solving(&self) -> f64 {
        self.frequency.max(self.condition * self.driving).max(self.forcing)
    }

    fn unit(&self, order: usize, frequency: f64) -> f64 {
        // One factor per order, because there are only a few orders.
        (0..order).fold(f64::EPSILON * self.condition * self.condition, |unit, _| {
            unit * frequency
        })
    }
}

/// The largest quadratic term in the Taylor polynomials of each equation, one along each unknown.
///
/// Near a double root the linear term is small. There a position that is found from the coefficients of the equation is
/// right to the rounding of the quadratic term only. The step along an unknown is its value. It is at most a radian for
/// an angle, within which its sine and cosine change, and ends where the polynomial means nothing: where a divisor of
/// the equation may vanish.
fn bends(functions: &dyn VerifiedFunctions, parameters: &[f64], inputs: &[f64], unknowns: &[f64]) -> Vec<f64> {
    let quantities = functions.description().unknowns;
    let mut largest = vec![0.0_f64; unknowns.len()];
    for along in 0..unknowns.len() {
        let unknown = |index: usize| {
            let value = unknowns[index];
            let reach = match quantities[index].dimension {
                _ if index != along => 0.0,
                Dimension::Angle => value.clamp(-1.0, 1.0),
                Dimension::Length | Dimension::Scalar => value,
            };
            Series::from_coefficients([value, reach, 0.0, 0.0, 0.0])
        };
        let inputs = inputs.iter().map(|value| Series::constant(*value));
        let equations = equations_along(functions, parameters, inputs, (0..unknowns.len()).map(unknown));
        for (largest, equation) in largest.iter_mut().zip(equations) {
            let step = equation.frequency.max(1.0).recip();
            let [_, _, quadratic, ..] = equation.value.coefficients();
            *largest = largest.max(quadratic.abs() * step * step);
        }
    }
    largest
}

/// The natural size of a quantity: for a length that of the mechanism, for an angle or a number at least one.
fn natural(length: f64, quantity: &Quantity<'_>, motion: &[f64]) -> f64 {
    if quantity.dimension == Dimension::Length {
        length
    } else {
        motion.first().copied().unwrap_or(0.0).abs().max(1.0)
    }
}

/// The largest rate of a quantity's motion relative to its size, as a frequency.
pub(super) fn frequency(motion: &[f64], size: f64) -> f64 {
    fastest_of(motion.iter().skip(1).copied(), size)
}

/// The largest |x⁽ᵏ⁾ / size|^(1/k) of time derivatives from the first on.
fn fastest_of(rates: impl IntoIterator<Item = f64>, size: f64) -> f64 {
    rates.into_iter().zip(1_u32..).fold(0.0_f64, |largest, (rate, order)| {
        largest.max((rate.abs() / size).powf(1.0 / f64::from(order)))
    })
}

/// The number of units of error allowed in an n-th derivative: a generous count of its terms. The sums of Bell and
/// Leibniz multiply it by four to five for each order.
///
/// ```
/// use kin_core::verify::allowed;
///
/// assert_eq!([0, 1, 2, 3, 4].map(allowed), [16.0, 32.0, 128.0, 512.0, 2048.0]);
/// ```
#[must_use]
pub const fn allowed(order: usize) -> f64 {
    if order == 0 {
        return 16.0;
    }
    let mut units = 32.0;
    let mut above = 1;
    while above < order {
        units *= 4.0;
        above += 1;
    }
    units
}
