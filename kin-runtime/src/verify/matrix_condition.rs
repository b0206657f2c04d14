//! The condition of a matrix.

use std::vec::Vec;

/// The norm ‖A⁻¹‖ in the maximum norm, by Gauss-Jordan elimination with row pivoting. For a matrix scaled to rows of
/// size 1 it is the condition. It is at least 1, and infinite or NaN if the matrix is singular.
pub(super) fn condition(matrix: Vec<Vec<f64>>) -> f64 {
    let size = matrix.len();
    let norm = |rows: &[Vec<f64>]| {
        rows.iter()
            .map(|row| row.iter().map(|entry| entry.abs()).sum::<f64>())
            .fold(0.0_f64, f64::max)
    };
    let mut left = matrix;
    let mut inverse: Vec<Vec<f64>> = (0..size)
        .map(|row| (0..size).map(|column| if row == column { 1.0 } else { 0.0 }).collect())
        .collect();
    for step in 0..size {
        let pivot = (step..size)
            .max_by(|&a, &b| left[a][step].abs().total_cmp(&left[b][step].abs()))
            .unwrap_or(step);
        left.swap(step, pivot);
        inverse.swap(step, pivot);
        let scale = left[step][step];
        for column in 0..size {
            left[step][column] /= scale;
            inverse[step][column] /= scale;
        }
        for row in (0..size).filter(|&row| row != step) {
            let factor = left[row][step];
            for column in 0..size {
                left[row][column] -= factor * left[step][column];
                inverse[row][column] -= factor * inverse[step][column];
            }
        }
    }
    norm(&inverse).max(1.0)
}

#[cfg(test)]
mod tests {
    use super::condition;
    use std::vec;

    #[test]
    fn of_matrices_with_known_inverses() {
        assert_eq!(condition(vec![vec![1.0, 0.0], vec![0.0, 0.25]]), 4.0);
        // The inverse is [[0, 1], [1, -2]].
        assert_eq!(condition(vec![vec![2.0, 1.0], vec![1.0, 0.0]]), 3.0);
        assert_eq!(condition(vec![vec![8.0]]), 1.0);
        assert!(!condition(vec![vec![1.0, 1.0], vec![1.0, 1.0]]).is_finite());
    }
}
