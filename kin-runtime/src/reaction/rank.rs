//! The rank of a small matrix of numbers, and what it maps to zero.

use alloc::vec;
use alloc::vec::Vec;

/// A pivot is zero if it is at most this part of the largest entry: entries are known to a relative error of about the
/// rounding times the condition of the position.
const SMALLEST_PIVOT: f64 = 1e-12;

/// What an elimination with full pivoting tells of a matrix.
pub(super) struct Rank {
    /// The columns of the pivots, in ascending order.
    pub(super) basis: Vec<usize>,
    /// For each other column, the combination of columns with it that is zero.
    pub(super) null: Vec<Vec<f64>>,
    /// The last pivot that counts, or the first that does not, as a part of the largest.
    pub(super) pivot: f64,
}

/// The size of the largest entry.
pub(super) fn largest(entries: &[f64]) -> f64 {
    entries.iter().fold(0.0, |largest, entry| largest.max(entry.abs()))
}

/// Eliminates a matrix that is given by its columns. Each is first divided by its largest entry.
pub(super) fn rank(columns: &[Vec<f64>]) -> Rank {
    let sizes: Vec<f64> = columns.iter().map(|column| largest(column)).collect();
    let mut entries: Vec<Vec<f64>> = columns.to_vec();
    for (column, size) in entries.iter_mut().zip(&sizes) {
        if *size > 0.0 {
            for entry in column {
                *entry /= size;
            }
        }
    }
    let height = entries.first().map_or(0, Vec::len);
    // the row of the pivot of each column
    let mut pivot_of: Vec<Option<usize>> = vec![None; entries.len()];
    let mut is_used = vec![false; height];
    let (mut first, mut last) = (0.0, 0.0);
    for step in 0..height.min(entries.len()) {
        let mut best = (0.0, 0, 0);
        for (place, column) in entries.iter().enumerate() {
            if pivot_of[place].is_some() {
                continue;
            }
            for (row, entry) in column.iter().enumerate() {
                if !is_used[row] && entry.abs() > best.0 {
                    best = (entry.abs(), row, place);
                }
            }
        }
        let (size, row, place) = best;
        if step == 0 {
            first = size;
        }
        last = size;
        if size <= SMALLEST_PIVOT * first {
            break;
        }
        (pivot_of[place], is_used[row]) = (Some(row), true);
        // rows are cleared above and below the pivot, so that the other columns hold their combinations
        let pivot = entries[place].clone();
        for column in &mut entries {
            let own = column[row] / pivot[row];
            for (other, entry) in column.iter_mut().enumerate() {
                if other == row {
                    *entry = own;
                } else {
                    *entry -= own * pivot[other];
                }
            }
        }
    }
    let null = (0..entries.len()).filter(|column| pivot_of[*column].is_none());
    let null = null.map(|free| {
        let mut combination = vec![0.0; entries.len()];
        combination[free] = 1.0;
        for (column, row) in pivot_of.iter().enumerate() {
            if let Some(row) = row {
                combination[column] = -entries[free][*row];
            }
        }
        for (entry, size) in combination.iter_mut().zip(&sizes) {
            *entry /= if *size > 0.0 { *size } else { 1.0 };
        }
        combination
    });
    Rank {
        null: null.collect(),
        basis: (0..pivot_of.len())
            .filter(|column| pivot_of[*column].is_some())
            .collect(),
        pivot: if first > 0.0 { last / first } else { 0.0 },
    }
}

#[cfg(test)]
mod tests {
    use super::rank;
    use std::vec;

    #[test]
    fn what_is_mapped_to_zero() {
        let columns = [
            vec![2.0, 0.0, 0.0],
            vec![0.0, 1.0, 3.0],
            vec![4.0, 2.0, 6.0],
            vec![0.0, 0.0, 0.0],
        ];
        let found = rank(&columns);
        assert_eq!((found.basis.len(), found.null.len()), (2, 2));
        for combination in found.null {
            for row in 0..3 {
                let sum: f64 = columns
                    .iter()
                    .zip(&combination)
                    .map(|(column, part)| column[row] * part)
                    .sum();
                assert!(sum.abs() < 1e-15);
            }
        }
        assert_eq!(rank(&[]).basis.len(), 0);
        let nearly = rank(&[vec![1.0, 1.0], vec![1.0, 1.0 + 1e-9]]);
        assert!(nearly.basis.len() == 2 && nearly.pivot < 1e-8);
    }
}
