//! Motions in a slice.

use std::vec::Vec;

use crate::number::Row;

/// Motions one after the other, each with all its orders.
#[derive(Clone, Copy, Debug)]
pub(super) struct Motions<'m> {
    numbers: &'m [f64],
    orders: usize,
}

impl<'m> Motions<'m> {
    pub(super) const fn new(numbers: &'m [f64], orders: usize) -> Self {
        Self { numbers, orders }
    }

    pub(super) fn each(self) -> impl ExactSizeIterator<Item = &'m [f64]> {
        self.numbers.chunks_exact(self.orders)
    }

    pub(super) fn count(self) -> usize {
        self.each().len()
    }

    /// The value of each motion.
    pub(super) fn values(self) -> Vec<f64> {
        self.numbers.iter().copied().step_by(self.orders).collect()
    }
}

/// Typed motions as numbers one after the other.
pub(super) fn flat<R: Row<f64>>(motions: &[R]) -> Vec<f64> {
    motions.iter().flat_map(AsRef::as_ref).copied().collect()
}
