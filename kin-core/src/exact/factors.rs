//! Linear equations of a size that is known at run time.

use alloc::vec::Vec;

/// The triangular factors of a square matrix, by Gaussian elimination with the largest pivot of each column. Rows are
/// scaled by their largest entry first.
///
/// [`Factors`](crate::solve::Factors) have their size in their type. The matrices here have one row more than a mechanism
/// has unknowns, which no type can say.
pub(super) struct FactorsOfAnySize {
    rows: Vec<Vec<f64>>,
    /// The row of the matrix from which each row came, and the factor by which it was multiplied.
    origins: Vec<(usize, f64)>,
    /// The sign of the determinant.
    pub(super) orientation: f64,
}

impl FactorsOfAnySize {
    /// The factors, or `None` if the matrix is singular or not finite.
    pub(super) fn new(mut rows: Vec<Vec<f64>>) -> Option<Self> {
        let mut origins = Vec::with_capacity(rows.len());
        for (index, row) in rows.iter_mut().enumerate() {
            let largest = row.iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
            let factor = 1.0 / largest;
            if !(factor.is_finite() && row.iter().all(|entry| entry.is_finite())) {
                return None;
            }
            for entry in row.iter_mut() {
                *entry *= factor;
            }
            origins.push((index, factor));
        }
        let mut orientation = 1.0;
        for column in 0..rows.len() {
            let size = |row: &Vec<f64>| row[column].abs();
            let pivot = (column..rows.len()).max_by(|one, other| size(&rows[*one]).total_cmp(&size(&rows[*other])))?;
            if rows[pivot][column] == 0.0 {
                return None;
            }
            if pivot != column {
                rows.swap(pivot, column);
                origins.swap(pivot, column);
                orientation = -orientation;
            }
            let (above, below) = rows.split_at_mut(column + 1);
            let top = &above[column];
            orientation *= top[column].signum();
            for row in below {
                let multiplier = row[column] / top[column];
                row[column] = multiplier;
                for (entry, upper) in row.iter_mut().zip(top).skip(column + 1) {
                    *entry -= multiplier * upper;
                }
            }
        }
        Some(Self {
            rows,
            origins,
            orientation,
        })
    }

    /// The solution for a right-hand side.
    pub(super) fn solve(&self, right: &[f64]) -> Vec<f64> {
        let mut solution: Vec<f64> = self.origins.iter().map(|(row, factor)| right[*row] * factor).collect();
        for index in 0..solution.len() {
            let known = self.rows[index][..index].iter().zip(&solution);
            let sum: f64 = known.map(|(entry, value)| entry * value).sum();
            solution[index] -= sum;
        }
        for index in (0..solution.len()).rev() {
            let known = self.rows[index].iter().zip(&solution).skip(index + 1);
            let sum: f64 = known.map(|(entry, value)| entry * value).sum();
            solution[index] = (solution[index] - sum) / self.rows[index][index];
        }
        solution
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    #[test]
    fn the_solution_solves_and_the_sign_is_that_of_the_determinant() {
        let matrix = vec![vec![0.0, 2.0, 1.0], vec![1.0, -1.0, 0.5], vec![3.0, 0.0, 4.0]];
        // 0 (-4) - 2 (4 - 1.5) + 1 (0 + 3) = -2
        let factors = FactorsOfAnySize::new(matrix.clone()).unwrap();
        assert_eq!(factors.orientation, -1.0);
        let solution = factors.solve(&[1.0, 2.0, 3.0]);
        for (row, right) in matrix.iter().zip([1.0, 2.0, 3.0]) {
            let left: f64 = row.iter().zip(&solution).map(|(entry, value)| entry * value).sum();
            assert!((left - right).abs() < 1e-14, "{solution:?}");
        }
        assert!(FactorsOfAnySize::new(vec![vec![1.0, 2.0], vec![2.0, 4.0]]).is_none());
        assert!(FactorsOfAnySize::new(vec![vec![f64::NAN]]).is_none());
    }
}
