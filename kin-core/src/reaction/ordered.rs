//! Linear equations in series, order by order: each term follows from the factors of the values alone.

use alloc::vec;
use alloc::vec::Vec;

use crate::failure::Failure;
use crate::number::Number;
use crate::number::series::Series;
use crate::solve::{FactorRow, factor_in, substitute_in};

/// A square matrix of series with the factors of its values.
pub(super) struct OrderedSystem<const N: usize> {
    factors: Vec<f64>,
    rows: Vec<FactorRow>,
    /// The entries that change, with their rows and columns.
    changing: Vec<(usize, usize, Series<N>)>,
}

impl<const N: usize> OrderedSystem<N> {
    /// A matrix, by its columns.
    pub(super) fn new<'c>(columns: impl ExactSizeIterator<Item = &'c Vec<Series<N>>>) -> Result<Self, Failure> {
        let count = columns.len();
        let mut factors = vec![0.0; count * count];
        let mut changing = Vec::new();
        for (column, entries) in columns.enumerate() {
            for (row, entry) in entries.iter().enumerate() {
                factors[row * count + column] = entry.real();
                if entry.coefficients()[1..].iter().any(|term| *term != 0.0) {
                    changing.push((row, column, *entry));
                }
            }
        }
        let mut rows = vec![FactorRow::default(); count];
        factor_in(&mut factors, &mut rows)?;
        Ok(Self {
            factors,
            rows,
            changing,
        })
    }

    /// The solution for a right-hand side.
    pub(super) fn solve(&self, right: &[Series<N>]) -> Vec<Series<N>> {
        let count = self.rows.len();
        let mut solution = vec![[0.0; N]; count];
        let mut rest = vec![0.0; count];
        let mut term = vec![0.0; count];
        for order in 0..N {
            for (rest, right) in rest.iter_mut().zip(right) {
                *rest = right.coefficients()[order];
            }
            for (row, column, entry) in &self.changing {
                let entry = entry.coefficients();
                let known = solution[*column][..order].iter().rev();
                let terms = entry[1..].iter().zip(known);
                rest[*row] -= terms.map(|(entry, known)| entry * known).sum::<f64>();
            }
            substitute_in(&self.factors, &self.rows, &rest, &mut term);
            for (solution, term) in solution.iter_mut().zip(&term) {
                solution[order] = *term;
            }
        }
        solution.into_iter().map(Series::from_coefficients).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::vec;
    use std::vec::Vec;

    use super::OrderedSystem;
    use crate::number::Number as _;
    use crate::number::series::Series;
    use crate::verify::Random;

    #[test]
    fn the_solution_gives_the_right_side() {
        let mut random = Random::new(5);
        for count in 1..6 {
            let mut series =
                |size: f64| Series::<6>::from_coefficients(core::array::from_fn(|_| random.between(-size, size)));
            let mut columns: Vec<Vec<_>> = (0..count).map(|_| (0..count).map(|_| series(1.0)).collect()).collect();
            for (index, column) in columns.iter_mut().enumerate() {
                column[index] = column[index] + Series::constant(8.0);
            }
            let right: Vec<_> = (0..count).map(|_| series(3.0)).collect();
            let system = OrderedSystem::new(columns.iter()).expect("it is regular");
            let mut sums = vec![Series::ZERO; count];
            for (column, value) in columns.iter().zip(system.solve(&right)) {
                for (sum, entry) in sums.iter_mut().zip(column) {
                    *sum = *sum + *entry * value;
                }
            }
            for (sum, right) in sums.iter().zip(&right) {
                for (sum, right) in sum.coefficients().into_iter().zip(right.coefficients()) {
                    assert!((sum - right).abs() < 1e-13, "{sum} {right}");
                }
            }
        }
    }
}
