//! Linear systems of as many equations as a mechanism, or one of its blocks, has unknowns.

use num_traits::Float;

use super::way::{Linear, Way};
use crate::mechanism::Mechanism;
use crate::number::Row;
use crate::solve::{Elimination, eliminate, level, substitute};

/// The sign and the size of a determinant.
#[derive(Clone, Copy)]
pub(super) struct Orientation {
    /// 1, -1, or 0 for a determinant of exactly zero.
    pub(super) sign: i8,
    /// The logarithm of the magnitude to base 2, so that no product overflows.
    pub(super) logarithm: f64,
}

impl Orientation {
    /// Whether the determinant has the sign of another, and between half and twice its size.
    pub(super) fn is_near(self, other: Self) -> bool {
        self.sign == other.sign && (self.logarithm - other.logarithm).abs() <= 1.0
    }

    /// Whether the determinant has lost the sign of another, or half of its size.
    pub(super) fn shrinks_from(self, other: Self) -> bool {
        self.sign != other.sign || self.logarithm < other.logarithm - 1.0
    }
}

/// A square matrix in triangular factors.
pub(super) struct FactoredMatrix<M: Mechanism> {
    rows: M::Unknowns<M::Unknowns<f64>>,
    origins: M::Unknowns<usize>,
    row_exponents: M::Unknowns<i32>,
    column_exponents: M::Unknowns<i32>,
    count: usize,
    odd: bool,
}

impl<M: Mechanism<Scalar = f64>> FactoredMatrix<M> {
    /// The matrix of `count` rows and columns with the entries given by row and column.
    pub(super) fn new(count: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
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
            row_exponents: M::Unknowns::from_fn(|_| 0),
            column_exponents: M::Unknowns::from_fn(|_| 0),
            count,
            odd: false,
        };
        let rows = &mut system.rows.as_mut()[..count];
        level(rows, system.row_exponents.as_mut(), system.column_exponents.as_mut());
        let Elimination { odd, .. } = eliminate(rows, &mut system.origins.as_mut()[..count], f64::EPSILON);
        system.odd = odd;
        system
    }

    /// All equations for all unknowns.
    pub(super) fn whole(linear: &Linear<M>) -> Self {
        Self::new(Way::<M>::COUNT, |row, column| linear.jacobian[row][column])
    }

    /// The solution of as many equations as the mechanism has; not finite if the matrix is singular.
    pub(super) fn solve(&self, right: &M::Unknowns<f64>) -> M::Unknowns<f64> {
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

    pub(super) fn orientation(&self) -> Orientation {
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

/// The determinant of each block's Jacobian: on which side of its singular positions it is.
#[derive(Clone, Copy)]
pub(super) struct Sides<M: Mechanism>(M::Unknowns<Orientation>);

impl<M: Mechanism<Scalar = f64>> Sides<M> {
    pub(super) fn of(linear: &Linear<M>) -> Self {
        let none = Orientation {
            sign: 1,
            logarithm: 0.0,
        };
        Self(M::Unknowns::from_fn(|block| {
            M::DESCRIPTION.blocks.get(block).map_or(none, |block| {
                let jacobian = linear.jacobian.as_ref();
                FactoredMatrix::<M>::new(block.members.len(), |row, column| {
                    jacobian[block.equations[row]][block.members[column]]
                })
                .orientation()
            })
        }))
    }

    /// Whether each determinant has kept its sign, and its size to a factor of two.
    pub(super) fn are_near(&self, other: &Self) -> bool {
        let mut pairs = self.0.as_ref().iter().zip(other.0.as_ref());
        pairs.all(|(one, other)| one.is_near(*other))
    }

    /// Whether a determinant is exactly zero.
    pub(super) fn has_zero(&self) -> bool {
        self.0.as_ref().iter().any(|orientation| orientation.sign == 0)
    }

    /// Whether a determinant has lost its sign, or half of its size.
    pub(super) fn shrink_from(&self, other: &Self) -> bool {
        let mut pairs = self.0.as_ref().iter().zip(other.0.as_ref());
        pairs.any(|(one, other)| one.shrinks_from(*other))
    }

    /// Whether each determinant has kept its sign.
    pub(super) fn are_same(&self, other: &Self) -> bool {
        let mut pairs = self.0.as_ref().iter().zip(other.0.as_ref());
        pairs.all(|(one, other)| one.sign == other.sign)
    }

    /// The determinant of a block as a multiple of what it was.
    pub(super) fn relative(&self, reference: &Self, block: usize) -> f64 {
        let (now, then) = (self.0[block], reference.0[block]);
        f64::from(now.sign * then.sign) * Float::exp2(now.logarithm - then.logarithm)
    }

    /// The block whose determinant has shrunk most, and the logarithm of its size to base 2, relative to what it was.
    pub(super) fn most_shrunk(&self, reference: &Self) -> (usize, f64) {
        let pairs = self.0.as_ref().iter().zip(reference.0.as_ref());
        let changes = pairs.map(|(now, then)| now.logarithm - then.logarithm);
        changes
            .enumerate()
            .take(M::DESCRIPTION.blocks.len())
            .fold(
                (0, f64::INFINITY),
                |best, candidate| {
                    if candidate.1 < best.1 { candidate } else { best }
                },
            )
    }
}

/// The closure with the travel in the place of one unknown, which becomes the parameter.
pub(super) fn bordered<M: Mechanism<Scalar = f64>>(linear: &Linear<M>, parameter: usize) -> FactoredMatrix<M> {
    FactoredMatrix::new(Way::<M>::COUNT, |row, column| {
        if column == parameter {
            linear.travel[row]
        } else {
            linear.jacobian[row][column]
        }
    })
}
