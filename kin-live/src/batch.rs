//! Batches: many poses at once.

use kin_core::__private::live::FactorRow;
use kin_core::any::PositionChoice;
use kin_core::batch::{
    AnyBatch, GivenColumns, LengthMismatch, Numbers, Outcome, SliceSolver, Summary, Vectors, WantedColumns,
    solve_slices,
};
use kin_core::{Scalar, SolveError};

use crate::mechanism::Mechanism;
use crate::memory::Lengths;
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

    fn memory<T: Scalar>(&self, chunks: usize) -> BatchMemory<T> {
        let Lengths {
            registers,
            row,
            reals,
            rows,
        } = self.motion.lengths().of_chunks(chunks);
        let zero = T::constant(0.0);
        BatchMemory {
            numbers: vec![zero; registers + row],
            near: vec![zero; self.motion.near_length()],
            reals: vec![0.0; reals],
            rows: vec![FactorRow::default(); rows],
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn solve<T: Scalar>(
        &self,
        memory: &mut BatchMemory<T>,
        parameters: &[T],
        inputs: &[T],
        choice: PositionChoice<'_, T>,
        found: &mut Numbers<T>,
    ) -> Result<(), SolveError> {
        let inputs = self.motions(inputs);
        let BatchMemory {
            numbers,
            near: values,
            reals,
            rows,
        } = memory;
        let memory = self.motion.lengths().parts(numbers, reals, rows);
        let write = |motion: FoundMotion<'_, T>| motion.write_columns(found);
        let result = match choice {
            PositionChoice::Assembly(index) => {
                let choice = self.motion.in_assembly(index);
                self.motion.solve_in(memory, parameters, inputs, choice, write)
            }
            PositionChoice::Near(near) => self.motion.near_in(values, parameters, inputs, near, |choice| {
                self.motion.solve_in(memory, parameters, inputs, choice, write)
            }),
        };
        result.map_err(|fault| self.error(fault, parameters, inputs))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn solve_chunks<T: Scalar, const CHUNKS: usize>(
        &self,
        memory: &mut BatchMemory<T>,
        parameters: &[T],
        inputs: &[T],
        assembly: usize,
        found: &mut [Numbers<T>],
    ) -> bool {
        let BatchMemory {
            numbers, reals, rows, ..
        } = memory;
        let lengths = self.motion.lengths().of_chunks(CHUNKS);
        let memory = lengths.parts(numbers, reals, rows);
        let choice = self.motion.in_assembly(assembly);
        let write = |chunk: usize, motion: FoundMotion<'_, T>| motion.write_columns(&mut found[chunk]);
        let motions = self.motions(inputs);
        let result = self
            .motion
            .solve_chunks::<T, CHUNKS>(memory, parameters, motions, choice, write);
        result.is_ok()
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
