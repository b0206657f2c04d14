//! The triangular factors of a matrix whose size is known when the program runs, in memory that the caller lends.

use num_traits::Float;

use super::factor::{exponent_of, largest_of, levelling};

/// The numbers that the factors of a matrix of this size take.
pub(crate) const fn lent_factors_length(count: usize) -> usize {
    count * count + 3 * count + 1
}

/// The sign and the size of a determinant.
#[derive(Clone, Copy)]
pub(crate) struct Orientation {
    /// 1, -1, or 0 for a determinant of exactly zero.
    pub(crate) sign: f64,
    /// The logarithm of the magnitude to base 2, so that no product overflows.
    pub(crate) logarithm: f64,
}

impl Orientation {
    /// Whether the determinant has the sign of another, and between half and twice its magnitude.
    pub(crate) fn is_near(self, other: Self) -> bool {
        self.sign == other.sign && (self.logarithm - other.logarithm).abs() <= 1.0
    }

    /// Whether the determinant differs from another in sign, or has less than half of its magnitude.
    pub(crate) fn shrinks_from(self, other: Self) -> bool {
        self.sign != other.sign || self.logarithm < other.logarithm - 1.0
    }
}

/// A square matrix in triangular factors: the method of [`factor`](super::factor), which has the size in its type.
#[derive(Clone, Copy)]
pub(crate) struct LentFactors<'s> {
    /// Row by row: multipliers below the diagonal, pivots on the diagonal, the remaining entries to the right.
    entries: &'s [f64],
    /// The powers of two by which the rows of the matrix were multiplied, as they stand now.
    row_scales: &'s [f64],
    /// The powers of two by which the columns were multiplied.
    column_scales: &'s [f64],
    /// The row of the matrix from which each row came.
    origins: &'s [f64],
    /// 1, or -1 if an odd number of pairs of rows was exchanged.
    sign: f64,
}

impl<'s> LentFactors<'s> {
    /// The factors of the matrix with these entries, given by row and column, in memory of the length
    /// [`lent_factors_length`].
    pub(crate) fn new(memory: &'s mut [f64], count: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        for (index, value) in memory[..count * count].iter_mut().enumerate() {
            *value = entry(index / count, index % count);
        }
        Self::of_entries(memory, count)
    }

    /// The factors of the matrix whose entries stand first in such memory, row after row.
    pub(crate) fn of_entries(memory: &'s mut [f64], count: usize) -> Self {
        let (entries, scales) = memory.split_at_mut(count * count);
        let (row_scales, scales) = scales.split_at_mut(count);
        let (column_scales, origins) = scales.split_at_mut(count);
        let (origins, sign) = origins.split_at_mut(count);
        level(entries, row_scales, column_scales);
        let mut number = 0.0;
        for origin in origins.iter_mut() {
            *origin = number;
            number += 1.0;
        }
        sign[0] = eliminate(entries, row_scales, origins);
        Self::read(memory, count)
    }

    /// The factors that memory holds.
    pub(crate) fn read(memory: &'s [f64], count: usize) -> Self {
        let (entries, scales) = memory.split_at(count * count);
        let (row_scales, scales) = scales.split_at(count);
        let (column_scales, origins) = scales.split_at(count);
        let (origins, sign) = origins.split_at(count);
        Self {
            entries,
            row_scales,
            column_scales,
            origins,
            sign: sign[0],
        }
    }

    /// Writes the solution for a right-hand side, which is not finite if the matrix is singular.
    pub(crate) fn solve(&self, right: &[f64], solution: &mut [f64]) {
        let count = self.origins.len();
        let rows = || self.entries.chunks_exact(count.max(1)).enumerate();
        for (row, entries) in rows() {
            let mut sum = right[index(self.origins[row])] * self.row_scales[row];
            for (factor, known) in entries[..row].iter().zip(&*solution) {
                sum -= factor * known;
            }
            solution[row] = sum;
        }
        for (row, entries) in rows().rev() {
            let mut sum = solution[row];
            for (factor, known) in entries[row + 1..].iter().zip(&solution[row + 1..]) {
                sum -= factor * known;
            }
            solution[row] = sum / entries[row];
        }
        for (entry, scale) in solution.iter_mut().zip(self.column_scales) {
            *entry *= scale;
        }
    }

    /// The sign and the size of the determinant.
    pub(crate) fn orientation(&self) -> Orientation {
        let scales = self.row_scales.iter().chain(self.column_scales);
        let mut orientation = Orientation {
            sign: self.sign,
            // exact, as scales are powers of two
            logarithm: -scales.map(|scale| f64::from(exponent_of(*scale))).sum::<f64>(),
        };
        for step in 0..self.origins.len() {
            let pivot = self.entries[step * self.origins.len() + step];
            if pivot == 0.0 {
                return Orientation {
                    sign: 0.0,
                    logarithm: f64::NEG_INFINITY,
                };
            }
            orientation.sign *= pivot.signum();
            orientation.logarithm += Float::log2(pivot.abs());
        }
        orientation
    }
}

#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "the number of a row, which was counted"
)]
const fn index(origin: f64) -> usize {
    origin as usize
}

fn level(entries: &mut [f64], row_scales: &mut [f64], column_scales: &mut [f64]) {
    let count = row_scales.len();
    for (row, scale) in entries.chunks_exact_mut(count.max(1)).zip(row_scales) {
        *scale = levelling::<f64>(largest_of(row.iter()));
        for entry in row {
            *entry *= *scale;
        }
    }
    for (column, scale) in column_scales.iter_mut().enumerate() {
        *scale = levelling::<f64>(largest_of(entries.iter().skip(column).step_by(count)));
        for entry in entries.iter_mut().skip(column).step_by(count) {
            *entry *= *scale;
        }
    }
}

/// Transforms a levelled matrix into its triangular factors. The elimination stops at a pivot that is exactly zero. It
/// returns 1, or -1 if an odd number of pairs of rows was exchanged.
fn eliminate(entries: &mut [f64], row_scales: &mut [f64], origins: &mut [f64]) -> f64 {
    let count = origins.len();
    let mut sign = 1.0;
    for step in 0..count {
        let (mut best, mut largest) = (step, entries[step * count + step].abs());
        for row in step + 1..count {
            let size = entries[row * count + step].abs();
            if size > largest {
                (best, largest) = (row, size);
            }
        }
        if best != step {
            let (above, below) = entries.split_at_mut(best * count);
            above[step * count..(step + 1) * count].swap_with_slice(&mut below[..count]);
            row_scales.swap(best, step);
            origins.swap(best, step);
            sign = -sign;
        }
        let (above, below) = entries.split_at_mut((step + 1) * count);
        let top = &above[step * count..];
        let pivot = top[step];
        if pivot == 0.0 {
            break;
        }
        for row in below.chunks_exact_mut(count) {
            let multiplier = row[step] / pivot;
            row[step] = multiplier;
            for (entry, upper) in row.iter_mut().zip(top).skip(step + 1) {
                *entry -= multiplier * upper;
            }
        }
    }
    sign
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sign and logarithm agree with the determinant, and solving a system restores its right-hand side.
    #[test]
    fn orientations_are_those_of_determinants() {
        let mut memory = [0.0; lent_factors_length(2)];
        for matrix in [
            [[2.0, 0.0], [0.0, 8.0]],
            [[0.0, 2.0], [8.0, 0.0]],
            [[-3.0, 1.0], [1.0, 1.0]],
            [[1.0, 5.0], [2.0, -1.0]],
            [[-1e-9, 2e-9], [-3e6, -1e6]],
        ] {
            let system = LentFactors::new(&mut memory, 2, |row, column| matrix[row][column]);
            let determinant: f64 = matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0];
            let orientation = system.orientation();
            assert_eq!(orientation.sign, determinant.signum(), "{matrix:?}");
            assert!(
                (orientation.logarithm - determinant.abs().log2()).abs() < 1e-12,
                "{matrix:?}"
            );
            let mut solution = [0.0; 2];
            system.solve(&[1.0, -2.0], &mut solution);
            let [x, y] = solution;
            for (row, right) in matrix.into_iter().zip([1.0, -2.0]) {
                let size = (row[0] * x).abs() + (row[1] * y).abs() + 1.0;
                assert!(
                    (row[0] * x + row[1] * y - right).abs() <= 16.0 * f64::EPSILON * size,
                    "{matrix:?}"
                );
            }
        }
        let singular = LentFactors::new(&mut memory, 2, |_, _| 1.0).orientation();
        assert_eq!((singular.sign, singular.logarithm), (0.0, f64::NEG_INFINITY));
    }

    /// The factors of a matrix with its size in its type are the same numbers.
    #[test]
    fn the_solution_is_that_of_factors_of_a_known_size() {
        for seed in 0..100 {
            let mixed = |row: usize, column: usize| {
                let number = f64::from(u32::try_from(row * 7 + column * 3).unwrap() + 11 * seed);
                (number * 1.618).sin() * 10_f64.powf((number * 0.77).cos() * 4.0)
            };
            let matrix: [[f64; 4]; 4] = core::array::from_fn(|row| core::array::from_fn(|column| mixed(row, column)));
            let right = core::array::from_fn(|row| mixed(row, 9));
            let mut memory = [0.0; lent_factors_length(4)];
            let lent = LentFactors::new(&mut memory, 4, mixed);
            let mut solution = [0.0; 4];
            lent.solve(&right, &mut solution);
            assert_eq!(solution, crate::solve::factor(matrix).unwrap().solve(right));
        }
    }
}
