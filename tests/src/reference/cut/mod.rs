//! Forces in joints of many digits: bodies cut free, and one dense system of Newton's and Euler's equations.
//!
//! Nothing of kin takes part. Joints follow from the intersections of circles, spheres and lines, without an angle but
//! the crank's, and everything is a truncated Taylor series in time.

mod plane;
mod space;

use std::cell::Cell;

use kin_precise::Number;

use super::linear::{Matrix, inverse, product};
use super::series::{Series, number};

pub use plane::{Body, Connection, Cut, Shape};
pub use space::{Inertia, Joint, JointKind, Solid, SpaceCut, SpaceShape};

/// The value and the derivatives of a motion through snap.
const COUNT: usize = 5;
/// A force has two derivatives fewer.
const ORDERS: usize = COUNT - 2;

/// A number with two derivatives by time.
pub type Rates = [Number; ORDERS];

/// Forces with their rates.
#[derive(Clone, Debug)]
pub struct Forces {
    /// The coordinates of the force of each connection, and those of its moment about its joint.
    pub connections: Vec<Vec<Rates>>,
    /// The torque of the drive.
    pub torque: Rates,
    /// The power of friction.
    pub heat: Rates,
    /// The joints.
    pub places: Vec<Vec<Number>>,
}

impl Forces {
    fn all(&self) -> impl Iterator<Item = &Number> {
        let connections = self.connections.iter().flatten().flatten();
        connections.chain(&self.torque).chain(&self.heat)
    }
}

fn constant(value: &Number) -> Series {
    Series::constant(value.clone())
}

fn zero() -> Series {
    Series::constant(Number::zero())
}

fn times(one: &Series, other: &Series) -> Series {
    one.times(other, COUNT)
}

fn rate(series: &Series) -> Series {
    let rates = (1..COUNT).map(|power| &number(power) * &series.coefficient(power));
    Series::from_coefficients(rates.collect())
}

/// Where joints are, without their motion.
fn positions<const AXES: usize>(places: &[[Series; AXES]]) -> Vec<Vec<Number>> {
    let values = |place: &[Series; AXES]| place.iter().map(|part| part.coefficient(0)).collect();
    places.iter().map(values).collect()
}

/// The value of a force and its derivatives.
fn rates(series: &Series) -> Rates {
    let mut factorial = number(1);
    core::array::from_fn(|order| {
        factorial = &factorial * &number(order.max(1));
        &series.coefficient(order) * &factorial
    })
}

/// A motion by its value and its derivatives.
fn moved(motion: &[f64; COUNT], mut given: impl FnMut(f64) -> Number) -> Series {
    let mut factorial = number(1);
    let motion = motion.iter().enumerate().map(|(order, own)| {
        factorial = &factorial * &number(order.max(1));
        &given(*own) / &factorial
    });
    Series::from_coefficients(motion.collect())
}

/// Equations of all bodies, by what a unit of each unknown exerts on them.
struct System {
    /// One for each power of time.
    matrices: Vec<Matrix>,
    inverted: Matrix,
}

impl System {
    fn new(columns: &[Vec<Series>]) -> Self {
        let at = |power: usize| -> Matrix {
            let row = |row: usize| columns.iter().map(|column| column[row].coefficient(power)).collect();
            (0..columns.len()).map(row).collect()
        };
        let matrices: Vec<Matrix> = (0..ORDERS).map(at).collect();
        let inverted = inverse(matrices[0].clone()).expect("the joints hold the bodies");
        Self { matrices, inverted }
    }

    fn solve(&self, right: &[Series]) -> Vec<Series> {
        let mut terms: Vec<Vec<Number>> = Vec::new();
        for power in 0..ORDERS {
            let mut rest: Vec<Number> = right.iter().map(|own| own.coefficient(power)).collect();
            for (before, known) in terms.iter().enumerate() {
                let known = product(&self.matrices[power - before], known);
                rest = rest.iter().zip(&known).map(|(rest, known)| rest - known).collect();
            }
            terms.push(product(&self.inverted, &rest));
        }
        let series = |index: usize| terms.iter().map(|terms| terms[index].clone()).collect();
        (0..right.len())
            .map(|index| Series::from_coefficients(series(index)))
            .collect()
    }
}

/// By so much each given number is changed to see the results change: half of the digits are left for the change.
const CHANGE: i16 = -120;

/// The forces that follow from given numbers, each times a factor, and the condition of each number in their order:
/// connections, torque, heat.
///
/// The condition is the size of the result and of its changes with every given number, so that this times the relative
/// error of rounding is what a careful calculation loses.
fn with_conditions(forces: impl Fn(&dyn Fn(usize) -> Number) -> Forces) -> (Forces, Vec<f64>) {
    let count = Cell::new(0);
    let found = forces(&|index| {
        count.set(count.get().max(index + 1));
        number(1)
    });
    let mut conditions: Vec<f64> = found.all().map(|own| own.nearest().abs()).collect();
    let by = number(1).doubled(CHANGE);
    for changed in 0..count.get() {
        let factor = |index| if index == changed { &number(1) + &by } else { number(1) };
        let more = forces(&factor);
        for (condition, (more, found)) in conditions.iter_mut().zip(more.all().zip(found.all())) {
            *condition += (&(more - found) / &by).nearest().abs();
        }
    }
    (found, conditions)
}

/// So many digits are written.
const DIGITS: i32 = 20;

/// A number by its first 20 digits.
#[must_use]
pub fn written(own: &Number) -> String {
    if own.is_zero() {
        return "0".into();
    }
    let ten = number(10);
    let power = |exponent: i32| (0..exponent.abs()).fold(number(1), |power, _| &power * &ten);
    let scale = |own: &Number, exponent: i32| {
        if exponent < 0 {
            own * &power(exponent)
        } else {
            own / &power(exponent)
        }
    };
    #[allow(clippy::cast_possible_truncation, reason = "exponents are small")]
    let mut exponent = own.nearest().abs().log10().floor() as i32;
    let half = scale(&number(5), DIGITS);
    let mut rest = &scale(&own.abs(), exponent) + &half;
    // the logarithm may be off beside a power of ten, and rounding may lead to the next one
    while rest.nearest() >= 10.0 {
        exponent += 1;
        rest = &rest / &ten;
    }
    while (&rest - &number(1)).nearest() < 0.0 {
        exponent -= 1;
        rest = &(&(&rest - &half) * &ten) + &half;
    }
    let mut text = String::from(if own.nearest() < 0.0 { "-" } else { "" });
    for place in 0..DIGITS {
        let mut digit = rest.nearest().floor().clamp(0.0, 9.0);
        if (&rest - &Number::exactly(digit)).nearest() < 0.0 {
            digit -= 1.0;
        }
        text += &digit.to_string();
        if place == 0 {
            text.push('.');
        }
        rest = &(&rest - &Number::exactly(digit)) * &ten;
    }
    format!("{text}e{exponent}")
}
