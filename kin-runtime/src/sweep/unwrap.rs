//! The angles of a table that a batch has solved, unwrapped from row to row.
//!
//! A batch solves each row by itself, so its angles are in -π ..= π. Most tables need nothing: the rates of both rows
//! predict every change. Where they do not, a [walk](super::walk) goes from the row before to this one.

use alloc::vec::Vec;
use core::f64::consts::TAU;

use num_traits::Float;

use super::footing::{Footing, LONGEST_INPUT_STEP, LONGEST_PREDICTION, PREDICTION, WITHOUT_RATES};
use super::table::Table;
use super::untyped::{UntypedSweep, angles};
use super::walk::Walk;
use crate::batch::{Kernel, Vectors};
use crate::mechanism::Description;
use crate::number::NumberRow;
use crate::quantity::Quantity;

/// The difference of a number between two revolutions of an angle from which on it depends on the revolution, as a part
/// of its size.
const DEPENDENCE: f64 = 1e-9;

/// Unwraps all angles of a table, and writes again what depends on them. It returns the rows behind which an angle
/// jumps.
pub(super) fn unwrap(sweep: &UntypedSweep<'_>, table: &mut Table) -> Vec<usize> {
    let columns = AngleColumns {
        description: sweep.description,
        first_input: table.first_input(),
        first_unknown: table.first_unknown(sweep.description),
        orders: sweep.orders(),
        time: 1.0 / sweep.drive.rate(),
    };
    if columns.are_continuous(table) {
        return Vec::new();
    }
    let mut jumps = Vec::new();
    let mut last: Option<Footing<'_>> = None;
    let mut unclosed = None;
    let mut revolutions = Revolutions(Vec::new());
    for row in 0..table.count {
        if !table.outcomes[row].is_solved() {
            unclosed = Some(table.values(table.variable)[row]);
            continue;
        }
        let solved = columns.footing(table, row);
        let mut footing = solved.clone();
        let follows = last.as_ref().is_none_or(|from| footing.unwrap(from)) && unclosed.is_none();
        if !follows || revolutions.depends(&solved, &footing) != Some(false) {
            let mut walk = Walk {
                last,
                unclosed,
                ..Walk::BEGINNING
            };
            if let Ok(reached) = walk.step(sweep, solved.at, &sweep.motions(solved.at)) {
                if reached.has_jumped && table.outcomes[row - 1].is_solved() {
                    jumps.push(row - 1);
                }
                if revolutions.sees(&solved, reached) {
                    let numbers = table.data.chunks_exact_mut(table.count).skip(columns.first_input);
                    for (column, value) in numbers.zip(&reached.numbers) {
                        column[row] = *value;
                    }
                }
                footing = reached.clone();
            }
        }
        columns.write(table, row, &footing);
        (last, unclosed) = (Some(footing), None);
    }
    jumps
}

/// The revolutions of the unknowns by which rows have been moved, and whether other numbers of a pose depend on them:
/// the position of a rack does, that of a coupler point does not.
struct Revolutions(Vec<(NumberRow, bool)>);

impl Revolutions {
    fn between(solved: &Footing<'_>, unwrapped: &Footing<'_>) -> NumberRow {
        let (from, to) = (solved.unknowns(), unwrapped.unknowns());
        NumberRow::from_fn(to.len(), |unknown| Float::round((to[unknown] - from[unknown]) / TAU))
    }

    /// Whether other numbers depend on the revolutions of a row, if it is known.
    fn depends(&self, solved: &Footing<'_>, unwrapped: &Footing<'_>) -> Option<bool> {
        let revolutions = Self::between(solved, unwrapped);
        if angles(solved.description.unknowns).all(|unknown| revolutions[unknown] == 0.0) {
            return Some(false);
        }
        self.0
            .iter()
            .find(|known| *known.0 == *revolutions)
            .map(|known| known.1)
    }

    /// Compares a row with the pose whose angles are unwrapped.
    fn sees(&mut self, solved: &Footing<'_>, reached: &Footing<'_>) -> bool {
        let is_whole = |quantities: &[Quantity<'_>], one: &[f64], other: &[f64]| {
            let is_angle = |index: usize| angles(quantities).any(|angle| angle == index);
            one.iter().zip(other).enumerate().all(|(index, (one, other))| {
                let (difference, size) = if is_angle(index) {
                    let revolutions = (other - one) / TAU;
                    (
                        (revolutions - Float::round(revolutions)).abs(),
                        one.abs().max(other.abs()).max(1.0),
                    )
                } else {
                    ((other - one).abs(), one.abs().max(other.abs()))
                };
                difference <= DEPENDENCE * size
            })
        };
        let description = solved.description;
        let depends = !is_whole(description.unknowns, &solved.unknowns(), &reached.unknowns())
            || !is_whole(description.outputs, &solved.outputs(), &reached.outputs());
        if self.depends(solved, reached).is_none() {
            self.0.push((Self::between(solved, reached), depends));
        }
        depends
    }
}

/// The columns of a table that hold inputs, unknowns and outputs.
struct AngleColumns<'c> {
    description: &'c Description<'c>,
    first_input: usize,
    first_unknown: usize,
    orders: usize,
    /// The time for each unit of the variable.
    time: f64,
}

impl<'c> AngleColumns<'c> {
    /// The columns of the values of all unknowns and outputs that are angles.
    fn results(&self) -> impl Iterator<Item = usize> + use<'c> {
        let Description { unknowns, outputs, .. } = self.description;
        let (first, orders) = (self.first_unknown, self.orders);
        let outputs = angles(outputs).map(|output| unknowns.len() + output);
        angles(unknowns).chain(outputs).map(move |index| first + index * orders)
    }

    /// Whether the rates predict every angle in every row, so that no revolution is missing.
    fn are_continuous(&self, table: &Table) -> bool {
        let variables = table.values(table.variable);
        let inputs_are_close = angles(self.description.inputs).all(|input| {
            let values = table.values(self.first_input + input * self.orders);
            Vectors::widest().run(MovesBy {
                values,
                most: LONGEST_INPUT_STEP,
            })
        });
        let is_predicted = |column: usize| {
            let values = table.values(column);
            if self.orders > 1 && self.time.is_finite() {
                let rates = table.values(column + 1);
                return Vectors::widest().run(IsPredicted {
                    variables,
                    values,
                    rates,
                    time: self.time,
                });
            }
            let most = WITHOUT_RATES;
            Vectors::widest().run(MovesBy { values, most })
        };
        inputs_are_close && self.results().all(is_predicted)
    }

    /// The values and rates of a row.
    fn footing(&self, table: &Table, row: usize) -> Footing<'c> {
        let columns = table.data.chunks_exact(table.count).skip(self.first_input);
        let values_and_rates = columns.enumerate().filter(|(index, _)| index % self.orders < 2);
        Footing {
            at: table.values(table.variable)[row],
            numbers: values_and_rates.map(|(_, column)| column[row]).collect(),
            orders: self.orders.min(2),
            time: self.time,
            description: self.description,
            near: None,
            has_jumped: false,
        }
    }

    /// Writes the angles of a row.
    fn write(&self, table: &mut Table, row: usize, footing: &Footing<'_>) {
        let count = table.count;
        for column in self.results() {
            let index = (column - self.first_input) / self.orders;
            table.data[column * count + row] = footing.motion(index)[0];
        }
    }
}

/// The question whether a column moves by no more than a limit from row to row. A row that does not close counts as a
/// larger step.
struct MovesBy<'a> {
    values: &'a [f64],
    most: f64,
}

impl Kernel for MovesBy<'_> {
    type Result = bool;
    type Element = f64;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<const W: usize, const BITS: usize>(self) -> bool {
        let pairs = self.values.iter().zip(self.values.get(1..).unwrap_or_default());
        pairs.fold(true, |all, (one, other)| all & ((other - one).abs() <= self.most))
    }
}

/// The question whether the rates predict each change of an angle.
struct IsPredicted<'a> {
    variables: &'a [f64],
    values: &'a [f64],
    rates: &'a [f64],
    /// The time for each unit of the variable.
    time: f64,
}

impl Kernel for IsPredicted<'_> {
    type Result = bool;
    type Element = f64;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<const W: usize, const BITS: usize>(self) -> bool {
        let half = 0.5 * self.time;
        let variables = self.variables.iter().zip(self.variables.get(1..).unwrap_or_default());
        let values = self.values.iter().zip(self.values.get(1..).unwrap_or_default());
        let rates = self.rates.iter().zip(self.rates.get(1..).unwrap_or_default());
        variables
            .zip(values.zip(rates))
            .fold(true, |all, ((start, end), ((one, other), (first, last)))| {
                let predicted = half * (end - start) * (first + last);
                all & ((other - one - predicted).abs() <= PREDICTION) & (predicted.abs() <= LONGEST_PREDICTION)
            })
    }
}
