//! Batches: many poses at once.

use kin_core::__private::live::FactorRow;
use kin_core::any::PositionChoice;
use kin_core::batch::{
    AnyBatch, CHUNKS, GivenColumns, LengthMismatch, Numbers, Outcome, SliceSolver, Summary, Vectors, WantedColumns,
    solve_slices,
};
use kin_core::{Scalar, SolveError};

use crate::mechanism::Mechanism;
use crate::motion::FoundMotion;

/// Memory that serves many poses.
#[derive(Debug)]
pub struct BatchMemory<T> {
    numbers: Vec<T>,
    near: Vec<T>,
    reals: Vec<f64>,
    rows: Vec<FactorRow>,
}

impl SliceSolver for Mechanism {
    type Memory<T> = BatchMemory<T>;

    fn memory<T: Scalar>(&self) -> BatchMemory<T> {
        let lengths = self.motion.lengths();
        let zero = T::constant(0.0);
        BatchMemory {
            numbers: vec![zero; lengths.numbers(CHUNKS)],
            near: vec![zero; self.motion.near_length()],
            reals: vec![0.0; lengths.reals],
            rows: vec![FactorRow::default(); CHUNKS * lengths.rows],
        }
    }

    fn solve_alone(
        &self,
        parameters: &[f64],
        inputs: &[f64],
        choice: PositionChoice<'_, f64>,
        found: &mut Numbers<f64>,
    ) -> Result<(), SolveError> {
        let inputs = self.motions(inputs);
        let write = |motion: FoundMotion<'_, f64>| motion.write_columns(found);
        let result = match choice {
            PositionChoice::Assembly(index) => {
                let choice = self.motion.in_assembly(index);
                self.motion.solve(parameters, inputs, choice, write)
            }
            PositionChoice::Near(near) => self.motion.near(parameters, inputs, near, |choice| {
                self.motion.solve(parameters, inputs, choice, write)
            }),
        };
        result.map_err(|fault| self.error(fault, parameters, inputs))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn solve<T: Scalar>(
        &self,
        memory: &mut BatchMemory<T>,
        parameters: &[T],
        inputs: &[T],
        choice: PositionChoice<'_, T>,
        found: &mut [Numbers<T>],
    ) -> Result<(), SolveError> {
        let inputs = self.motions(inputs);
        let BatchMemory {
            numbers,
            near: values,
            reals,
            rows,
        } = memory;
        let chunks = found.len();
        let memory = self.motion.lengths().parts::<_, CHUNKS>(numbers, reals, rows);
        let choice = match choice {
            PositionChoice::Assembly(index) => Ok(self.motion.in_assembly(index)),
            PositionChoice::Near(near) => self.motion.near_in(values, parameters, inputs, near),
        };
        let write = |chunk: usize, motion: FoundMotion<'_, T, CHUNKS>| motion.write_columns(&mut found[chunk]);
        choice
            .and_then(|choice| {
                self.motion
                    .solve_chunks(memory, chunks, parameters, inputs, choice, write)
            })
            .map_err(|fault| self.error(fault, parameters, inputs))
    }
}

impl AnyBatch for Mechanism {
    fn solve_batch(
        &self,
        given: GivenColumns<'_>,
        wanted: &mut WantedColumns<'_>,
        outcomes: &mut [Outcome],
        vectors: Vectors,
    ) -> Result<Summary, LengthMismatch> {
        solve_slices(self, given, wanted, outcomes, vectors)
    }
}
