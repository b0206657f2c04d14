//! The few operations on small matrices that the campaign needs.

/// A matrix, row by row.
pub(super) type Matrix = Vec<Vec<f64>>;

/// Scales that make the largest entry of every row and column of a matrix about 1, by alternating square roots (D.
/// Ruiz, *A scaling algorithm to equilibrate both rows and columns norms in matrices*, Rutherford Appleton Laboratory
/// 2001).
fn balance(matrix: &Matrix) -> (Vec<f64>, Vec<f64>) {
    let columns = matrix.first().map_or(0, Vec::len);
    let (mut rows, mut scales) = (vec![1.0; matrix.len()], vec![1.0; columns]);
    for _ in 0..6 {
        let entry = |row: usize, column: usize| (matrix[row][column] * rows[row] * scales[column]).abs();
        let root = |largest: f64| if largest > 0.0 { largest.sqrt().recip() } else { 1.0 };
        let by_rows: Vec<f64> = (0..rows.len())
            .map(|row| root((0..columns).map(|column| entry(row, column)).fold(0.0, f64::max)))
            .collect();
        let by_columns: Vec<f64> = (0..columns)
            .map(|column| root((0..rows.len()).map(|row| entry(row, column)).fold(0.0, f64::max)))
            .collect();
        for (scale, factor) in rows.iter_mut().zip(by_rows).chain(scales.iter_mut().zip(by_columns)) {
            *scale *= factor;
        }
    }
    (rows, scales)
}

/// Solves for several right sides at once, by Gauss-Jordan elimination with row pivoting; and the determinant, zero
/// where the matrix is singular.
fn eliminate(mut left: Matrix, mut right: Matrix) -> (Matrix, f64) {
    let size = left.len();
    let mut determinant = 1.0;
    for step in 0..size {
        let pivot = (step..size)
            .max_by(|&a, &b| left[a][step].abs().total_cmp(&left[b][step].abs()))
            .unwrap_or(step);
        if pivot != step {
            determinant = -determinant;
        }
        left.swap(step, pivot);
        right.swap(step, pivot);
        let (own, own_right) = (left[step].clone(), right[step].clone());
        determinant *= own[step];
        for row in (0..size).filter(|&row| row != step) {
            let factor = left[row][step] / own[step];
            for (entry, own) in left[row].iter_mut().zip(&own) {
                *entry -= factor * own;
            }
            for (entry, own) in right[row].iter_mut().zip(&own_right) {
                *entry -= factor * own;
            }
        }
        for entry in &mut right[step] {
            *entry /= own[step];
        }
        for entry in &mut left[step] {
            *entry /= own[step];
        }
    }
    (right, determinant)
}

/// The inverse; its entries are not finite where there is none.
pub(super) fn inverse(matrix: &Matrix) -> Matrix {
    let (rows, columns) = balance(matrix);
    let scaled = scaled(matrix, &rows, &columns);
    let identity = (0..rows.len())
        .map(|row| {
            (0..rows.len())
                .map(|column| f64::from(u8::from(row == column)))
                .collect()
        })
        .collect();
    let (mut inverse, _) = eliminate(scaled, identity);
    for (row, own) in inverse.iter_mut().zip(&columns) {
        for (entry, scale) in row.iter_mut().zip(&rows) {
            *entry *= own * scale;
        }
    }
    inverse
}

/// The determinant.
pub(super) fn determinant(matrix: Matrix) -> f64 {
    let size = matrix.len();
    eliminate(matrix, vec![Vec::new(); size]).1
}

fn scaled(matrix: &Matrix, rows: &[f64], columns: &[f64]) -> Matrix {
    matrix
        .iter()
        .zip(rows)
        .map(|(row, own)| {
            row.iter()
                .zip(columns)
                .map(|(entry, scale)| entry * own * scale)
                .collect()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{determinant, inverse};

    #[test]
    fn an_inverse_of_entries_of_all_sizes() {
        let found = inverse(&vec![vec![2e8, 1e-8], vec![1e8, 0.0]]);
        // The scales are no powers of two, and so the entries are rounded.
        for (found, expected) in found.concat().into_iter().zip([0.0, 1e-8, 1e8, -2e8_f64]) {
            assert!(
                (found - expected).abs() <= 4.0 * f64::EPSILON * expected.abs(),
                "{found} {expected}"
            );
        }
        assert!(
            inverse(&vec![vec![1.0, 1.0], vec![1.0, 1.0]])
                .concat()
                .iter()
                .any(|entry| !entry.is_finite())
        );
    }

    #[test]
    fn the_sign_of_a_determinant() {
        assert_eq!(determinant(vec![vec![0.0, 4.0], vec![0.5, 0.0]]), -2.0);
        assert_eq!(determinant(vec![vec![1.0, 2.0], vec![2.0, 4.0]]), 0.0);
    }
}
