//! The numbers of a table: by a batch where every block has a closed form, otherwise from row to row.

use alloc::vec;
use alloc::vec::Vec;
use core::mem::take;
use core::ops::Range;

use super::drive::{Drive, Variable};
use super::error::SweepError;
use super::footing::Footing;
use super::gaps::Bend;
use super::table::Table;
use super::untyped::{SweptMechanism, UntypedSweep};
use super::unwrap::unwrap;
use super::walk::Walk;
use super::{Sweep, limits};
use crate::any::{AssemblyOver, Of};
use crate::batch::{
    AnyBatch, Column, ColumnChoice, GivenColumns, Outcome, Slot, Vectors, WantedColumns, angles_from_cosines,
};
use crate::failure::SolveError;
use crate::mechanism::Mechanism;

/// The rows that a batch solves between two calls of the progress, and those of coupled blocks.
const BLOCK: usize = 1 << 16;
const STEPS: usize = 256;

/// The part of the whole that is done.
#[expect(clippy::cast_precision_loss, reason = "a table has far fewer rows than 2⁵³")]
pub(super) fn part(done: usize, count: usize) -> f64 {
    done as f64 / count as f64
}

impl<M: Mechanism<Scalar = f64>, D: Drive> Sweep<M, D> {
    /// The poses as a table. See [`Table`] for its columns, and for rows that do not close.
    ///
    /// Where every block has a closed form, a batch solves several rows at once.
    ///
    /// # Errors
    /// [`SweepError`] if an end of the range or the speed is not finite, if there are no rows or no speed, if a law
    /// jumps, or if given columns have different lengths.
    pub fn table(&self) -> Result<Table, SweepError> {
        self.table_with_progress(|_| {})
    }

    /// [`table`](Self::table) for sweeps of many rows. `progress` is called after every block of 65 536 rows, of
    /// coupled blocks after every 256 rows, with the part of the rows that are solved. It is 1 in the last call.
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
        self.any().table(Of::<M>::FUNCTIONS, &mut progress)
    }

    /// [`table`](Self::table) instead of another table, whose memory is used again: for programs that make many tables
    /// of the same size. The units and the choice of radians or degrees are those of a new table.
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
        self.any().refill(Of::<M>::FUNCTIONS, table)
    }
}

/// What a table needs of its mechanism.
pub trait TabledMechanism: SweptMechanism + AssemblyOver<Bend> + AnyBatch {}

impl<F: SweptMechanism + AssemblyOver<Bend> + AnyBatch> TabledMechanism for F {}

impl UntypedSweep<'_> {
    pub(crate) fn table(
        &self,
        functions: &dyn TabledMechanism,
        progress: &mut dyn FnMut(f64),
    ) -> Result<Table, SweepError> {
        self.check()?;
        let mut table = self.empty(self.count);
        self.fill(functions, &mut table, progress)?;
        Ok(table)
    }

    fn refill(&self, functions: &dyn TabledMechanism, table: &mut Table) -> Result<(), SweepError> {
        self.check()?;
        let mut recycled = self.empty(0);
        (recycled.data, recycled.outcomes) = (take(&mut table.data), take(&mut table.outcomes));
        // numbers that stand there already are overwritten
        recycled.data.resize(recycled.labels.len() * self.count, 0.0);
        recycled.outcomes.resize(self.count, Outcome::Unsolved);
        recycled.count = self.count;
        *table = self.empty(0);
        self.fill(functions, &mut recycled, &mut |_| {})?;
        *table = recycled;
        Ok(())
    }

    /// Writes all numbers of a table that has room for them.
    fn fill(
        &self,
        functions: &dyn TabledMechanism,
        table: &mut Table,
        progress: &mut dyn FnMut(f64),
    ) -> Result<(), SweepError> {
        let (is_closed, jumps) = match self.assembly.index() {
            Some(assembly) => {
                let is_closed = self.fill_by_batch(functions, assembly, table, progress)?;
                (is_closed, unwrap(self, table))
            }
            None => (self.fill_by_steps(table, progress), vec![]),
        };
        limits::find(self, functions, table, is_closed, &jumps);
        Ok(())
    }

    /// Writes the inputs of all rows, and lets a batch write the rest. It returns whether every row closes.
    fn fill_by_batch(
        &self,
        functions: &dyn TabledMechanism,
        assembly: usize,
        table: &mut Table,
        progress: &mut dyn FnMut(f64),
    ) -> Result<bool, SweepError> {
        let (description, count, orders) = (self.description, table.count, self.orders());
        let columns = description.inputs.len() * orders;
        let same: Vec<Option<f64>> = (0..columns)
            .map(|column| self.drive.same(column / orders, column % orders))
            .collect();
        let first_input = table.first_input();
        let (given, results) = table.data.split_at_mut((first_input + columns) * count);
        if first_input > 0 {
            self.write_variable(&mut given[..count]);
        }
        let inputs = &mut given[first_input * count..];
        let mut varies = false;
        for (column, values) in inputs.chunks_exact_mut(count).enumerate() {
            match same[column] {
                Some(value) => values.fill(value),
                None if self.drive.variable() == Variable::Input(column / orders) && column % orders == 0 => {
                    self.write_variable(values);
                }
                None => varies = true,
            }
        }
        if varies {
            let mut motions = vec![0.0; columns];
            let moving: Vec<usize> = (0..columns).filter(|column| same[*column].is_none()).collect();
            for row in 0..count {
                self.drive.motions(self.at(row), orders, &mut motions);
                for column in &moving {
                    inputs[column * count + row] = motions[*column];
                }
            }
        }
        let inputs = &*inputs;
        let parameters: Vec<Column<'_>> = self.parameters.iter().copied().map(Column::Same).collect();
        let solve = |rows: Range<usize>, wanted: Vec<(Slot, &mut [f64])>, outcomes: &mut [Outcome]| {
            let columns = same.iter().zip(inputs.chunks_exact(count));
            let columns: Vec<Column<'_>> = columns
                .map(|(same, values)| same.map_or(Column::Each(&values[rows.clone()]), Column::Same))
                .collect();
            let inputs: Vec<&[Column<'_>]> = columns.chunks_exact(orders).collect();
            let given = GivenColumns {
                parameters: &parameters,
                inputs: &inputs,
                choice: ColumnChoice::Assembly(assembly),
            };
            let wanted = &mut WantedColumns::new(wanted);
            let summary = functions.solve_batch(given, wanted, outcomes, Vectors::widest())?;
            Ok::<_, SweepError>(summary.failed == 0)
        };
        let unknowns = description.unknowns.len();
        // a batch stores a direction as cosine and sine
        let described = description.unknowns.iter();
        let mut sines: Vec<Vec<f64>> = described
            .map(|unknown| vec![f64::NAN; if unknown.is_direction { count } else { 0 }])
            .collect();
        let mut is_closed = true;
        for start in (0..count).step_by(BLOCK) {
            let rows = start..count.min(start + BLOCK);
            let mut wanted = sines_of(
                sines
                    .iter_mut()
                    .map(|sine| sine.get_mut(rows.clone()).unwrap_or_default()),
            );
            for (index, column) in results.chunks_exact_mut(count).enumerate() {
                let (quantity, order) = (index / orders, index % orders);
                let slot = match quantity.checked_sub(unknowns) {
                    None => Slot::Unknown(quantity, order),
                    Some(output) => Slot::Output(output, order),
                };
                wanted.push((slot, &mut column[rows.clone()]));
            }
            is_closed &= solve(rows.clone(), wanted, &mut table.outcomes[rows.clone()])?;
            progress(part(rows.end, count));
        }
        for (unknown, sines) in sines.iter().enumerate() {
            angles_from_cosines(
                &mut results[unknown * orders * count..(unknown * orders + 1) * count],
                sines,
            );
        }
        Ok(is_closed)
    }

    /// Writes the values of the variable.
    #[expect(clippy::cast_precision_loss, reason = "a table has far fewer rows than 2⁵³")]
    fn write_variable(&self, column: &mut [f64]) {
        let way = self.to - self.from;
        let last = self.count.saturating_sub(1).max(1) as f64;
        // Without a branch, and with numbers of 32 bits that vectors can convert, so that several are calculated at
        // once. The rest is there for columns of 17 gigabytes and more.
        let (short, long) = column.split_at_mut(column.len().min(1 << 31));
        for (row, value) in (0_i32..).zip(short.iter_mut()) {
            *value = self.from + way * (f64::from(row) / last);
        }
        for (row, value) in long.iter_mut().enumerate() {
            *value = self.from + way * ((row + short.len()) as f64 / last);
        }
        for row in [0, self.count - 1] {
            column[row] = self.at(row);
        }
    }

    /// Solves row after row. It returns whether every row closes.
    fn fill_by_steps(&self, table: &mut Table, progress: &mut dyn FnMut(f64)) -> bool {
        let count = table.count;
        let mut walk = Walk::BEGINNING;
        for row in 0..count {
            let at = self.at(row);
            let motions = self.motions(at);
            let reached = walk.step(self, at, &motions);
            table.outcomes[row] = outcome(&reached);
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

    /// Passes on the numbers of a row of a table, each with its column. Without a pose, those of unknowns and outputs
    /// are NaN.
    pub(super) fn write(
        &self,
        at: f64,
        motions: &[f64],
        reached: Option<&Footing<'_>>,
        mut put: impl FnMut(usize, f64),
    ) {
        let first_input = match self.drive.variable() {
            Variable::Input(_) => 0,
            Variable::Time | Variable::Row => 1,
        };
        if first_input > 0 {
            put(0, at);
        }
        let given = reached.map_or(motions, |reached| &reached.numbers);
        for (column, value) in given.iter().enumerate() {
            put(first_input + column, *value);
        }
        let results = self.description.unknowns.len() + self.description.outputs.len();
        for column in given.len()..motions.len() + results * self.orders() {
            put(first_input + column, f64::NAN);
        }
    }
}

/// The outcome of a row.
pub(super) fn outcome<T>(result: &Result<T, SolveError>) -> Outcome {
    result.as_ref().map_or_else(Outcome::from, |_| Outcome::Solved)
}

/// The sines of the unknowns that have a column for them.
fn sines_of<'s>(columns: impl Iterator<Item = &'s mut [f64]>) -> Vec<(Slot, &'s mut [f64])> {
    let all = columns.enumerate().filter(|(_, column)| !column.is_empty());
    all.map(|(unknown, column)| (Slot::Sine(unknown), column)).collect()
}
