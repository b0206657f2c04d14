//! Newton's method.

use kin_core::__private::live::{Equations, NewtonMemory, largest_in, newton_in};
use kin_core::{Failure, Scalar};

use super::{Run, Way, arithmetic};
use crate::code::{Call, Operation, Register};
use crate::memory::Memory;

impl<T: Scalar, W: Way<T>, const C: usize> Run<'_, '_, T, W, C> {
    /// Newton's method from the guess.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn newton(&mut self, call: &Call) -> Result<(), Failure> {
        let Call::Newton {
            unknowns,
            registers,
            are_lengths,
            lengths,
            body,
            residuals,
            jacobian,
            ..
        } = call
        else {
            return Ok(());
        };
        let (constants, chunk) = (&self.code.constants, self.chunk);
        let near = self.choice.near.unwrap_or_default();
        let near = near.get(chunk * self.choice.unknowns..).unwrap_or_default();
        let count = unknowns.len();
        let size = if are_lengths.contains(&true) {
            largest_in(self.row(lengths))
        } else {
            T::constant(1.0)
        };
        let Memory {
            registers: values,
            row,
            reals,
            rows,
            ..
        } = &mut self.memory;
        let rows = &mut rows[chunk * self.code.lengths.rows..(chunk + 1) * self.code.lengths.rows];
        let (solution, row) = row.split_at_mut(count);
        let (sizes, numbers) = row.split_at_mut(count);
        for (index, unknown) in unknowns.iter().enumerate() {
            solution[index] = near.get(*unknown).copied().unwrap_or_else(|| T::constant(f64::NAN));
            sizes[index] = if are_lengths[index] { size } else { T::constant(1.0) };
        }
        let first_row = rows.len() - NewtonMemory::<T>::lengths(count)[2];
        let Some(memory) = NewtonMemory::new(count, numbers, reals, &mut rows[first_row..]) else {
            unreachable!("the code states how much memory it needs");
        };
        let equations = BlockEquations {
            values,
            chunk,
            constants,
            registers,
            body,
            residuals,
            jacobian,
        };
        newton_in(solution, sizes, memory, equations)?;
        for (register, unknown) in registers.iter().zip(&*solution) {
            values[usize::from(*register)][chunk] = *unknown;
        }
        Ok(())
    }
}

/// The equations of a block, in the registers of a run.
struct BlockEquations<'r, T, const C: usize> {
    values: &'r mut [[T; C]],
    chunk: usize,
    constants: &'r [f64],
    /// The registers of the unknowns.
    registers: &'r [Register],
    body: &'r [Operation],
    residuals: &'r [Register],
    jacobian: &'r [Register],
}

impl<T: Scalar, const C: usize> Equations<T> for BlockEquations<'_, T, C> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn evaluate(&mut self, unknowns: &[T], residuals: &mut [T], jacobian: &mut [T]) {
        let (values, chunk) = (&mut *self.values, self.chunk);
        for (register, unknown) in self.registers.iter().zip(unknowns) {
            values[usize::from(*register)][chunk] = *unknown;
        }
        for operation in self.body {
            arithmetic(values, chunk..chunk + 1, self.constants, *operation);
        }
        for (slot, register) in residuals.iter_mut().zip(self.residuals) {
            *slot = values[usize::from(*register)][chunk];
        }
        for (slot, register) in jacobian.iter_mut().zip(self.jacobian) {
            *slot = values[usize::from(*register)][chunk];
        }
    }
}
