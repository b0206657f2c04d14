//! Two oracles for the partial derivatives by the parameters, and the tolerance that they are held to.
//!
//! (a) The whole solution, position to snap, is run on dual numbers, one parameter at a time as their variable: the
//! sensitivities are the dual parts. (b) Unknowns and sensitivities are put into the equations as they were declared,
//! as truncated Taylor series in time whose coefficients are dual numbers in the parameter: what is left must vanish at
//! every order. The two share no code with each other, and none with the sensitivities.
//!
//! # Tolerance
//! A sensitivity S of order n is the solution of a linear system with the Jacobian, whose right-hand side is made of
//! motions and of sensitivities of lower order. Let σ be the largest of all |p S⁽ᵏ⁾| / (size wᵏ) for a parameter p, and
//! no less than one: how many times the relative error of the parameter becomes that of the motion. Then S⁽ⁿ⁾ is known
//! to σ / p times the unit ε κ² wⁿ of the motion itself (see [`Gauge`]).

use kin_core::prelude::*;
use kin_core::verify::Inputs;
use kin_core::{Dimension, Quantity};
use num_dual::{Dual, Dual3, Dual64};

use crate::mechanisms::cases::ThroughSnap;
use crate::mechanisms::sensitive::SensitiveThroughSnap;
use crate::oracles::{ALLOWED, Gauge, Motions};
use crate::samples;

/// The derivatives of one motion by one parameter.
pub type Orders = [f64; 5];

/// Unknowns, then outputs.
#[derive(Clone, Debug)]
pub struct Column {
    /// Of each unknown.
    pub unknowns: Vec<Orders>,
    /// Of each scalar output.
    pub outputs: Vec<Orders>,
}

/// The partial derivatives to be proved: a column for each parameter.
pub fn generated<M: SensitiveThroughSnap>(mechanism: &M, pose: &M::Pose) -> Vec<Column> {
    mechanism.sensitivities_of(pose).as_ref().iter().map(column).collect()
}

/// Those that any mechanism has, by numbers that carry a derivative.
///
/// # Panics
/// If the mechanism does not close.
pub fn at_run_time<M: ThroughSnap>(mechanism: &M, inputs: &Inputs<M>, assembly: M::Assembly) -> Vec<Column> {
    let partials = mechanism.sensitivities_at(*inputs, assembly).expect("it closes");
    partials.as_ref().iter().map(column).collect()
}

fn column<P: Partials<Motion = Motion<f64, 5>>>(partials: &P) -> Column {
    let (unknowns, outputs) = (partials.unknown_partials(), partials.output_partials());
    Column {
        unknowns: unknowns.as_ref().iter().map(Motion::derivatives).collect(),
        outputs: outputs.as_ref().iter().map(Motion::derivatives).collect(),
    }
}

/// The mechanism with one parameter as the variable of dual numbers.
fn seeded<M: ThroughSnap, S: Scalar>(mechanism: &M, parameter: usize, step: S) -> M::With<S> {
    let mut next = 0;
    mechanism.convert(|value| {
        next += 1;
        let value = S::constant(value);
        if next - 1 == parameter { value + step } else { value }
    })
}

/// Oracle (a).
///
/// # Panics
/// If the mechanism closes, but not on dual numbers.
pub fn by_differentiation<M: ThroughSnap>(mechanism: &M, inputs: &Inputs<M>, assembly: M::Assembly) -> Vec<Column> {
    type Lifted<M> = <M as Mechanism>::With<Dual64>;
    let parameters = mechanism.parameters().as_ref().len();
    let inputs = <<Lifted<M> as Mechanism>::Inputs<M::Motion<Dual64>> as Row<_>>::from_fn(|index| {
        let motion = inputs[index];
        <M::Motion<Dual64> as Row<Dual64>>::from_fn(|order| <Dual64 as Number>::constant(motion[order]))
    });
    (0..parameters)
        .map(|parameter| {
            let lifted: M::With<Dual64> = seeded(mechanism, parameter, Dual64::new(0.0, 1.0));
            let pose = lifted.solve(inputs, assembly).expect("it closes on dual numbers, too");
            let parts = |motion: &M::Motion<Dual64>| core::array::from_fn(|order| motion[order].eps);
            Column {
                unknowns: pose.unknown_motions().as_ref().iter().map(parts).collect(),
                outputs: pose.output_motions().as_ref().iter().map(parts).collect(),
            }
        })
        .collect()
}

/// A number that holds four derivatives in time, and the derivatives of them all by a parameter.
type Both = Dual<Dual<Dual3<f64>>>;

fn in_time([x, v, a, j, s]: Orders) -> Dual<Dual3<f64>> {
    Dual::new(Dual3::new(x, v, a, j), Dual3::new(v, a, j, s))
}

/// Oracle (b): what is left of each equation, order by order, for one parameter.
pub fn closure<M: ThroughSnap>(
    mechanism: &M,
    inputs: &Inputs<M>,
    unknowns: &Motions<M>,
    parameter: usize,
    column: &Column,
) -> Vec<Orders> {
    let still = in_time([0.0; 5]);
    let lifted: M::With<Both> = seeded(
        mechanism,
        parameter,
        Both::new(still, in_time([1.0, 0.0, 0.0, 0.0, 0.0])),
    );
    let inputs = <<M::With<Both> as Mechanism>::Inputs<Both> as Row<Both>>::from_fn(|index| {
        Both::new(in_time(inputs[index].derivatives()), still)
    });
    let unknowns = <<M::With<Both> as Mechanism>::Unknowns<Both> as Row<Both>>::from_fn(|index| {
        Both::new(in_time(unknowns[index].derivatives()), in_time(column.unknowns[index]))
    });
    lifted
        .closure(inputs, unknowns)
        .as_ref()
        .iter()
        .map(|left| {
            let (low, high) = (left.eps.re, left.eps.eps);
            [low.re, low.v1, low.v2, low.v3, high.v3]
        })
        .collect()
}

/// The worst error seen, order by order, in the units above.
#[derive(Clone, Copy, Debug, Default)]
pub struct Worst {
    /// Oracle (a) for unknowns.
    pub unknowns: Orders,
    /// Oracle (a) for outputs.
    pub outputs: Orders,
    /// Oracle (b).
    pub closure: Orders,
    /// How many poses were looked at.
    pub poses: usize,
}

impl Worst {
    /// Solves at one motion and holds the sensitivities of the pose against both oracles. Motions at which the
    /// mechanism does not close are passed over.
    ///
    /// # Panics
    /// If the mechanism closes, but not on dual numbers.
    pub fn check<M: ThroughSnap>(
        &mut self,
        mechanism: &M,
        inputs: Inputs<M>,
        assembly: M::Assembly,
        columns: impl Fn(&M::Pose) -> Vec<Column>,
    ) {
        let Ok(pose) = mechanism.solve(inputs, assembly) else {
            return;
        };
        let unknowns = pose.unknown_motions();
        let outputs = pose.output_motions();
        let gauge = Gauge::new(mechanism, &inputs, &unknowns);
        let columns = columns(&pose);
        let expected = by_differentiation(mechanism, &inputs, assembly);
        let parameters = mechanism.parameters();
        for (parameter, (own, other)) in columns.iter().zip(&expected).enumerate() {
            let natural = size(
                M::DESCRIPTION.parameters[parameter],
                parameters[parameter],
                gauge.length,
            );
            let mut amplification = 1.0_f64;
            let w = gauge.frequency.max(gauge.condition * gauge.driving);
            for (orders, size) in other.unknowns.iter().zip(&gauge.sizes) {
                amplification = amplification.max(natural * relative(orders, *size, w));
            }
            let factor = amplification / natural;
            for (index, (own, other)) in own.unknowns.iter().zip(&other.unknowns).enumerate() {
                for order in 0..5 {
                    let unit = gauge.unknown(index, order) * factor;
                    grow(&mut self.unknowns[order], (own[order] - other[order]).abs() / unit);
                }
            }
            for (index, (own, other)) in own.outputs.iter().zip(&other.outputs).enumerate() {
                let motion = outputs[index];
                let quantity = M::DESCRIPTION.outputs[index];
                let size = size(quantity, motion.value(), gauge.length);
                let w = w.max(fastest(&motion.derivatives(), size));
                let factor = amplification.max(natural * relative(other, size, w)) / natural;
                for order in 0..5 {
                    let unit = gauge.output(&quantity, &motion.derivatives(), order) * factor;
                    grow(&mut self.outputs[order], (own[order] - other[order]).abs() / unit);
                }
            }
            let left = closure(mechanism, &inputs, &unknowns, parameter, own);
            for (index, left) in left.into_iter().enumerate() {
                for (order, left) in left.into_iter().enumerate() {
                    let unit = gauge.equation(index, order) * factor;
                    grow(&mut self.closure[order], left.abs() / unit);
                }
            }
        }
        self.poses += 1;
    }

    /// Prints the worst errors and asserts that they are small multiples of the unit.
    ///
    /// # Panics
    /// If one is not, or if there were hardly any poses.
    pub fn report(&self, name: &str) {
        for (label, errors) in [
            ("unknowns", self.unknowns),
            ("outputs", self.outputs),
            ("closure", self.closure),
        ] {
            let row = errors.map(|error| format!("{error:9.3}")).join(" ");
            println!("{name:32} {:6} poses, {label:8} {row}", self.poses);
        }
        assert!(self.poses > samples::of(50), "{name}: only {} poses", self.poses);
        for errors in [self.unknowns, self.outputs, self.closure] {
            for (order, (error, allowed)) in errors.into_iter().zip(ALLOWED).enumerate() {
                assert!(error <= allowed, "{name}, order {order}: {error} units of error");
            }
        }
    }
}

/// The natural size of a quantity.
fn size(quantity: Quantity, value: f64, lengths: f64) -> f64 {
    if quantity.dimension == Dimension::Length {
        lengths.max(value.abs())
    } else {
        value.abs().max(1.0)
    }
}

/// The largest derivative, of a size at a frequency.
fn relative(orders: &Orders, size: f64, frequency: f64) -> f64 {
    orders
        .iter()
        .zip(0_i32..)
        .filter(|(derivative, _)| **derivative != 0.0)
        .map(|(derivative, order)| derivative.abs() / (size * frequency.powi(order)))
        .fold(0.0, f64::max)
}

/// The rate at which a quantity of a given size changes, as a frequency.
fn fastest(orders: &Orders, size: f64) -> f64 {
    orders
        .iter()
        .zip(0_i32..)
        .skip(1)
        .map(|(rate, order)| (rate.abs() / size).powf(1.0 / f64::from(order)))
        .fold(0.0, f64::max)
}

/// The larger of two numbers, and NaN if one of them is.
fn grow(worst: &mut f64, error: f64) {
    if error.is_nan() || *worst < error {
        *worst = error;
    }
}
