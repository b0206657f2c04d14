//! The memory of a track.

#[cfg(feature = "alloc")]
use alloc::vec;
#[cfg(feature = "alloc")]
use alloc::vec::Vec;

#[cfg(feature = "alloc")]
use super::Description;
use crate::number::series::Series;
use crate::solve::lent_factors_length;

/// A value with its first derivative, as coefficients of a series.
pub type First = Series<2>;

/// A value with its first and second derivative, as coefficients of a series.
pub type Second = Series<3>;

/// Memory that a caller lends to a track: as many numbers and series as [`Memory`] counts.
#[derive(Debug)]
pub struct Lent<'l> {
    /// The numbers.
    pub numbers: &'l mut [f64],
    /// The series of first order.
    pub first: &'l mut [First],
    /// The series of second order, as many.
    pub second: &'l mut [Second],
}

/// The counts of the quantities of a mechanism, and the memory that its track takes.
#[derive(Clone, Copy, Debug)]
pub struct Memory {
    /// The number of parameters.
    pub parameters: usize,
    /// The number of inputs.
    pub inputs: usize,
    /// The number of unknowns.
    pub unknowns: usize,
    /// The number of blocks.
    pub blocks: usize,
    /// The number of derivatives, with the value.
    pub orders: usize,
}

impl Memory {
    /// The count of numbers.
    #[must_use]
    pub const fn numbers(self) -> usize {
        let (unknowns, orders) = (self.unknowns, self.orders);
        let sides = 2 * self.blocks;
        let linear = unknowns * unknowns + 2 * unknowns;
        let factors = lent_factors_length(unknowns);
        let station = unknowns * (orders + 2) + sides;
        let curve = 3 * unknowns + sides;
        // Stations and curves that are alive at the same time, the matrices of the deepest calls, and rows beside them.
        8 * station + 6 * curve + 4 * (linear + factors) + 36 * (unknowns + 1) + (self.inputs + 2) * (orders + 4)
    }

    /// The count of series of each order.
    #[must_use]
    pub const fn series(self) -> usize {
        self.parameters + self.inputs + 2 * self.unknowns
    }
}

/// The memory of a track, of the heap.
#[cfg(feature = "alloc")]
#[derive(Debug)]
pub(crate) struct HeapMemory {
    numbers: Vec<f64>,
    first: Vec<First>,
    second: Vec<Second>,
}

#[cfg(feature = "alloc")]
impl HeapMemory {
    pub(crate) fn new(description: &Description<'_>, parameters: usize) -> Self {
        let memory = Memory {
            parameters,
            inputs: description.inputs.len(),
            unknowns: description.unknowns.len(),
            blocks: description.blocks.len(),
            orders: description.order + 1,
        };
        Self {
            numbers: vec![0.0; memory.numbers()],
            first: vec![First::ZERO; memory.series()],
            second: vec![Second::ZERO; memory.series()],
        }
    }

    pub(crate) fn lend(&mut self) -> Lent<'_> {
        Lent {
            numbers: &mut self.numbers,
            first: &mut self.first,
            second: &mut self.second,
        }
    }
}
