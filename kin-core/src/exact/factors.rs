//! Linear equations of a curve, which has one coordinate more than a mechanism has unknowns.

use alloc::vec;
use alloc::vec::Vec;

use crate::solve::{LentFactors, lent_factors_length};

/// The triangular factors of a square matrix.
pub(super) struct CurveFactors {
    memory: Vec<f64>,
    count: usize,
}

impl CurveFactors {
    /// The factors of the matrix with these entries, given by row and column; `None` if the matrix is singular or not finite.
    pub(super) fn new(count: usize, entry: impl Fn(usize, usize) -> f64) -> Option<Self> {
        let mut memory = vec![0.0; lent_factors_length(count)];
        let orientation = LentFactors::new(&mut memory, count, entry).orientation();
        let is_regular = orientation.sign != 0.0 && orientation.logarithm.is_finite();
        is_regular.then_some(Self { memory, count })
    }

    /// The sign of the determinant.
    pub(super) fn sign(&self) -> f64 {
        self.factors().orientation().sign
    }

    /// The solution for a right-hand side.
    pub(super) fn solve(&self, right: &[f64]) -> Vec<f64> {
        let mut solution = right.to_vec();
        self.factors().solve(right, &mut solution);
        solution
    }

    fn factors(&self) -> LentFactors<'_> {
        LentFactors::read(&self.memory, self.count)
    }
}
