//! Gaps between two rows that both close.
//!
//! At both ends of a gap an unknown y is a root of the distance d from the end: y' grows with 1/√d and has opposite
//! signs on the two sides, while y'' is large and of the same sign. So the change of y' between two rows disagrees with
//! the one that y'' at both rows predicts, by more than y' itself. On a smooth curve, the difference falls with the
//! third power of the step. Steps that disagree are halved until they agree, or until a point that does not close is
//! met.

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;
use core::f64::consts::PI;

use super::drive::Variable;
use super::table::Table;
use super::untyped::UntypedSweep;
use crate::any::AssemblyOver;
use crate::batch::{Kernel, Vectors};
use crate::mechanism::{Block, Description};
use crate::number::{Number, NumberRow, series::Series};
use crate::quantity::Dimension;

/// A value with two derivatives.
pub(super) type Bend = Series<3>;

/// The disagreement of a step, as a part of the slopes at its ends, from which on it is halved.
const SUSPECT: f64 = 0.5;
/// A disagreement by rounding errors, as a part of the value.
const ROUNDING: f64 = 1e-12;
/// The shortest step, as a part of the way between two rows. A narrower gap counts as a change point.
const SHORTEST_STEP: f64 = 1e-9;
/// The most poses between two rows. A kink of a law takes about sixty.
const MOST_POSES: usize = 500;

/// The pairs of rows that may have a gap between them, by the rows in front of it.
pub(super) fn suspects(sweep: &UntypedSweep<'_>, table: &Table) -> Vec<usize> {
    let rows = 0..table.count.saturating_sub(1);
    if rows.is_empty() || !sweep.has_assemblies() {
        // coupled blocks are tracked from row to row
        return Vec::new();
    }
    if sweep.drive.variable() == Variable::Row {
        return rows
            .filter(|row| closes(table, *row) && may_part(sweep.description, table, *row))
            .collect();
    }
    let (description, orders) = (sweep.description, sweep.orders());
    let time = match sweep.drive.variable() {
        Variable::Input(lead) if orders > 1 => 1.0 / sweep.motions(sweep.from)[lead * orders + 1],
        _ => 1.0,
    };
    if orders < 3 || !time.is_finite() {
        return rows.filter(|row| closes(table, *row)).collect();
    }
    let variables = table.values(table.variable);
    let first = table.first_unknown(description);
    let columns = |unknown: usize| {
        let column = first + unknown * orders;
        (table.values(column + 1), table.values(column + 2))
    };
    // All unknowns of a block are roots at the ends of a gap, so that one of them is enough.
    let of_block = |block: &Block<'_>| {
        let name = block.unknowns.split(", ").next();
        description
            .unknowns
            .iter()
            .position(|unknown| name == Some(unknown.name))
    };
    let unknowns = description.blocks.iter().filter_map(of_block);
    // most sweeps have none, which is found out for several rows at once
    let any = |unknown: usize| {
        let (velocity, acceleration) = columns(unknown);
        Vectors::widest().run(AnyDisagrees {
            variables,
            velocity,
            acceleration,
            time,
        })
    };
    if !unknowns.clone().any(any) {
        return Vec::new();
    }
    let pair = |column: &[f64], row: usize| [column[row], column[row + 1]];
    let has_gap = |row: &usize| {
        let step = variables[row + 1] - variables[*row];
        unknowns.clone().any(|unknown| {
            let (velocity, acceleration) = columns(unknown);
            disagrees(time * step, pair(velocity, *row), pair(acceleration, *row))
        })
    };
    rows.filter(has_gap).collect()
}

/// Whether there may be a gap on the straight line between the inputs of two rows of columns.
///
/// The rates of the only input convert those of the unknowns into derivatives with respect to the input, unless the
/// input stands still. All other pairs are solved again. An angle that moves by more than half a revolution does not
/// say in which direction.
fn may_part(description: &Description<'_>, table: &Table, row: usize) -> bool {
    let orders = description.order + 1;
    let pair = |quantity: usize, order: usize| {
        let column = table.values(1 + quantity * orders + order);
        [column[row], column[row + 1]]
    };
    let ways = description.inputs.iter().enumerate().map(|(input, quantity)| {
        let [start, end] = pair(input, 0);
        (quantity.dimension, end - start)
    });
    if ways.clone().all(|(_, way)| way == 0.0)
        || ways
            .clone()
            .any(|(dimension, way)| dimension == Dimension::Angle && way.abs() > PI)
    {
        return false;
    }
    let ([_], true) = (description.inputs, orders >= 3) else {
        return true;
    };
    let [[start, end], velocities, accelerations] = [0, 1, 2].map(|order| pair(0, order));
    (0..description.unknowns.len()).any(|unknown| {
        let [rates, second_rates] = [1, 2].map(|order| pair(1 + unknown, order));
        let [left, right] = [0, 1].map(|side| {
            let slope = rates[side] / velocities[side];
            let bend = (second_rates[side] - slope * accelerations[side]) / (velocities[side] * velocities[side]);
            [slope, bend]
        });
        let predicted = 0.5 * (end - start) * (left[1] + right[1]);
        let disagreement = (right[0] - left[0] - predicted).abs();
        let allowed = SUSPECT * (left[0].abs() + right[0].abs());
        // at rest the rates are no numbers, so that the pair is solved again
        disagreement.partial_cmp(&allowed).is_none_or(Ordering::is_gt)
    })
}

/// Whether the change of a velocity over an interval of time disagrees with the accelerations at its ends.
#[cfg_attr(not(debug_assertions), inline(always))]
fn disagrees(time: f64, [one, other]: [f64; 2], [first, last]: [f64; 2]) -> bool {
    let predicted = 0.5 * time * (first + last);
    // a comparison with NaN fails, so that rows which do not close are left out
    (other - one - predicted).abs() > SUSPECT * (one.abs() + other.abs())
}

/// The question whether any step of a column disagrees.
struct AnyDisagrees<'a> {
    variables: &'a [f64],
    velocity: &'a [f64],
    acceleration: &'a [f64],
    /// The time for each unit of the variable.
    time: f64,
}

impl Kernel for AnyDisagrees<'_> {
    type Result = bool;
    type Element = f64;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<const W: usize, const BITS: usize>(self) -> bool {
        let ends = self.variables.iter().zip(&self.variables[1..]);
        let velocities = self.velocity.iter().zip(&self.velocity[1..]);
        let accelerations = self.acceleration.iter().zip(&self.acceleration[1..]);
        let all = ends.zip(velocities.zip(accelerations));
        all.fold(false, |any, ((start, end), ((one, other), (first, last)))| {
            any | disagrees(self.time * (end - start), [*one, *other], [*first, *last])
        })
    }
}

fn closes(table: &Table, row: usize) -> bool {
    table.outcomes[row].is_solved() && table.outcomes[row + 1].is_solved()
}

/// A point between two rows that does not close, if there is one.
pub(super) fn unclosed_between(
    sweep: &UntypedSweep<'_>,
    bends: &dyn AssemblyOver<Bend>,
    [start, end]: [f64; 2],
) -> Option<f64> {
    let (from, to) = (sweep.inputs(start), sweep.inputs(end));
    let mut search = Search {
        sweep,
        bends,
        assembly: sweep.assembly.index()?,
        parameters: sweep.parameters.iter().copied().map(Bend::constant).collect(),
        slopes: NumberRow::from_fn(from.len(), |input| (to[input] - from[input]) / (end - start)),
        shortest: SHORTEST_STEP * (end - start).abs(),
        budget: MOST_POSES,
    };
    let (left, right) = (search.bends(start)?, search.bends(end)?);
    search.unclosed(start, &left, end, &right)
}

struct Search<'c> {
    sweep: &'c UntypedSweep<'c>,
    bends: &'c dyn AssemblyOver<Bend>,
    assembly: usize,
    parameters: Vec<Bend>,
    /// The inputs' change for each unit of the variable.
    slopes: NumberRow,
    shortest: f64,
    budget: usize,
}

impl Search<'_> {
    /// The unknowns with their derivatives with respect to the variable, or nothing where the mechanism does not close.
    fn bends(&mut self, at: f64) -> Option<Vec<Bend>> {
        self.budget = self.budget.saturating_sub(1);
        let values = self.sweep.inputs(at);
        let moving = values.iter().zip(self.slopes.iter());
        let inputs: Vec<Bend> = moving
            .map(|(value, slope)| Bend::from_coefficients([*value, *slope, 0.0]))
            .collect();
        let mut unknowns = vec![Bend::constant(0.0); self.sweep.description.unknowns.len()];
        let found = self
            .bends
            .position_of_assembly(&self.parameters, &inputs, self.assembly, &mut unknowns);
        found.is_ok().then_some(unknowns)
    }

    fn unclosed(&mut self, start: f64, left: &[Bend], end: f64, right: &[Bend]) -> Option<f64> {
        let step = end - start;
        let is_suspect = left.iter().zip(right).any(|(left, right)| {
            let [value, one, first] = left.derivatives();
            let [_, other, last] = right.derivatives();
            let disagreement = (other - one - 0.5 * step * (first + last)).abs();
            (step * disagreement).abs()
                > SUSPECT * (step * (one.abs() + other.abs())).abs() + ROUNDING * value.abs().max(1.0)
        });
        let middle = f64::midpoint(start, end);
        if !is_suspect || step.abs() <= self.shortest || self.budget == 0 {
            return None;
        }
        let Some(between) = self.bends(middle) else {
            return Some(middle);
        };
        self.unclosed(start, left, middle, &between)
            .or_else(|| self.unclosed(middle, &between, end, right))
    }
}
