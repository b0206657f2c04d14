//! The memory of a run, which its caller lends.

use kin_core::__private::live::FactorRow;
use kin_core::Scalar;

/// The lengths of the memory of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Lengths {
    /// The registers.
    pub(crate) registers: usize,
    /// The entries of factors.
    pub(crate) entries: usize,
    /// Numbers side by side, as functions for rows take them.
    pub(crate) row: usize,
    /// Real numbers of Newton's method.
    pub(crate) reals: usize,
    /// Rows of factors.
    pub(crate) rows: usize,
}

/// The memory of a run over `C` chunks of poses.
#[derive(Debug)]
pub(crate) struct Memory<'m, T, const C: usize> {
    /// Registers, each with its number in every chunk.
    pub(crate) registers: &'m mut [[T; C]],
    /// Entries of factors, chunk by chunk. Rows are in the same order.
    pub(crate) entries: &'m mut [T],
    pub(crate) row: &'m mut [T],
    pub(crate) reals: &'m mut [f64],
    pub(crate) rows: &'m mut [FactorRow],
}

/// The numbers for which memory stands on the stack.
const MOST: usize = 256;
/// The numbers for which memory stands on the stack, for a small mechanism.
const FEW: usize = 96;
/// The rows of factors, and the real numbers of Newton's method, for which memory stands on the stack.
const ROWS: usize = 24;
const REALS: usize = 128;

impl Lengths {
    /// Calls a function with memory of these lengths. The memory is on the stack, unless the mechanism is very large.
    ///
    /// The memory holds one of the numbers that are `given`, since making another one would be recorded in a tape.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn lend<T: Scalar, R>(self, given: [&[T]; 2], function: impl FnOnce(Memory<'_, T, 1>) -> R) -> R {
        let given = given.into_iter().flatten().next();
        let any = given.copied().unwrap_or_else(|| T::constant(0.0));
        let count = self.numbers(1);
        if count <= FEW && self.rows == 0 && self.reals == 0 {
            let mut numbers = [any; FEW];
            return function(self.parts(&mut numbers, &mut [], &mut []));
        }
        if count <= MOST && self.rows <= ROWS && self.reals <= REALS {
            let mut numbers = [any; MOST];
            return function(self.parts(&mut numbers, &mut [0.0; REALS], &mut [FactorRow::default(); ROWS]));
        }
        let mut numbers = vec![any; count];
        let (mut reals, mut rows) = (vec![0.0; self.reals], vec![FactorRow::default(); self.rows]);
        function(self.parts(&mut numbers, &mut reals, &mut rows))
    }

    /// The numbers that several chunks take.
    pub(crate) fn numbers(self, chunks: usize) -> usize {
        chunks * (self.registers + self.entries) + self.row
    }

    /// The parts of some memory that is large enough.
    pub(crate) fn parts<'m, T, const C: usize>(
        self,
        numbers: &'m mut [T],
        reals: &'m mut [f64],
        rows: &'m mut [FactorRow],
    ) -> Memory<'m, T, C> {
        let (registers, rest) = numbers.split_at_mut(C * self.registers);
        let (entries, row) = rest.split_at_mut(C * self.entries);
        Memory {
            registers: registers.as_chunks_mut().0,
            entries,
            row,
            reals,
            rows,
        }
    }
}
