//! The limits where a mechanism begins or ceases to close.

use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use super::drive::Variable;
use super::gaps::{self, Bend};
use super::table::Table;
use super::untyped::UntypedSweep;
use crate::any::AssemblyOver;
use crate::curve::LimitKind;
use crate::number::NumberRow;
use crate::quantity::{Digits, Name};
use crate::track::{TrackError, track_between};

/// A limit where a sweep begins or ceases to close.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// The value of the variable of the sweep, exact to rounding.
    pub at: f64,
    /// The kind.
    pub kind: LimitKind,
    /// The last row before it.
    pub row: usize,
    /// Whether the mechanism closes before the limit; otherwise it closes behind it.
    pub closes_before: bool,
    /// The unknowns of the block that does not close, separated by commas.
    pub block: Name,
    /// The inputs there.
    pub inputs: Vec<f64>,
    /// The unknowns there, with angles unwrapped along the sweep. At an end of a range they are those just inside of
    /// it, by a part of up to 10⁻⁶ of the way from the row that closes; they are NaN if the mechanism does not close
    /// there.
    pub unknowns: Vec<f64>,
    /// The name of the variable.
    pub(super) variable: Name,
}

impl fmt::Display for Limit {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = self.kind;
        let side = if self.closes_before { "up to" } else { "from" };
        write!(
            formatter,
            "closes {side} {} = {}: {kind} of {}",
            self.variable,
            Digits(self.at),
            self.block
        )
    }
}

/// The limit between a point that closes, with its unknowns, and one that does not.
pub(crate) fn between(sweep: &UntypedSweep<'_>, closed: f64, unknowns: &[f64], unclosed: f64) -> Option<Limit> {
    let (from, to) = (sweep.inputs(closed), sweep.inputs(unclosed));
    let error = track_between(sweep.mechanism, &sweep.parameters, &from, unknowns, &to).err()?;
    let limit = |kind, block, there: &[f64], fraction, unknowns| Limit {
        at: variable_at(sweep, (closed, &from), (unclosed, &to), there, fraction),
        kind,
        row: 0,
        closes_before: closed < unclosed,
        block,
        inputs: there.to_vec(),
        unknowns,
        variable: sweep.variable_name(),
    };
    if let TrackError::Failed(failure) = error {
        // the first point beyond: found by the inputs that the error keeps
        let mut there = to.clone();
        for (input, (_, value)) in failure.inputs.iter().enumerate() {
            there[input] = value;
        }
        let unknowns = inside(sweep, &from, unknowns, &there);
        return Some(limit(LimitKind::End, failure.block, &there, None, unknowns));
    }
    let (kind, obstacle) = error.limit()?;
    let (there, unknowns) = (&obstacle.inputs, obstacle.unknowns.clone());
    Some(limit(kind, obstacle.block, there, Some(obstacle.fraction), unknowns))
}

/// The distances from an end of a range at which the unknowns are sought, as parts of the way to it.
const INSIDE: [f64; 3] = [1e-12, 1e-9, 1e-6];

/// The unknowns as close to an end of a range as the mechanism closes, from a point that closes.
fn inside(sweep: &UntypedSweep<'_>, from: &[f64], unknowns: &[f64], end: &[f64]) -> Vec<f64> {
    let at = |part: f64| NumberRow::from_fn(end.len(), |input| end[input] - part * (end[input] - from[input]));
    let track = |part: &f64| {
        let found = track_between(sweep.mechanism, &sweep.parameters, from, unknowns, &at(*part));
        found.ok()
    };
    let found = INSIDE.iter().find_map(track);
    found.unwrap_or_else(|| vec![f64::NAN; unknowns.len()])
}

/// The number of halvings after which neighbouring numbers are left.
const HALVINGS: usize = 128;

/// The value of the variable at which the inputs lie between two others.
fn variable_at(
    sweep: &UntypedSweep<'_>,
    (closed, from): (f64, &[f64]),
    (unclosed, to): (f64, &[f64]),
    inputs: &[f64],
    fraction: Option<f64>,
) -> f64 {
    match sweep.drive.variable() {
        Variable::Input(lead) => inputs[lead],
        Variable::Row => closed + fraction.unwrap_or(1.0) * (unclosed - closed),
        Variable::Time => {
            let mut movers = (0..from.len()).filter(|input| from[*input] != to[*input]);
            let (only, more) = (movers.next(), movers.next());
            let is_before = |at: f64| {
                if let (Some(input), None) = (only, more) {
                    return (sweep.inputs(at)[input] - from[input]).abs() < (inputs[input] - from[input]).abs();
                }
                sweep.closes(at)
            };
            let (mut low, mut high) = (closed, unclosed);
            for _ in 0..HALVINGS {
                let middle = f64::midpoint(low, high);
                if middle == low || middle == high {
                    break;
                }
                if is_before(middle) {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            low
        }
    }
}

/// Finds the limits between the rows of a table. `jumps` are the rows behind which an angle jumps.
pub(super) fn find(
    sweep: &UntypedSweep<'_>,
    bends: &dyn AssemblyOver<Bend>,
    table: &mut Table,
    is_closed: bool,
    jumps: &[usize],
) {
    let mut suspects = gaps::suspects(sweep, table);
    suspects.extend(jumps);
    suspects.sort_unstable();
    suspects.dedup();
    if suspects.is_empty() && is_closed {
        return;
    }
    let mut suspects = suspects.into_iter().peekable();
    let (first, orders) = (table.first_unknown(sweep.description), sweep.orders());
    let count = sweep.description.unknowns.len();
    let unknowns =
        |table: &Table, row: usize| NumberRow::from_fn(count, |unknown| table.values(first + unknown * orders)[row]);
    for row in 0..table.count.saturating_sub(1) {
        let is_suspect = suspects.next_if_eq(&row).is_some();
        let variables = table.values(table.variable);
        let (start, end) = (variables[row], variables[row + 1]);
        let sides = match [row, row + 1].map(|row| table.outcomes[row].is_solved()) {
            [true, false] => [Some((row, end)), None],
            [false, true] => [None, Some((row + 1, start))],
            [true, true] if is_suspect => match gaps::unclosed_between(sweep, bends, [start, end]) {
                Some(unclosed) => [Some((row, unclosed)), Some((row + 1, unclosed))],
                // where branches cross or a length goes to infinity, both rows may close and nothing lies between them
                None => [Some((row, end)), None],
            },
            _ => continue,
        };
        for (closed, unclosed) in sides.into_iter().flatten() {
            let last = table.values(table.variable)[closed];
            if let Some(mut limit) = between(sweep, last, &unknowns(table, closed), unclosed) {
                limit.row = row;
                limit.closes_before = closed == row;
                table.limits.push(limit);
            }
        }
    }
}
