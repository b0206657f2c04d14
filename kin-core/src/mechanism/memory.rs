//! The memory of a track.

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
        8 * station + 6 * curve + 4 * (linear + factors) + 32 * unknowns + (self.inputs + 2) * (orders + 4)
    }

    /// The count of series of each order.
    #[must_use]
    pub const fn series(self) -> usize {
        self.parameters + self.inputs + 2 * self.unknowns
    }
}
