//! Rows where they are needed.

use alloc::string::{String, ToString as _};
use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::TAU;

use num_traits::Float;

use super::ExactTableError;
use super::owned::{ExactColumnParts, ExactParts, ExactTable};
use super::piece::{MOST_NUMBERS, piece};
use super::precision::Precision;
use crate::law::Side;
use crate::quantity::{Dimension, Quantity};

/// The parts of a piece at which it is compared. The error of a piece vanishes in every odd order in its middle.
const TESTED: [f64; 3] = [1.0 / 3.0, 0.5, 2.0 / 3.0];
/// A difference below this multiple of ε, of the size of the values and of a power of one over the length may be
/// rounding: what the values at both ends of a piece leave in its highest derivatives.
const ROUNDING: f64 = 2000.0;

/// The numbers at a parameter, and what is needed to find those at a parameter nearby.
#[derive(Clone)]
pub(super) struct Station<N> {
    pub(super) at: f64,
    /// For each column the value and its derivatives.
    pub(super) numbers: Vec<f64>,
    pub(super) near: N,
}

/// A motion over a parameter.
pub(super) trait Source {
    /// What is needed to find the numbers at a parameter nearby.
    type Near: Clone;

    /// The columns.
    fn columns(&self) -> Vec<Quantity<'_>>;

    /// The numbers at a parameter, found from those at another one. Where two pieces of a law meet, `side` selects one.
    fn station(&self, at: f64, side: Side, from: &Station<Self::Near>) -> Result<Station<Self::Near>, ExactTableError>;
}

/// Two rows, and the piece between them.
struct Cell<N> {
    ends: [Station<N>; 2],
    /// The station in the middle, and the differences of all columns and orders, once they are known.
    seen: Option<(Station<N>, Vec<f64>)>,
    is_good: bool,
    /// The worst part of its tolerance that the piece had of which this one is a half.
    before: f64,
}

/// What makes a table of rows.
pub(super) struct Frame {
    pub(super) name: String,
    pub(super) parameter: (String, Dimension),
    pub(super) order: usize,
    /// Whether the parameter may repeat itself.
    pub(super) may_close: bool,
}

/// The table with rows that are close enough for the tolerances, from rows at the ends of first pieces.
pub(super) fn refined<S: Source>(
    source: &S,
    frame: Frame,
    first: Vec<[Station<S::Near>; 2]>,
    precision: Precision,
) -> Result<ExactTable, ExactTableError> {
    let columns = source.columns();
    let count = frame.order + 1;
    let tolerances = &precision.tolerances()[..count];
    if let Some((order, tolerance)) = tolerances
        .iter()
        .copied()
        .enumerate()
        .find(|(_, tolerance)| !(tolerance.is_finite() && *tolerance > 0.0))
    {
        return Err(ExactTableError::Tolerance { order, tolerance });
    }
    let (most, rows) = (precision.rows(), first.len() + 1);
    if rows > most {
        return Err(ExactTableError::MoreRows { most, rows });
    }
    let mut sizes = Magnitudes::new(&columns, count, &first);
    let mut cells: Vec<Cell<S::Near>> = first
        .into_iter()
        .map(|ends| Cell {
            ends,
            seen: None,
            is_good: false,
            before: f64::INFINITY,
        })
        .collect();
    // All pieces are halved once before any is halved again, so that the sizes are known by then.
    while cells.iter().any(|cell| !cell.is_good) {
        for cell in cells.iter_mut().filter(|cell| !cell.is_good) {
            look(source, cell, count, &mut sizes)?;
        }
        let mut next = Vec::with_capacity(cells.len());
        let mut rows = cells.len() + 1;
        for mut cell in cells {
            let Some((middle, differences)) = cell.seen.take_if(|_| !cell.is_good) else {
                next.push(cell);
                continue;
            };
            let (part, index) = sizes.worst(&differences, tolerances);
            if part <= 1.0 {
                cell.is_good = true;
                cell.seen = Some((middle, differences));
                next.push(cell);
                continue;
            }
            let length = (cell.ends[1].at - cell.ends[0].at).abs();
            let is_rounding = part > 0.5 * cell.before && differences[index] <= sizes.rounding(index, length);
            if is_rounding || rows >= most || middle.at == cell.ends[0].at {
                return Err(ExactTableError::Unreached {
                    column: columns[index / count].name.to_string(),
                    order: index % count,
                    at: middle.at,
                    error: 2.0 * differences[index],
                    allowed: tolerances[index % count] * sizes.of(index),
                    rows,
                    is_rounding,
                });
            }
            rows += 1;
            let [left, right] = cell.ends;
            for ends in [[left, middle.clone()], [middle, right]] {
                next.push(Cell {
                    ends,
                    seen: None,
                    is_good: false,
                    before: part,
                });
            }
        }
        cells = next;
    }
    Ok(table(&columns, frame, &cells, &sizes)?)
}

/// Compares a piece with the motion.
fn look<S: Source>(
    source: &S,
    cell: &mut Cell<S::Near>,
    count: usize,
    sizes: &mut Magnitudes,
) -> Result<(), ExactTableError> {
    let [left, right] = &cell.ends;
    let length = right.at - left.at;
    let mut differences = vec![0.0; left.numbers.len()];
    let mut middle = None;
    for part in TESTED {
        let at = left.at + part * length;
        // the part of the piece to which the parameter was rounded
        let part = (at - left.at) / length;
        let station = source.station(at, Side::Right, middle.as_ref().unwrap_or(left))?;
        let ends = left.numbers.chunks(count).zip(right.numbers.chunks(count));
        let measured = differences.chunks_mut(count).zip(station.numbers.chunks(count));
        for ((left, right), (differences, expected)) in ends.zip(measured) {
            let mut found = [0.0; MOST_NUMBERS];
            piece(left, right, length, part, &mut found[..count]);
            for ((difference, found), expected) in differences.iter_mut().zip(found).zip(expected) {
                *difference = difference.max((found - expected).abs());
            }
        }
        sizes.see(&station.numbers);
        if part < 0.6 {
            middle = Some(station);
        }
    }
    cell.seen = middle.map(|middle| (middle, differences));
    Ok(())
}

/// The largest magnitudes of all columns in all orders.
struct Magnitudes {
    largest: Vec<f64>,
    angles: Vec<bool>,
    count: usize,
    /// The unit of the parameter.
    unit: f64,
}

impl Magnitudes {
    fn new<N>(columns: &[Quantity<'_>], count: usize, first: &[[Station<N>; 2]]) -> Self {
        let parameters = || first.iter().flatten().map(|station| station.at);
        let [low, high] = [
            parameters().fold(f64::INFINITY, f64::min),
            parameters().fold(f64::NEG_INFINITY, f64::max),
        ];
        let mut sizes = Self {
            largest: vec![0.0; columns.len() * count],
            angles: columns
                .iter()
                .map(|column| column.dimension == Dimension::Angle)
                .collect(),
            count,
            unit: (high - low) / TAU,
        };
        for station in first.iter().flatten() {
            sizes.see(&station.numbers);
        }
        sizes
    }

    fn see(&mut self, numbers: &[f64]) {
        for (largest, number) in self.largest.iter_mut().zip(numbers) {
            *largest = largest.max(number.abs());
        }
    }

    /// The size of a column in an order, as [`Precision`] describes it.
    fn of(&self, index: usize) -> f64 {
        let (column, order) = (index / self.count, index % self.count);
        let mut size: f64 = 0.0;
        for lower in 0..=order {
            let scale = if lower == 0 && self.angles[column] {
                1.0
            } else {
                self.largest[column * self.count + lower]
            };
            size = (size / if lower == 0 { 1.0 } else { self.unit }).max(scale);
        }
        // a column of zeros is what it is
        size.max(f64::MIN_POSITIVE)
    }

    /// The error that rounding may cause in a piece of this length.
    fn rounding(&self, index: usize, length: f64) -> f64 {
        let (column, order) = (index / self.count, index % self.count);
        let value = self.largest[column * self.count].max(self.of(column * self.count));
        (0..order).fold(ROUNDING * f64::EPSILON * value, |error, _| error / length)
    }

    /// The error of the worst column, as a part of what is allowed, and its index.
    fn worst(&self, differences: &[f64], tolerances: &[f64]) -> (f64, usize) {
        let mut worst = (0.0, 0);
        for (index, difference) in differences.iter().enumerate() {
            let allowed = tolerances[index % self.count] * self.of(index);
            let part = self.error(index, *difference) / allowed;
            // also if the difference is not a number
            if part > worst.0 || part.is_nan() {
                worst = (part, index);
            }
        }
        worst
    }

    /// The stated error for a difference that was seen.
    fn error(&self, index: usize, difference: f64) -> f64 {
        2.0 * difference + 4.0 * f64::EPSILON * self.largest[index]
    }
}

fn table<N: Clone>(
    columns: &[Quantity<'_>],
    frame: Frame,
    cells: &[Cell<N>],
    sizes: &Magnitudes,
) -> Result<ExactTable, super::ReadError> {
    let count = frame.order + 1;
    let mut rows: Vec<&Station<N>> = Vec::with_capacity(cells.len() + 1);
    for cell in cells {
        // where two pieces of a law meet there are two rows
        let is_new = rows
            .last()
            .is_none_or(|last| last.at != cell.ends[0].at || last.numbers != cell.ends[0].numbers);
        if is_new {
            rows.push(&cell.ends[0]);
        }
        rows.push(&cell.ends[1]);
    }
    if rows.len() > 1 && rows[0].at > rows[1].at {
        rows.reverse();
    }
    let revolutions = frame
        .may_close
        .then(|| revolutions(columns, count, &rows, sizes))
        .flatten();
    let parts = ExactParts {
        name: frame.name,
        parameter: frame.parameter,
        order: frame.order,
        is_closed: revolutions.is_some(),
        columns: columns
            .iter()
            .enumerate()
            .map(|(column, quantity)| ExactColumnParts {
                name: quantity.name.to_string(),
                dimension: quantity.dimension,
                increment: revolutions.as_ref().map_or(0.0, |revolutions| revolutions[column]),
                errors: (0..count)
                    .map(|order| {
                        let index = column * count + order;
                        let seen = cells.iter().filter_map(|cell| cell.seen.as_ref());
                        let largest = seen.fold(0.0, |largest: f64, (_, differences)| largest.max(differences[index]));
                        sizes.error(index, largest)
                    })
                    .collect(),
            })
            .collect(),
        rows: rows
            .into_iter()
            .map(|station| {
                core::iter::once(station.at)
                    .chain(station.numbers.iter().copied())
                    .collect()
            })
            .collect(),
    };
    parts.table()
}

/// The change of each column over the range, if the motion repeats itself: whole revolutions of angles, and nothing
/// else.
fn revolutions<N>(
    columns: &[Quantity<'_>],
    count: usize,
    rows: &[&Station<N>],
    sizes: &Magnitudes,
) -> Option<Vec<f64>> {
    let (first, last) = (rows.first()?, rows.last()?);
    let mut revolutions = Vec::with_capacity(columns.len());
    for (index, (start, end)) in first.numbers.iter().zip(&last.numbers).enumerate() {
        let mut change = end - start;
        if index % count == 0 {
            let revolution = if columns[index / count].dimension == Dimension::Angle {
                TAU * Float::round(change / TAU)
            } else {
                0.0
            };
            revolutions.push(revolution);
            change -= revolution;
        }
        let is_same = change.abs() <= 1e-9 * sizes.of(index);
        if !is_same {
            return None;
        }
    }
    Some(revolutions)
}
