//! The angles of a table that a batch has solved, unwrapped from row to row.
//!
//! A batch solves each row by itself, so its angles are in -π ..= π. Most tables need nothing: the rates of both rows predict every change.
//! Where they do not, a [walk](super::walk) goes from the row before to this one.

use alloc::vec::Vec;
use core::f64::consts::TAU;

use num_traits::Float;

use super::Course;
use super::drive::Drive;
use super::table::Table;
use super::walk::{Footing, LONGEST, LONGEST_PREDICTION, PREDICTION, WITHOUT_RATES, Walk, angles};
use crate::batch::{Kernel, Vectors};
use crate::mechanism::Mechanism;
use crate::number::Row;
use crate::quantity::Quantity;

/// The difference of a number between two turns of an angle from which on it depends on the turn, as a part of its size.
const DEPENDENCE: f64 = 1e-9;

/// Unwraps all angles of a table, and writes again what depends on them. It returns the rows behind which an angle jumps.
pub(super) fn unwrap<M: Mechanism<Scalar = f64>, D: Drive<M>>(course: &Course<M, D>, table: &mut Table) -> Vec<usize> {
    let columns = AngleColumns::of::<M>(table);
    let time = 1.0 / course.drive.rate();
    if columns.are_continuous::<M>(table, time) {
        return Vec::new();
    }
    let mut jumps = Vec::new();
    let mut last: Option<Footing<M>> = None;
    let mut open = None;
    let mut turned = Turned::<M>(Vec::new());
    for row in 0..table.count {
        if !table.outcomes[row].is_solved() {
            open = Some(table.values(table.variable)[row]);
            continue;
        }
        let solved = columns.footing::<M>(table, row, time);
        let mut footing = solved;
        if let Some(from) = &last {
            footing.unwrap(from);
        }
        let follows = open.is_none() && last.is_none_or(|from| footing.follows(&from));
        if !follows || turned.depends(&solved, &footing) != Some(false) {
            let mut walk = Walk { last, open, gap: None };
            let motions = course.drive.motions(solved.at);
            if let Ok(reached) = walk.step(course, solved.at, motions) {
                footing = reached.footing;
                if reached.has_jumped && table.outcomes[row - 1].is_solved() {
                    jumps.push(row - 1);
                }
                if turned.sees(&solved, &footing) {
                    let (count, data) = (table.count, &mut table.data);
                    course.write(solved.at, &motions, Some(reached), |column, value| {
                        data[column * count + row] = value;
                    });
                }
            }
        }
        columns.write(table, row, &footing);
        (last, open) = (Some(footing), None);
    }
    jumps
}

/// The turns of the unknowns by which rows have been moved, and whether other numbers of a pose depend on them: the position of a rack
/// does, that of a coupler point does not.
struct Turned<M: Mechanism>(Vec<(M::Unknowns<f64>, bool)>);

impl<M: Mechanism> Turned<M> {
    fn turns(solved: &Footing<M>, unwrapped: &Footing<M>) -> M::Unknowns<f64> {
        Row::from_fn(|unknown| Float::round((unwrapped.unknowns[unknown] - solved.unknowns[unknown]) / TAU))
    }

    /// Whether other numbers depend on the turns of a row, if it is known.
    fn depends(&self, solved: &Footing<M>, unwrapped: &Footing<M>) -> Option<bool> {
        let turns = Self::turns(solved, unwrapped);
        if angles(M::DESCRIPTION.unknowns).all(|unknown| turns[unknown] == 0.0) {
            return Some(false);
        }
        let is_same = |known: &&(M::Unknowns<f64>, bool)| known.0.as_ref() == turns.as_ref();
        self.0.iter().find(is_same).map(|known| known.1)
    }

    /// Compares a row with the pose on the turns that its angles have reached.
    fn sees(&mut self, solved: &Footing<M>, reached: &Footing<M>) -> bool {
        let is_whole = |quantities: &[Quantity], one: &[f64], other: &[f64]| {
            let is_angle = |index: usize| angles(quantities).any(|angle| angle == index);
            one.iter().zip(other).enumerate().all(|(index, (one, other))| {
                let (difference, size) = if is_angle(index) {
                    let turns = (other - one) / TAU;
                    ((turns - Float::round(turns)).abs(), one.abs().max(other.abs()).max(1.0))
                } else {
                    ((other - one).abs(), one.abs().max(other.abs()))
                };
                difference <= DEPENDENCE * size
            })
        };
        let description = M::DESCRIPTION;
        let depends = !is_whole(
            description.unknowns,
            solved.unknowns.as_ref(),
            reached.unknowns.as_ref(),
        ) || !is_whole(description.outputs, solved.outputs.as_ref(), reached.outputs.as_ref());
        if self.depends(solved, reached).is_none() {
            self.0.push((Self::turns(solved, reached), depends));
        }
        depends
    }
}

/// The columns of a table that hold inputs, unknowns and outputs.
struct AngleColumns {
    first_input: usize,
    first_unknown: usize,
    first_output: usize,
    orders: usize,
}

impl AngleColumns {
    fn of<M: Mechanism>(table: &Table) -> Self {
        let orders = M::DESCRIPTION.order + 1;
        let first_unknown = table.first_unknown::<M>();
        Self {
            first_input: first_unknown - M::DESCRIPTION.inputs.len() * orders,
            first_unknown,
            first_output: first_unknown + M::DESCRIPTION.unknowns.len() * orders,
            orders,
        }
    }

    /// Whether the rates predict every angle in every row, so that no turn is missing.
    fn are_continuous<M: Mechanism>(&self, table: &Table, time: f64) -> bool {
        let description = M::DESCRIPTION;
        let places = table.values(table.variable);
        let inputs_are_close = angles(description.inputs).all(|input| {
            let values = table.values(self.first_input + input * self.orders);
            Vectors::widest().run(MovesBy { values, most: LONGEST })
        });
        let unknowns = angles(description.unknowns).map(|index| self.first_unknown + index * self.orders);
        let outputs = angles(description.outputs).map(|index| self.first_output + index * self.orders);
        let is_predicted = |column: usize| {
            let values = table.values(column);
            if self.orders > 1 && time.is_finite() {
                let rates = table.values(column + 1);
                return Vectors::widest().run(IsPredicted {
                    places,
                    values,
                    rates,
                    time,
                });
            }
            let most = WITHOUT_RATES;
            Vectors::widest().run(MovesBy { values, most })
        };
        inputs_are_close && unknowns.chain(outputs).all(is_predicted)
    }

    /// The numbers of a row.
    fn footing<M: Mechanism<Scalar = f64>>(&self, table: &Table, row: usize, time: f64) -> Footing<M> {
        let number = |column: usize| table.data[column * table.count + row];
        let rate = |column: usize| {
            if self.orders > 1 {
                number(column + 1) * time
            } else {
                f64::NAN
            }
        };
        let (unknown, output) = (
            |index: usize| self.first_unknown + index * self.orders,
            |index: usize| self.first_output + index * self.orders,
        );
        Footing {
            at: number(table.variable),
            inputs: Row::from_fn(|index| number(self.first_input + index * self.orders)),
            unknowns: Row::from_fn(|index| number(unknown(index))),
            unknown_rates: Row::from_fn(|index| rate(unknown(index))),
            outputs: Row::from_fn(|index| number(output(index))),
            output_rates: Row::from_fn(|index| rate(output(index))),
        }
    }

    /// Writes the angles of a row.
    fn write<M: Mechanism<Scalar = f64>>(&self, table: &mut Table, row: usize, footing: &Footing<M>) {
        let count = table.count;
        for index in angles(M::DESCRIPTION.unknowns) {
            table.data[(self.first_unknown + index * self.orders) * count + row] = footing.unknowns[index];
        }
        for index in angles(M::DESCRIPTION.outputs) {
            table.data[(self.first_output + index * self.orders) * count + row] = footing.outputs[index];
        }
    }
}

/// The question whether a column moves by no more than a limit from row to row. A row that does not close counts as a larger step.
struct MovesBy<'a> {
    values: &'a [f64],
    most: f64,
}

impl Kernel for MovesBy<'_> {
    type Result = bool;
    type Element = f64;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<const W: usize, const FUSED: bool>(self) -> bool {
        let pairs = self.values.iter().zip(self.values.get(1..).unwrap_or_default());
        pairs.fold(true, |all, (one, other)| all & ((other - one).abs() <= self.most))
    }
}

/// The question whether the rates predict each change of an angle.
struct IsPredicted<'a> {
    places: &'a [f64],
    values: &'a [f64],
    rates: &'a [f64],
    /// The time for each unit of the places.
    time: f64,
}

impl Kernel for IsPredicted<'_> {
    type Result = bool;
    type Element = f64;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<const W: usize, const FUSED: bool>(self) -> bool {
        let half = 0.5 * self.time;
        let places = self.places.iter().zip(self.places.get(1..).unwrap_or_default());
        let values = self.values.iter().zip(self.values.get(1..).unwrap_or_default());
        let rates = self.rates.iter().zip(self.rates.get(1..).unwrap_or_default());
        places
            .zip(values.zip(rates))
            .fold(true, |all, ((start, end), ((one, other), (first, last)))| {
                let predicted = half * (end - start) * (first + last);
                all & ((other - one - predicted).abs() <= PREDICTION) & (predicted.abs() <= LONGEST_PREDICTION)
            })
    }
}
