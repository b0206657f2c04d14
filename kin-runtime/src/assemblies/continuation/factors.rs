//! Systems of complex linear equations, solved by Gaussian elimination with partial pivoting.

use super::complex::Complex;

/// The triangular factors of the leading square part of a matrix.
///
/// There is room for `M` rows. The number of rows in use is the number of unknowns.
#[derive(Clone, Debug)]
pub(super) struct ComplexFactors<const M: usize> {
    /// The matrix before factorisation; afterwards the factors, with the inverses of the pivots on the diagonal.
    pub(super) rows: [[Complex; M]; M],
    /// The row exchanged with each row.
    exchanged: [usize; M],
}

impl<const M: usize> ComplexFactors<M> {
    pub(super) const fn new() -> Self {
        Self {
            rows: [[Complex::ZERO; M]; M],
            exchanged: [0; M],
        }
    }

    /// Factorises the leading `n` rows and columns; returns false if a pivot is zero or NaN.
    pub(super) fn factorise(&mut self, n: usize) -> bool {
        for column in 0..n {
            let mut pivot = column;
            let mut size = self.rows[column][column].norm_squared();
            for row in column + 1..n {
                let candidate = self.rows[row][column].norm_squared();
                if candidate > size {
                    (pivot, size) = (row, candidate);
                }
            }
            if size.is_nan() || size == 0.0 {
                return false;
            }
            self.rows.swap(column, pivot);
            self.exchanged[column] = pivot;
            let inverse = self.rows[column][column].inverse();
            self.rows[column][column] = inverse;
            let (above, below) = self.rows.split_at_mut(column + 1);
            let above = &above[column][..n];
            for row in &mut below[..n - column - 1] {
                let row = &mut row[..n];
                let factor = row[column] * inverse;
                row[column] = factor;
                for (entry, from) in row.iter_mut().zip(above).skip(column + 1) {
                    *entry = *entry - factor * *from;
                }
            }
        }
        true
    }

    /// Replaces the right-hand side by the solution.
    pub(super) fn solve(&self, n: usize, right: &mut [Complex; M]) {
        for row in 0..n {
            right.swap(row, self.exchanged[row]);
            let mut sum = right[row];
            for (factor, known) in self.rows[row][..row].iter().zip(&right[..row]) {
                sum = sum - *factor * *known;
            }
            right[row] = sum;
        }
        for row in (0..n).rev() {
            let mut sum = right[row];
            for (factor, known) in self.rows[row][..n].iter().zip(&right[..n]).skip(row + 1) {
                sum = sum - *factor * *known;
            }
            right[row] = sum * self.rows[row][row];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::complex::Complex;
    use super::ComplexFactors;

    #[test]
    fn solves_with_exchanged_rows_and_leaves_the_rest_alone() {
        let mut factors = ComplexFactors::<4>::new();
        let z = Complex::new;
        let matrix = [
            [z(0.0, 0.0), z(1.0, 1.0), z(2.0, 0.0)],
            [z(1.0, 0.0), z(0.0, -1.0), z(0.0, 3.0)],
            [z(4.0, 0.0), z(0.5, 0.0), z(1.0, 0.0)],
        ];
        let solution = [z(1.0, -1.0), z(0.0, 2.0), z(-3.0, 0.5)];
        let mut right = [Complex::real(7.0); 4];
        for row in 0..3 {
            factors.rows[row][..3].copy_from_slice(&matrix[row]);
            right[row] = (0..3).fold(Complex::ZERO, |sum, k| sum + matrix[row][k] * solution[k]);
        }
        assert!(factors.factorise(3));
        factors.solve(3, &mut right);
        for (found, expected) in right.iter().zip(&solution) {
            assert!((*found - *expected).norm() < 1e-14);
        }
        assert_eq!(right[3], Complex::real(7.0));
    }

    #[test]
    fn a_singular_matrix_has_no_factors() {
        let mut factors = ComplexFactors::<2>::new();
        factors.rows = [[Complex::ONE; 2]; 2];
        assert!(!factors.factorise(2));
        factors.rows = [[Complex::real(f64::NAN); 2]; 2];
        assert!(!factors.factorise(2));
    }
}
