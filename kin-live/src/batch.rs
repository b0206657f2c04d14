//! Batches: many poses at once.

use kin_core::__private::live::FactorRow;
use kin_core::any::PositionChoice;
use kin_core::batch::{
    AnyBatch, GivenColumns, LengthMismatch, Numbers, Outcome, SliceSolver, Summary, Vectors, WantedColumns,
    solve_slices,
};
#[cfg(feature = "folds")]
use kin_core::batch::{AnyFold, Fold, FoldError, InputGrid, KeptMemory, fold_slices};
use kin_core::{Scalar, SolveError, TransmissionAngle};

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

impl<T> Default for BatchMemory<T> {
    fn default() -> Self {
        Self {
            numbers: Vec::new(),
            near: Vec::new(),
            reals: Vec::new(),
            rows: Vec::new(),
        }
    }
}

impl SliceSolver for Mechanism {
    type Memory<T: Send + 'static> = BatchMemory<T>;

    fn prepare<T: Scalar + Send + 'static>(&self, memory: &mut BatchMemory<T>, chunks: usize) {
        let lengths = self.motion.lengths();
        let zero = T::constant(0.0);
        let alone = [self.motion.lengths_of_orientations(), self.transmission.lengths()];
        let alone = alone.map(|lengths| lengths.numbers(1)).into_iter().max();
        let numbers = lengths.numbers(chunks).max(alone.unwrap_or(0));
        memory.numbers.resize(numbers, zero);
        memory.near.resize(self.motion.near_length(), zero);
        memory.reals.resize(lengths.reals, 0.0);
        memory.rows.resize(chunks * lengths.rows, FactorRow::default());
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
    fn solve<T: Scalar + Send + 'static, const CHUNKS: usize>(
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
        // A closure that calls the machine would be compiled by itself, for the narrowest vectors.
        let choice = match choice {
            PositionChoice::Assembly(index) => Ok(self.motion.in_assembly(index)),
            PositionChoice::Near(near) => {
                let memory = self.motion.lengths_of_orientations().parts(numbers, &mut [], &mut []);
                self.motion.near_in(values, memory, parameters, inputs, near)
            }
        };
        let result = match choice {
            Ok(choice) => {
                let memory = self.motion.lengths().parts::<_, CHUNKS>(numbers, reals, rows);
                let write = |chunk: usize, motion: FoundMotion<'_, T, CHUNKS>| motion.write_columns(&mut found[chunk]);
                self.motion
                    .solve_chunks(memory, chunks, parameters, inputs, choice, write)
            }
            Err(fault) => Err(fault),
        };
        result.map_err(|fault| self.error(fault, parameters, inputs))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn angles_of_dyads<T: Scalar + Send + 'static>(
        &self,
        memory: &mut BatchMemory<T>,
        parameters: &[T],
        inputs: &[T],
        unknowns: &[T],
        angles: &mut [TransmissionAngle<T>],
    ) {
        let memory = self.transmission.lengths().parts(&mut memory.numbers, &mut [], &mut []);
        self.angles_of_dyads_in(memory, parameters, self.motions(inputs), unknowns, angles);
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

#[cfg(feature = "folds")]
impl AnyFold for Mechanism {
    fn fold_batch(
        &self,
        grid: InputGrid,
        given: GivenColumns<'_>,
        folds: &mut [Fold],
        memory: &mut KeptMemory,
        vectors: Vectors,
    ) -> Result<Summary, FoldError> {
        fold_slices(self, grid, given, folds, memory, vectors)
    }
}
