//! Rows where they are needed.

use alloc::rc::Rc;
use alloc::vec;
use alloc::vec::Vec;

use super::columns::Heading;
use super::drive::Drive;
use super::error::SweepError;
use super::fill::{outcome, part};
use super::gaps::Bend;
use super::table::Table;
use super::untyped::UntypedSweep;
use super::walk::Walk;
use super::{Sweep, limits};
use crate::any::{AssemblyOver, Of};
use crate::batch::Outcome;
use crate::mechanism::Mechanism;

/// A step between rows is not halved beyond this part of the range. There the curves have an edge: the end of a circuit
/// or a kink.
const SHORTEST_STEP: f64 = 1e-6;

/// The fewest samples between the rows of a sweep at which the ranges of its columns are looked for.
const PROBES: usize = 16;

/// A row that has been solved.
#[derive(Clone)]
struct Sample<'c> {
    at: f64,
    walk: Rc<Walk<'c>>,
    outcome: Outcome,
    /// Its index among the samples.
    index: usize,
}

/// The largest deviation of a sample from the straight line between its neighbours.
struct Deviation {
    /// As a part of the range of the column.
    part: f64,
    column: usize,
}

struct Samples<'c> {
    sweep: &'c UntypedSweep<'c>,
    width: usize,
    /// Row after row, in the order in which they were solved.
    data: Vec<f64>,
    /// One divided by the range of each column that is looked at, zero for the others.
    scales: Vec<f64>,
    /// The number of rows of the table so far, with those of the sweep, and the largest number allowed.
    rows: usize,
    most: usize,
}

impl<M: Mechanism<Scalar = f64>, D: Drive> Sweep<M, D> {
    /// The poses as a table with rows where they are needed: the straight lines between them deviate from the curves of
    /// all unknowns and outputs by no more than `tolerance`, as a part of the range of each column. The range is that
    /// of the rows of the sweep and of samples between them.
    ///
    /// The rows of the sweep are there, and others between them. Derivatives above the `order` are not looked at. Each
    /// step is tested at a quarter, at the middle and at three quarters. Steps at the end of a circuit are halved down
    /// to 10⁻⁶ of the range.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let sweep = linkage.sweep(Assembly::Open).over(0.0..=TAU, 25).speed(10.0);
    /// // curves of position, velocity and acceleration that look smooth
    /// let table = sweep.adaptive_table(1e-3, 2, 10_000)?;
    /// assert!(table.count() > 50 && table.count() < 500);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`SweepError::TooManyRows`] and, towards a limit, [`SweepError::TooManyRowsAtLimit`] if more rows than
    /// `most_rows` were needed, [`SweepError::MoreRows`] if the sweep itself has more, [`SweepError::Tolerance`] if the
    /// tolerance is not a positive number, and the errors of [`table`](Self::table).
    pub fn adaptive_table(&self, tolerance: f64, order: usize, most_rows: usize) -> Result<Table, SweepError> {
        self.adaptive_table_with_progress(tolerance, order, most_rows, |_| {})
    }

    /// [`adaptive_table`](Self::adaptive_table), which calls `progress` after every step between two rows of the sweep,
    /// with the part of the steps that are done.
    ///
    /// # Errors
    /// As for [`adaptive_table`](Self::adaptive_table).
    pub fn adaptive_table_with_progress(
        &self,
        tolerance: f64,
        order: usize,
        most_rows: usize,
        mut progress: impl FnMut(f64),
    ) -> Result<Table, SweepError> {
        self.any()
            .adaptive_table(Of::<M>::FUNCTIONS, tolerance, order, most_rows, &mut progress)
    }
}

impl UntypedSweep<'_> {
    fn adaptive_table(
        &self,
        bends: &dyn AssemblyOver<Bend>,
        tolerance: f64,
        order: usize,
        most_rows: usize,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Table, SweepError> {
        self.check()?;
        if self.count > most_rows {
            return Err(SweepError::MoreRows {
                most: most_rows,
                rows: self.count,
            });
        }
        if !(tolerance.is_finite() && tolerance > 0.0) {
            return Err(SweepError::Tolerance { value: tolerance });
        }
        let empty = self.empty(0);
        let mut samples = Samples {
            sweep: self,
            width: empty.labels.len(),
            data: vec![],
            scales: vec![],
            rows: self.count,
            most: most_rows,
        };
        let mut given: Vec<Sample<'_>> = Vec::with_capacity(self.count);
        for row in 0..self.count {
            let beginning = Rc::new(Walk::BEGINNING);
            let walk = given.last().map_or(beginning, |before| Rc::clone(&before.walk));
            given.push(samples.solve(&walk, self.at(row)));
        }
        let first = empty.first_unknown(self.description);
        let ranges = samples.ranges(&given);
        // The rounding errors of a column that stays the same are no curve. They count against the largest number of
        // its kind, as a column that stays at zero has nothing else.
        let size = |label: &Heading| {
            let alike = |other: &Heading| {
                (other.order, other.dimension) == (label.order, label.dimension) && !other.is_variable
            };
            let alike_columns = empty.labels.iter().zip(&ranges).filter(|(other, _)| alike(other));
            alike_columns.fold(0.0, |size: f64, (_, [low, high])| size.max(low.abs()).max(high.abs()))
        };
        let columns = empty.labels.iter().zip(&ranges).enumerate();
        let scale = |(column, (label, [low, high])): (usize, (&Heading, &[f64; 2]))| {
            let is_read = column >= first && label.order <= order;
            let range = high - low;
            if is_read && range > 1e-9 * size(label) {
                1.0 / range
            } else {
                0.0
            }
        };
        samples.scales = columns.map(scale).collect();
        let mut kept = vec![given[0].clone()];
        for (step, pair) in given.windows(2).enumerate() {
            samples.refine(&pair[0], &pair[1], tolerance, &mut kept, &empty)?;
            kept.push(pair[1].clone());
            progress(part(step + 1, self.count - 1));
        }
        let mut table = self.empty(kept.len());
        for (row, sample) in kept.iter().enumerate() {
            table.outcomes[row] = sample.outcome;
            for column in 0..samples.width {
                table.data[column * kept.len() + row] = samples.data[sample.index * samples.width + column];
            }
        }
        let is_closed = table.outcomes.iter().all(Outcome::is_solved);
        limits::find(self, bends, &mut table, is_closed, &[]);
        Ok(table)
    }
}

impl<'c> Samples<'c> {
    /// The next sample behind a walk.
    fn solve(&mut self, walk: &Walk<'c>, at: f64) -> Sample<'c> {
        let motions = self.sweep.motions(at);
        let (walk, result) = walk.stepped(self.sweep, at, &motions);
        let start = self.data.len();
        self.data.resize(start + self.width, 0.0);
        let row = &mut self.data[start..];
        let reached = walk.last.as_ref().filter(|_| result.is_ok());
        self.sweep
            .write(at, &motions, reached, |column, value| row[column] = value);
        Sample {
            at,
            walk: Rc::new(walk),
            outcome: outcome(&result),
            index: start / self.width,
        }
    }

    /// The lowest and the highest value of each column, at the rows of the sweep and at samples between them: a few
    /// rows may all lie where a column has the same value.
    fn ranges(&mut self, given: &[Sample<'c>]) -> Vec<[f64; 2]> {
        let mut ranges = vec![[f64::INFINITY, f64::NEG_INFINITY]; self.width];
        // numbers of rows that do not close are NaN, which both leave out
        let see = |ranges: &mut [[f64; 2]], row: &[f64]| {
            for ([low, high], value) in ranges.iter_mut().zip(row) {
                (*low, *high) = (low.min(*value), high.max(*value));
            }
        };
        for row in self.data.chunks(self.width) {
            see(&mut ranges, row);
        }
        let steps = given.len().saturating_sub(1).max(1);
        let probes = PROBES.div_ceil(steps).max(3);
        let start = self.data.len();
        for pair in given.windows(2).filter(|pair| pair[0].outcome.is_solved()) {
            for probe in 1..=probes {
                self.middle(&pair[0], part(probe, probes + 1), &pair[1]);
                see(&mut ranges, &self.data[start..]);
                self.data.truncate(start);
            }
        }
        ranges
    }

    /// A sample between two others, found from the left one.
    fn middle(&mut self, left: &Sample<'c>, part: f64, right: &Sample<'c>) -> Sample<'c> {
        self.solve(&left.walk, left.at + part * (right.at - left.at))
    }

    /// Adds the rows that are needed between two samples.
    fn refine(
        &mut self,
        left: &Sample<'c>,
        right: &Sample<'c>,
        tolerance: f64,
        kept: &mut Vec<Sample<'c>>,
        table: &Table,
    ) -> Result<(), SweepError> {
        let start = self.data.len();
        let is_edge = left.outcome.is_solved() != right.outcome.is_solved();
        let is_unclosed = !left.outcome.is_solved() && !right.outcome.is_solved();
        let is_shortest = (right.at - left.at).abs() <= SHORTEST_STEP * (self.sweep.to - self.sweep.from).abs();
        if is_unclosed || is_shortest {
            return Ok(());
        }
        let middle = self.middle(left, 0.5, right);
        // towards a limit there is no straight line to deviate from
        let worst = if is_edge || !middle.outcome.is_solved() {
            None
        } else {
            let mut worst = self.deviation(left, 0.5, &middle, right);
            for part in [0.25, 0.75] {
                if worst.part <= tolerance {
                    let other = self.middle(left, part, right);
                    let next = self.deviation(left, part, &other, right);
                    if next.part > worst.part {
                        worst = next;
                    }
                }
            }
            Some(worst)
        };
        if worst.as_ref().is_some_and(|worst| worst.part <= tolerance) {
            self.data.truncate(start);
            return Ok(());
        }
        if self.rows >= self.most {
            return Err(self.too_many_rows(middle.at, worst, table));
        }
        self.rows += 1;
        self.data.truncate((middle.index + 1) * self.width);
        self.refine(left, &middle, tolerance, kept, table)?;
        kept.push(middle.clone());
        self.refine(&middle, right, tolerance, kept, table)
    }

    fn too_many_rows(&self, at: f64, worst: Option<Deviation>, table: &Table) -> SweepError {
        let most = self.most;
        let Some(worst) = worst else {
            return SweepError::TooManyRowsAtLimit { most, at };
        };
        SweepError::TooManyRows {
            most,
            at,
            column: self.sweep.name_of(worst.column - table.first_input()),
            order: table.labels[worst.column].order,
            deviation: worst.part,
        }
    }

    fn deviation(&self, left: &Sample<'_>, part: f64, between: &Sample<'_>, right: &Sample<'_>) -> Deviation {
        let row = |sample: &Sample<'_>| &self.data[sample.index * self.width..(sample.index + 1) * self.width];
        let (left, between, right) = (row(left), row(between), row(right));
        let mut worst = Deviation { part: 0.0, column: 0 };
        for (column, scale) in self.scales.iter().enumerate() {
            let line = left[column] + part * (right[column] - left[column]);
            let deviation = (between[column] - line).abs() * scale;
            if deviation > worst.part {
                worst = Deviation {
                    part: deviation,
                    column,
                };
            }
        }
        worst
    }
}
