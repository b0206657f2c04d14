//! Linear systems with one equation per unknown of a mechanism, or of one of its blocks.

use num_traits::Float;

use crate::mechanism::Mechanism;
use crate::number::Row;
use crate::solve::{Elimination, eliminate, level, substitute};

/// The sign and the size of a determinant.
#[derive(Clone, Copy)]
pub(crate) struct Orientation {
    /// 1, -1, or 0 for a determinant of exactly zero.
    pub(crate) sign: i8,
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

/// A square matrix in triangular factors.
pub(crate) struct FactoredMatrix<M: Mechanism> {
    rows: M::Unknowns<M::Unknowns<f64>>,
    origins: M::Unknowns<usize>,
    row_exponents: M::Unknowns<i32>,
    column_exponents: M::Unknowns<i32>,
    count: usize,
    odd: bool,
}

impl<M: Mechanism> FactoredMatrix<M> {
    /// The matrix with `count` rows and columns and the entries given by row and column.
    pub(crate) fn new(count: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let mut system = Self {
            rows: M::Unknowns::from_fn(|row| {
                M::Unknowns::from_fn(|column| {
                    if row < count && column < count {
                        entry(row, column)
                    } else {
                        0.0
                    }
                })
            }),
            origins: M::Unknowns::from_fn(|row| row),
            row_exponents: M::Unknowns::splat(0),
            column_exponents: M::Unknowns::splat(0),
            count,
            odd: false,
        };
        let rows = &mut system.rows.as_mut()[..count];
        level(rows, system.row_exponents.as_mut(), system.column_exponents.as_mut());
        let Elimination { odd, .. } = eliminate(rows, &mut system.origins.as_mut()[..count], f64::EPSILON);
        system.odd = odd;
        system
    }

    /// The solution of the system; not finite if the matrix is singular.
    pub(crate) fn solve(&self, right: &M::Unknowns<f64>) -> M::Unknowns<f64> {
        let mut solution = *right;
        substitute(
            &self.rows.as_ref()[..self.count],
            self.origins.as_ref(),
            self.row_exponents.as_ref(),
            self.column_exponents.as_ref(),
            right.as_ref(),
            solution.as_mut(),
        );
        solution
    }

    /// The sign and the size of the determinant.
    pub(crate) fn orientation(&self) -> Orientation {
        let exponents = self.row_exponents.as_ref().iter().chain(self.column_exponents.as_ref());
        let mut orientation = Orientation {
            sign: if self.odd { -1 } else { 1 },
            logarithm: -f64::from(exponents.sum::<i32>()),
        };
        for (step, row) in self.rows.as_ref().iter().enumerate().take(self.count) {
            let pivot = row[step];
            if pivot == 0.0 {
                return Orientation {
                    sign: 0,
                    logarithm: f64::NEG_INFINITY,
                };
            }
            if pivot < 0.0 {
                orientation.sign = -orientation.sign;
            }
            orientation.logarithm += Float::log2(pivot.abs());
        }
        orientation
    }
}
