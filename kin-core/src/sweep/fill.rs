//! The numbers of a table: by a batch where every block has a closed form, otherwise from row to row.

use alloc::vec;
use alloc::vec::Vec;
use core::mem::take;

use super::columns::labels;
use super::drive::{Drive, InputMotions, Variable};
use super::error::SweepError;
use super::table::Table;
use super::unwrap::unwrap;
use super::walk::{Reached, Walk};
use super::{Course, limits};
use crate::batch::{self, Column, Columns, Outcome, Place, Vectors, Visitor};
use crate::mechanism::{Mechanism, Pose};
use crate::number::{Number, Row};

/// The rows that a batch solves between two calls of the progress, and those of coupled blocks.
const BLOCK: usize = 1 << 16;
const STEPS: usize = 256;

/// The part of the whole that is done.
#[expect(clippy::cast_precision_loss, reason = "a table has far fewer rows than 2⁵³")]
pub(super) fn part(done: usize, count: usize) -> f64 {
    done as f64 / count as f64
}

impl<M: Mechanism<Scalar = f64>, D: Drive<M>> Course<M, D> {
    /// The poses as a table. See [`Table`] for its columns, and for rows that do not close.
    ///
    /// Where every block has a closed form, `solve_batch` solves several rows at once.
    ///
    /// # Errors
    /// [`SweepError`] if an end of the range or the speed is not finite, if there are no rows or no speed, if a law jumps, or if given columns have
    /// different lengths.
    pub fn table(&self) -> Result<Table, SweepError> {
        self.table_with_progress(|_| {})
    }

    /// [`table`](Self::table) for sweeps of many rows. `progress` is called after every block of 65 536 rows, of coupled blocks after every
    /// 256 rows, with the part of the rows that are solved. It is 1 in the last call.
    ///
    /// ```
    /// use kin_core::library::SliderCrank;
    /// use kin_core::prelude::*;
    ///
    /// let press = SliderCrank { r: 0.1, l: 0.3 };
    /// let sweep = press.sweep(Assembly::Open).over(0.0..=100.0, 200_000);
    /// let mut parts = vec![];
    /// let table = sweep.table_with_progress(|part| parts.push(part))?;
    /// assert_eq!((table.count(), parts.len(), parts[3]), (200_000, 4, 1.0));
    /// # Ok::<(), kin_core::sweep::SweepError>(())
    /// ```
    ///
    /// # Errors
    /// As for [`table`](Self::table).
    pub fn table_with_progress(&self, mut progress: impl FnMut(f64)) -> Result<Table, SweepError> {
        self.check()?;
        let mut table = self.empty(self.count);
        self.fill(&mut table, &mut progress)?;
        Ok(table)
    }

    /// [`table`](Self::table) in the place of another table, whose memory is used again: for programs that make many tables of the same
    /// size. The units and the choice of radians or degrees are those of a new table.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let mut linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
    /// let mut table = linkage.sweep(Assembly::Open).over(0.0..=TAU, 361).table()?;
    /// for coupler in 71..80 {
    ///     linkage.r3 = f64::from(coupler);
    ///     linkage.sweep(Assembly::Open).over(0.0..=TAU, 361).fill_table(&mut table)?;
    ///     println!("{coupler}: {}", table.column("theta4_acceleration")?[90]);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As for [`table`](Self::table). The other table is then empty, or stays as it was.
    pub fn fill_table(&self, table: &mut Table) -> Result<(), SweepError> {
        self.check()?;
        let mut recycled = self.empty(0);
        (recycled.data, recycled.outcomes) = (take(&mut table.data), take(&mut table.outcomes));
        // numbers that stand there already are overwritten
        recycled.data.resize(recycled.labels.len() * self.count, 0.0);
        recycled.outcomes.resize(self.count, Outcome::Unsolved);
        recycled.count = self.count;
        *table = self.empty(0);
        self.fill(&mut recycled, &mut |_| {})?;
        *table = recycled;
        Ok(())
    }

    /// Writes all numbers of a table that has their places.
    fn fill(&self, table: &mut Table, progress: &mut dyn FnMut(f64)) -> Result<(), SweepError> {
        let (is_closed, jumps) = if M::ASSEMBLY_COUNT > 0 {
            let is_closed = self.fill_by_batch(table, progress)?;
            (is_closed, unwrap(self, table))
        } else {
            (self.fill_by_steps(table, progress), vec![])
        };
        limits::find(self, table, is_closed, &jumps);
        Ok(())
    }

    pub(crate) fn check(&self) -> Result<(), SweepError> {
        if self.count == 0 {
            return Err(SweepError::NoRows);
        }
        for (quantity, value) in [("start", self.from), ("end", self.to)] {
            if !value.is_finite() {
                return Err(SweepError::NotFinite { quantity, value });
            }
        }
        self.drive
            .check([self.from.min(self.to), self.from.max(self.to)], self.count)
    }

    /// A table of zeros.
    pub(super) fn empty(&self, count: usize) -> Table {
        let variable = self.drive.variable();
        let column = match variable {
            Variable::Input(input) => input * (M::DESCRIPTION.order + 1),
            _ => 0,
        };
        Table::new(labels::<M>(variable).collect(), count, column)
    }

    /// Writes the inputs of all rows, and lets a batch write the rest. It returns whether every row closes.
    fn fill_by_batch(&self, table: &mut Table, progress: &mut dyn FnMut(f64)) -> Result<bool, SweepError> {
        let description = M::DESCRIPTION;
        let (count, orders) = (table.count, description.order + 1);
        let same = InputMotions::<M, Option<f64>>::from_fn(|input| Row::from_fn(|order| self.drive.same(input, order)));
        let own = match self.drive.variable() {
            Variable::Input(_) => 0,
            Variable::Time | Variable::Row => 1,
        };
        let (given, results) = table
            .data
            .split_at_mut((own + description.inputs.len() * orders) * count);
        if own > 0 {
            self.write_places(&mut given[..count]);
        }
        let inputs = &mut given[own * count..];
        let column =
            |input: usize, order: usize| (input * orders + order) * count..(input * orders + order + 1) * count;
        let mut varies = false;
        for input in 0..description.inputs.len() {
            for order in 0..orders {
                let values = &mut inputs[column(input, order)];
                match same[input][order] {
                    Some(value) => values.fill(value),
                    None if order == 0 && self.drive.variable() == Variable::Input(input) => self.write_places(values),
                    None => varies = true,
                }
            }
        }
        if varies {
            for row in 0..count {
                let motions = self.drive.motions(self.at(row));
                for input in 0..description.inputs.len() {
                    for order in 0..orders {
                        if same[input][order].is_none() {
                            inputs[(input * orders + order) * count + row] = motions[input][order];
                        }
                    }
                }
            }
        }
        let inputs = &*inputs;
        let directions = self.directions();
        let mut sines = vec![vec![]; description.unknowns.len()];
        for (sine, is_direction) in sines.iter_mut().zip(directions.as_ref()) {
            if *is_direction {
                *sine = vec![f64::NAN; count];
            }
        }
        let parameters = self.mechanism.parameters();
        let parameters = M::Parameters::from_fn(|parameter| Column::Same(parameters[parameter]));
        let vectors = Vectors::widest();
        let mut is_closed = true;
        for start in (0..count).step_by(BLOCK) {
            let rows = start..count.min(start + BLOCK);
            let columns = InputMotions::<M, Column<'_>>::from_fn(|input| {
                Row::from_fn(|order| match same[input][order] {
                    Some(value) => Column::Same(value),
                    None => Column::Each(&inputs[column(input, order)][rows.clone()]),
                })
            });
            let mut places = Places {
                orders,
                unknowns: description.unknowns.len(),
                results: results
                    .chunks_exact_mut(count)
                    .map(|column| Some(&mut column[rows.clone()]))
                    .collect(),
                sines: sines.iter_mut().map(|sine| sine.get_mut(rows.clone())).collect(),
            };
            let outcomes = &mut table.outcomes[rows.clone()];
            let summary = batch::solve::<M, _, _>(parameters, columns, self.assembly, &mut places, outcomes, vectors)?;
            is_closed &= summary.failed == 0;
            progress(part(rows.end, count));
        }
        for (unknown, sines) in sines.iter().enumerate() {
            let angles = &mut results[unknown * orders * count..(unknown * orders + 1) * count];
            for (angle, sine) in angles.iter_mut().zip(sines) {
                *angle = Number::atan2(*sine, *angle);
            }
        }
        Ok(is_closed)
    }

    /// Writes the values of the variable.
    #[expect(clippy::cast_precision_loss, reason = "a table has far fewer rows than 2⁵³")]
    fn write_places(&self, column: &mut [f64]) {
        let way = self.to - self.from;
        let last = self.count.saturating_sub(1).max(1) as f64;
        // Without a branch, and with numbers of 32 bits that vectors can convert, so that several are calculated at once. The rest is there
        // for columns of 17 gigabytes and more.
        let (short, long) = column.split_at_mut(column.len().min(1 << 31));
        for (row, place) in (0_i32..).zip(short.iter_mut()) {
            *place = self.from + way * (f64::from(row) / last);
        }
        for (row, place) in long.iter_mut().enumerate() {
            *place = self.from + way * ((row + short.len()) as f64 / last);
        }
        for row in [0, self.count - 1] {
            column[row] = self.at(row);
        }
    }

    /// Which unknowns are directions, which a batch stores as cosine and sine.
    fn directions(&self) -> M::Unknowns<bool> {
        let poses = (0..self.count).map(|row| {
            let motions = self.drive.motions(self.at(row));
            self.mechanism.solve_motion(motions, self.assembly)
        });
        match poses.flatten().next() {
            Some(pose) => {
                let sines = pose.unknown_sines();
                Row::from_fn(|unknown| sines[unknown].is_some())
            }
            None => Row::splat(false),
        }
    }

    /// Solves row after row. It returns whether every row closes.
    fn fill_by_steps(&self, table: &mut Table, progress: &mut dyn FnMut(f64)) -> bool {
        let count = table.count;
        let mut walk = Walk::BEGINNING;
        for row in 0..count {
            let at = self.at(row);
            let motions = self.drive.motions(at);
            let reached = walk.step(self, at, motions);
            table.outcomes[row] = match &reached {
                Ok(_) => Outcome::Solved,
                Err(error) => Outcome::from(error),
            };
            let data = &mut table.data;
            self.write(at, &motions, reached.ok(), |column, value| {
                data[column * count + row] = value;
            });
            if (row + 1) % STEPS == 0 || row + 1 == count {
                progress(part(row + 1, count));
            }
        }
        table.outcomes.iter().all(Outcome::is_solved)
    }

    /// Passes on the numbers of a row, each with its column. Without a pose, they are NaN.
    pub(super) fn write(
        &self,
        at: f64,
        motions: &InputMotions<M, f64>,
        reached: Option<Reached<M>>,
        mut put: impl FnMut(usize, f64),
    ) {
        let mut column = 0;
        let mut put = |value: f64| {
            put(column, value);
            column += 1;
        };
        if !matches!(self.drive.variable(), Variable::Input(_)) {
            put(at);
        }
        for motion in motions.as_ref() {
            motion.as_ref().iter().copied().for_each(&mut put);
        }
        let orders = M::DESCRIPTION.order + 1;
        let Some(reached) = reached else {
            let results = M::DESCRIPTION.unknowns.len() + M::DESCRIPTION.outputs.len();
            (0..results * orders).for_each(|_| put(f64::NAN));
            return;
        };
        let Reached { pose, footing, .. } = reached;
        let motions = pose.unknown_motions_near(Row::from_fn(|unknown| footing.unknowns[unknown]));
        for (unknown, motion) in motions.as_ref().iter().enumerate() {
            put(footing.unknowns[unknown]);
            motion.as_ref().iter().skip(1).copied().for_each(&mut put);
        }
        for (output, motion) in pose.output_motions().as_ref().iter().enumerate() {
            put(footing.outputs[output]);
            motion.as_ref().iter().skip(1).copied().for_each(&mut put);
        }
    }
}

/// The columns of a table as the target of a batch.
struct Places<'t> {
    orders: usize,
    unknowns: usize,
    /// For each unknown and then each output, its orders.
    results: Vec<Option<&'t mut [f64]>>,
    sines: Vec<Option<&'t mut [f64]>>,
}

impl<'t> Columns<Option<&'t mut [f64]>> for Places<'t> {
    fn each<'a>(&'a mut self, visitor: &mut impl Visitor<'a, Option<&'t mut [f64]>>)
    where
        Option<&'t mut [f64]>: 'a,
    {
        for (index, column) in self.results.iter_mut().enumerate() {
            let (quantity, order) = (index / self.orders, index % self.orders);
            let place = match quantity.checked_sub(self.unknowns) {
                None => Place::Unknown(quantity, order),
                Some(output) => Place::Output(output, order),
            };
            visitor.visit(place, column);
        }
        for (unknown, sines) in self.sines.iter_mut().enumerate() {
            visitor.visit(Place::Sine(unknown), sines);
        }
    }
}
