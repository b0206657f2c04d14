//! The random data of the campaign's mechanisms.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use kin_core::{Description, Dimension, Quantity};
use kin_declarations::Linearised;

use super::bounded::{Bounded, TERMS};
use super::topology::{Problem, Rates, Topology};
use kin_tests::random::Random;

/// Where the numbers come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Family {
    /// Lengths within a decade.
    Ordinary,
    /// The same in any unit of length.
    Scaled,
    /// Each length in a unit of its own.
    Spread,
    /// Whole numbers and right angles: links in line, equal, or without length.
    Aligned,
    /// Ordinary but for one or two numbers: zero, equal to another, negative, subnormal, huge, infinite, no number at
    /// all.
    Special,
    /// Angles many turns away.
    Turned,
}

impl Family {
    /// All of them.
    pub(crate) const ALL: [Self; 6] = [
        Self::Ordinary,
        Self::Scaled,
        Self::Spread,
        Self::Aligned,
        Self::Special,
        Self::Turned,
    ];
}

/// A problem, and a position that closes if one is known.
#[derive(Clone, Debug)]
pub(crate) struct Draw {
    /// Dimensions and inputs.
    pub(crate) problem: Problem,
    /// Values of the unknowns: near a position, or of one.
    pub(crate) near: Vec<f64>,
    /// Whether these values close.
    pub(crate) is_closed: bool,
}

/// Numbers that are special to floating-point arithmetic.
const SPECIALS: [f64; 14] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    5e-324,
    1e-310,
    f64::MIN_POSITIVE,
    1e-160,
    1e160,
    -1e300,
    f64::MAX,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

/// Draws a problem for a mechanism.
pub(crate) fn draw(topology: &Topology, family: Family, random: &mut Random) -> Draw {
    let description = topology.description();
    let decades = [1.0, 2.0, 4.0, 8.0][choice(random, 4)];
    let mut values = |quantities: &[Quantity]| -> Vec<f64> {
        quantities
            .iter()
            .map(|quantity| value(quantity, family, decades, random))
            .collect()
    };
    let mut parameters = values(description.parameters);
    let mut inputs = values(description.inputs);
    let mut near = values(description.unknowns);
    let mut is_closed = false;
    if family != Family::Aligned
        && let Some(closed) = closed(topology, &parameters, &inputs, &near)
    {
        (parameters, near) = closed;
        is_closed = true;
    }
    if family == Family::Scaled {
        let scale = size(random, 8.0);
        let scaled = |quantities: &[Quantity], values: &mut [f64]| {
            for (quantity, value) in quantities.iter().zip(values) {
                if quantity.dimension == Dimension::Length {
                    *value *= scale;
                }
            }
        };
        scaled(description.parameters, &mut parameters);
        scaled(description.inputs, &mut inputs);
        scaled(description.unknowns, &mut near);
    }
    let mut inputs: Vec<Rates> = inputs
        .into_iter()
        .zip(description.inputs)
        .map(|(value, quantity)| motion(value, quantity, random))
        .collect();
    if family == Family::Special {
        is_closed = false;
        for _ in 0..=choice(random, 2) {
            spoil(&mut parameters, &mut inputs, random);
        }
    }
    if family == Family::Turned {
        // The turns are rounded, so that the position closes no longer to the last digit.
        is_closed = false;
        turn(description.inputs, inputs.iter_mut().map(|rates| &mut rates[0]), random);
        turn(description.unknowns, near.iter_mut(), random);
    }
    Draw {
        problem: Problem { parameters, inputs },
        near,
        is_closed,
    }
}

/// One of so many.
pub(crate) fn choice(random: &mut Random, count: usize) -> usize {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "it is a small number"
    )]
    let index = random.between(0.0, count as f64) as usize;
    index.min(count - 1)
}

/// A size, its logarithm uniform over so many decades up and down.
fn size(random: &mut Random, decades: f64) -> f64 {
    10.0_f64.powf(random.between(-decades, decades))
}

fn sign(random: &mut Random) -> f64 {
    if choice(random, 2) == 0 { 1.0 } else { -1.0 }
}

fn value(quantity: &Quantity, family: Family, decades: f64, random: &mut Random) -> f64 {
    // The part of a point has a dot in its name.
    let is_part = quantity.name.contains('.');
    match (family, quantity.dimension) {
        (Family::Aligned, Dimension::Angle) => FRAC_PI_2 * [0.0, 0.0, 1.0, -1.0, 2.0, -2.0][choice(random, 6)],
        (Family::Aligned, Dimension::Length) if is_part => f64::from(u8::from(choice(random, 2) == 0)) * whole(random),
        (Family::Aligned, _) => whole(random),
        (_, Dimension::Angle) => random.between(-PI, PI),
        (Family::Spread, Dimension::Length) => sign_of(is_part, random) * size(random, decades),
        (_, Dimension::Length) => sign_of(is_part, random) * size(random, 0.5),
        (_, Dimension::Scalar) => sign(random) * size(random, 0.5),
    }
}

fn sign_of(is_part: bool, random: &mut Random) -> f64 {
    if is_part { sign(random) } else { 1.0 }
}

fn whole(random: &mut Random) -> f64 {
    [1.0, 2.0, 3.0, 4.0, 5.0][choice(random, 5)]
}

/// A motion about a value, at rest now and then.
fn motion(value: f64, quantity: &Quantity, random: &mut Random) -> Rates {
    let size_of = if quantity.dimension == Dimension::Length {
        value.abs()
    } else {
        1.0
    };
    let rate = if choice(random, 8) == 0 { 0.0 } else { size(random, 1.0) };
    let mut power = size_of;
    let mut rates = [value; TERMS];
    for entry in &mut rates[1..] {
        power *= rate;
        *entry = power * random.between(-1.0, 1.0);
    }
    rates
}

/// Replaces a number by a special one.
fn spoil(parameters: &mut [f64], inputs: &mut [Rates], random: &mut Random) {
    let special = match choice(random, SPECIALS.len() + 3) {
        0 => parameters.get(choice(random, parameters.len())).copied().unwrap_or(0.0),
        1 => -parameters.get(choice(random, parameters.len())).copied().unwrap_or(1.0),
        2 => [FRAC_PI_2, PI, -PI, TAU][choice(random, 4)],
        other => SPECIALS[other - 3],
    };
    let count = parameters.len() + inputs.len() * TERMS;
    let place = choice(random, count);
    if let Some(parameter) = parameters.get_mut(place) {
        *parameter = special;
    } else {
        let rest = place - parameters.len();
        inputs[rest / TERMS][rest % TERMS] = special;
    }
}

fn turn<'a>(quantities: &[Quantity], values: impl Iterator<Item = &'a mut f64>, random: &mut Random) {
    for (quantity, value) in quantities.iter().zip(values) {
        if quantity.dimension == Dimension::Angle {
            *value += TAU * (sign(random) * size(random, 6.0)).round();
        }
    }
}

/// Dimensions and unknowns that close, as near to the given ones as Newton's method with steps of least norm leads.
fn closed(topology: &Topology, parameters: &[f64], inputs: &[f64], unknowns: &[f64]) -> Option<(Vec<f64>, Vec<f64>)> {
    let Description {
        parameters: dimensions,
        unknowns: sought,
        ..
    } = topology.description();
    let quantities: Vec<&Quantity> = dimensions.iter().chain(*sought).collect();
    let inputs: Vec<Bounded> = inputs.iter().copied().map(Bounded::rounded).collect();
    let closure = |values: &[Bounded]| {
        let (parameters, unknowns) = values.split_at(parameters.len());
        topology.closure(parameters, &inputs, unknowns)
    };
    let linearised = |values: &[f64]| {
        let mut leaves: Vec<Bounded> = values.iter().copied().map(Bounded::rounded).collect();
        let rows = closure(&leaves);
        let mut jacobian = vec![Vec::new(); rows.len()];
        for (place, value) in values.iter().enumerate() {
            let still = std::mem::replace(&mut leaves[place], Bounded::moving(*value, 1.0));
            for (row, left) in jacobian.iter_mut().zip(closure(&leaves)) {
                row.push(left.value()[1]);
            }
            leaves[place] = still;
        }
        Linearised {
            left: rows.iter().map(|row| row.value()[0]).collect(),
            rounding: rows.iter().map(|row| f64::EPSILON * row.error[0]).collect(),
            jacobian,
        }
    };
    let is_angle = |place: usize| quantities[place].dimension == Dimension::Angle;
    let closed = kin_declarations::closed(&[parameters, unknowns].concat(), is_angle, linearised)?;
    let (parameters, unknowns) = closed.split_at(parameters.len());
    Some((parameters.to_vec(), unknowns.to_vec()))
}
