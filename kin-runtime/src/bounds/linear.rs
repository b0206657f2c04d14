//! Systems of linear equations in numbers over an interval.
//!
//! The equations are multiplied by an approximate inverse of their matrix, which then is close to the unit matrix, and
//! Gaussian elimination widens nothing much (A. Neumaier, *Interval Methods for Systems of Equations*, Cambridge 1990,
//! chapter 4).

use alloc::vec;
use alloc::vec::Vec;

use super::{Bounds, UNBOUNDED};
use crate::number::Number;
use crate::solve::{FactorRow, factor_in, substitute_in};

/// An approximate inverse of a square matrix of plain numbers, both row by row.
pub(crate) fn inverse(matrix: &[f64], count: usize) -> Option<Vec<f64>> {
    let mut entries = matrix.to_vec();
    let mut rows = vec![FactorRow::default(); count];
    factor_in(&mut entries, &mut rows).ok()?;
    let mut inverse = vec![0.0; count * count];
    let mut solution = vec![0.0; count];
    for column in 0..count {
        let unit: Vec<f64> = (0..count).map(|row| f64::from(u8::from(row == column))).collect();
        substitute_in(&entries, &rows, &unit, &mut solution);
        for (row, entry) in solution.iter().enumerate() {
            inverse[row * count + column] = *entry;
        }
    }
    inverse.iter().all(|entry| entry.is_finite()).then_some(inverse)
}

/// The product of a matrix of plain numbers with a column.
pub(crate) fn times(matrix: &[f64], column: &[Bounds]) -> Vec<Bounds> {
    let row = |entries: &[f64]| {
        let terms = entries.iter().zip(column).filter(|(entry, _)| **entry != 0.0);
        let products = terms.map(|(entry, own)| *own * Bounds::constant(*entry));
        products.fold(Bounds::constant(0.0), |sum, product| sum + product)
    };
    matrix.chunks_exact(column.len().max(1)).map(row).collect()
}

/// A matrix whose every value over the interval is regular, ready for any number of right sides.
pub(crate) struct RegularMatrix<'i> {
    inverse: &'i [f64],
    /// The factors of the product with the inverse: multipliers below the diagonal.
    entries: Vec<Bounds>,
    count: usize,
}

impl<'i> RegularMatrix<'i> {
    /// A matrix, given by its columns, with an approximate inverse; `None` if it may be singular.
    pub(crate) fn new<'c>(inverse: &'i [f64], columns: impl ExactSizeIterator<Item = &'c Vec<Bounds>>) -> Option<Self> {
        let count = columns.len();
        let mut entries = vec![Bounds::constant(0.0); count * count];
        for (index, column) in columns.enumerate() {
            for (row, entry) in times(inverse, column).into_iter().enumerate() {
                entries[row * count + index] = entry;
            }
        }
        for step in 0..count {
            let pivot = entries[step * count + step];
            if !(pivot.low > 0.0 && pivot.high < UNBOUNDED) {
                return None;
            }
            for row in step + 1..count {
                let multiplier = entries[row * count + step] / pivot;
                entries[row * count + step] = multiplier;
                for column in step + 1..count {
                    let above = entries[step * count + column];
                    entries[row * count + column] = entries[row * count + column] - multiplier * above;
                }
            }
        }
        Some(Self {
            inverse,
            entries,
            count,
        })
    }

    /// The solution for a right side.
    pub(crate) fn solve(&self, right: &[Bounds]) -> Vec<Bounds> {
        let mut solution = times(self.inverse, right);
        for row in 0..self.count {
            for column in 0..row {
                solution[row] = solution[row] - self.entries[row * self.count + column] * solution[column];
            }
        }
        for row in (0..self.count).rev() {
            for column in row + 1..self.count {
                solution[row] = solution[row] - self.entries[row * self.count + column] * solution[column];
            }
            solution[row] = solution[row] / self.entries[row * self.count + row];
        }
        solution
    }
}

#[cfg(test)]
mod tests {
    use std::vec;
    use std::vec::Vec;

    use super::{RegularMatrix, inverse};
    use crate::bounds::Bounds;
    use crate::number::Number;

    /// [[2 + t, 1], [t, 3]] x = [1, t], by Cramer's rule.
    #[test]
    fn all_solutions_over_an_interval() {
        let t = Bounds::variable(-0.1, 0.1);
        let constant = Bounds::constant;
        let columns = [vec![constant(2.0) + t, t], vec![constant(1.0), constant(3.0)]];
        let known = inverse(&[2.0, 1.0, 0.0, 3.0], 2).unwrap();
        let found = RegularMatrix::new(&known, columns.iter())
            .unwrap()
            .solve(&[constant(1.0), t]);
        let exact = |t: f64| {
            let determinant = (2.0 + t) * 3.0 - t;
            [(3.0 - t) / determinant, ((2.0 + t) * t - t) / determinant]
        };
        for step in -10..=10 {
            let values = exact(f64::from(step) / 100.0);
            for (value, found) in values.iter().zip(&found) {
                assert!(found.low <= *value && *value <= found.high, "{value} {found:?}");
            }
        }
        let widths: Vec<f64> = found.iter().map(|found| found.high - found.low).collect();
        let [low, high] = [exact(-0.1), exact(0.1)];
        assert!(widths[0] < 1.5 * (low[0] - high[0]).abs() && widths[1] < 1.5 * (low[1] - high[1]).abs());
    }

    #[test]
    fn a_matrix_that_may_be_singular() {
        let columns = [
            vec![Bounds::variable(-1.0, 3.0), Bounds::constant(0.0)],
            vec![Bounds::constant(1.0); 2],
        ];
        let known = inverse(&[1.0, 1.0, 0.0, 1.0], 2).unwrap();
        assert!(RegularMatrix::new(&known, columns.iter()).is_none());
        assert!(inverse(&[1.0, 2.0, 2.0, 4.0], 2).is_none());
    }
}
