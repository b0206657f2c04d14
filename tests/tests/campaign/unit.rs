//! How well a pose is known, and how well it closes: both from the closure.

use kin_core::{Description, Dimension, Number};

use super::bounded::{Bounded, FACTORIAL, TERMS};
use super::linear::{Matrix, determinant, inverse};
use super::topology::{Problem, Rates, Topology};

/// The facts that are known of a pose.
///
/// The unit of error of a derivative is ε times its condition. The condition is the sum of all changes that the
/// following make of it, each rounded once and by itself, divided by the relative error of rounding: every parameter,
/// input and derivative of an input, every operation by which the closure is evaluated, the derivative itself, and the
/// derivatives below it, which are known to their own units. It is found by the bounds that [`Bounded`] carries through
/// the closure and the inverse of the Jacobian. An angle's own rounding is that of a radian, as it is the direction
/// that is rounded.
///
/// The second link of a dyad is the difference of two vectors, either of which may be the longer one, so that it is
/// known to ε of that, and what hangs on it inherits the error. Where the lengths of a mechanism differ by more than a
/// decade, conditions are larger by as much.
#[derive(Clone, Debug)]
pub(crate) struct Units {
    /// The condition of each derivative of each unknown.
    pub(crate) conditions: Vec<Rates>,
    /// By how much each derivative of each unknown would have to be changed for the closure to vanish.
    pub(crate) corrections: Vec<Rates>,
    /// The determinant of each block's Jacobian, its rows measured by the terms of the equations and its columns by the
    /// sizes of the unknowns.
    pub(crate) determinants: Vec<f64>,
    /// The largest condition of a position, in sizes of the unknowns.
    pub(crate) condition: f64,
}

/// How the error of a pose of given motions can be measured; `None` where a number on the way is not finite, as in a
/// singular position.
pub(crate) fn units(topology: &Topology, problem: &Problem, unknowns: &[Rates]) -> Option<Units> {
    let description = topology.description();
    let jacobian = jacobian(topology, problem, unknowns);
    let inverse = inverse(&jacobian);
    let mut leaves = Leaves::new(description, problem, unknowns);
    let spread = spread(description, problem);
    let mut conditions = vec![[0.0; TERMS]; unknowns.len()];
    let mut corrections = conditions.clone();
    for order in 0..TERMS {
        let rows = leaves.closure(topology);
        for (place, row) in inverse.iter().enumerate() {
            let (mut error, mut correction) = (0.0, 0.0);
            for (entry, left) in row.iter().zip(&rows) {
                error += entry.abs() * left.error[order];
                correction += entry * left.value()[order];
            }
            let own = &mut leaves.unknowns[place].error[order];
            *own = own.max(error);
            conditions[place][order] = spread * *own * FACTORIAL[order];
            corrections[place][order] = correction.abs() * FACTORIAL[order];
        }
    }
    let all = conditions.iter().chain(&corrections).flatten();
    if !all.into_iter().all(|value| value.is_finite()) {
        return None;
    }
    let sizes = sizes(description, problem, unknowns);
    let relative = conditions.iter().zip(sizes).map(|(own, size)| own[0] / size);
    Some(Units {
        condition: relative.fold(0.0, f64::max),
        determinants: determinants(topology, problem, unknowns),
        conditions,
        corrections,
    })
}

/// The determinants of the blocks at a position, as [`Units::determinants`].
pub(crate) fn determinants(topology: &Topology, problem: &Problem, unknowns: &[Rates]) -> Vec<f64> {
    let description = topology.description();
    let mut jacobian = jacobian(topology, problem, unknowns);
    let terms = Leaves::new(description, problem, unknowns).closure(topology);
    let sizes = sizes(description, problem, unknowns);
    for (row, terms) in jacobian.iter_mut().zip(terms) {
        for (entry, size) in row.iter_mut().zip(&sizes) {
            *entry *= size / terms.error[0];
        }
    }
    let blocks = description.blocks.iter();
    blocks
        .map(|block| {
            let rows = block.equations.iter();
            let rows = rows.map(|row| block.members.iter().map(|column| jacobian[*row][*column]).collect());
            determinant(rows.collect())
        })
        .collect()
}

/// The arguments of the closure, all of them rounded.
struct Leaves {
    parameters: Vec<Bounded>,
    inputs: Vec<Bounded>,
    unknowns: Vec<Bounded>,
}

impl Leaves {
    fn new(description: &Description, problem: &Problem, unknowns: &[Rates]) -> Self {
        let mut unknowns: Vec<Bounded> = unknowns.iter().copied().map(Bounded::from_derivatives).collect();
        for (leaf, quantity) in unknowns.iter_mut().zip(description.unknowns) {
            if quantity.dimension == Dimension::Angle {
                leaf.error[0] = leaf.error[0].max(1.0);
            }
        }
        Self {
            parameters: problem.parameters.iter().copied().map(Bounded::rounded).collect(),
            inputs: problem.inputs.iter().copied().map(Bounded::from_derivatives).collect(),
            unknowns,
        }
    }

    fn closure(&self, topology: &Topology) -> Vec<Bounded> {
        topology.closure(&self.parameters, &self.inputs, &self.unknowns)
    }
}

/// The sizes of the unknowns: of an angle or a number one at least, of a length the largest that is given.
fn sizes(description: &Description, problem: &Problem, unknowns: &[Rates]) -> Vec<f64> {
    let largest = lengths(description, problem).into_iter().fold(0.0, f64::max);
    let pairs = unknowns.iter().zip(description.unknowns);
    pairs
        .map(|(rates, quantity)| match quantity.dimension {
            Dimension::Length => rates[0].abs().max(largest),
            _ => rates[0].abs().max(1.0),
        })
        .collect()
}

/// By how many decades beyond one the lengths of a mechanism differ, as a factor.
fn spread(description: &Description, problem: &Problem) -> f64 {
    let lengths = lengths(description, problem);
    let largest = lengths.iter().copied().fold(0.0, f64::max);
    let least = lengths
        .into_iter()
        .filter(|length| *length > 0.0)
        .fold(f64::INFINITY, f64::min);
    (largest / least / 10.0).max(1.0)
}

/// The magnitudes of all lengths that are given, of a point or vector that of the whole.
fn lengths(description: &Description, problem: &Problem) -> Vec<f64> {
    let mut lengths: Vec<f64> = Vec::new();
    let mut last = "";
    let quantities = description.parameters.iter().chain(description.inputs);
    for (quantity, value) in quantities.zip(problem.parameters.iter().copied().chain(problem.values())) {
        if quantity.dimension != Dimension::Length {
            continue;
        }
        // the parts of a point `p` are `p.x` and so on, one after the other
        match quantity.name.split_once('.') {
            Some((whole, _)) if whole == last => {
                if let Some(length) = lengths.last_mut() {
                    *length = length.hypot(value);
                }
            }
            Some((whole, _)) => {
                last = whole;
                lengths.push(value.abs());
            }
            None => lengths.push(value.abs()),
        }
    }
    lengths
}

/// The derivatives of the rows of the closure by the unknowns.
fn jacobian(topology: &Topology, problem: &Problem, unknowns: &[Rates]) -> Matrix {
    let parameters: Vec<Bounded> = problem.parameters.iter().copied().map(Bounded::constant).collect();
    let inputs: Vec<Bounded> = problem.inputs.iter().map(|rates| Bounded::constant(rates[0])).collect();
    let still: Vec<Bounded> = unknowns.iter().map(|rates| Bounded::constant(rates[0])).collect();
    let mut rows = vec![Vec::new(); still.len()];
    for (place, rates) in unknowns.iter().enumerate() {
        let mut leaves = still.clone();
        leaves[place] = Bounded::moving(rates[0], 1.0);
        for (row, left) in rows.iter_mut().zip(topology.closure(&parameters, &inputs, &leaves)) {
            row.push(left.value()[1]);
        }
    }
    rows
}
