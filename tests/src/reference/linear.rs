//! Linear equations of many digits.

use kin_precise::Number;

use super::series::number;

/// Row by row.
pub(super) type Matrix = Vec<Vec<Number>>;

/// The inverse by Gauss and Jordan, rows exchanged for the largest pivot; none if a pivot is zero.
pub(super) fn inverse(mut matrix: Matrix) -> Option<Matrix> {
    let size = matrix.len();
    for (index, row) in matrix.iter_mut().enumerate() {
        row.extend((0..size).map(|column| number(usize::from(column == index))));
    }
    for column in 0..size {
        let magnitude = |row: &usize| matrix[*row][column].abs().nearest();
        let pivot = (column..size).max_by(|one, other| magnitude(one).total_cmp(&magnitude(other)))?;
        matrix.swap(column, pivot);
        if matrix[column][column].is_zero() {
            return None;
        }
        let divisor = matrix[column][column].clone();
        let row: Vec<Number> = matrix[column].iter().map(|entry| entry / &divisor).collect();
        for (index, other) in matrix.iter_mut().enumerate() {
            if index != column && !other[column].is_zero() {
                let factor = other[column].clone();
                for (entry, own) in other.iter_mut().zip(&row) {
                    *entry = &*entry - &(&factor * own);
                }
            }
        }
        matrix[column] = row;
    }
    Some(matrix.into_iter().map(|row| row[size..].to_vec()).collect())
}

/// A matrix times a column.
pub(super) fn product(matrix: &Matrix, column: &[Number]) -> Vec<Number> {
    let row = |row: &Vec<Number>| {
        row.iter()
            .zip(column)
            .fold(Number::zero(), |sum, (entry, own)| &sum + &(entry * own))
    };
    matrix.iter().map(row).collect()
}
