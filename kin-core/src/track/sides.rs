//! The side of its singular positions on which each block is.

use num_traits::Float;

use super::way::{Linear, Way};
use crate::mechanism::Mechanism;
use crate::mechanism::factored_matrix::{FactoredMatrix, Orientation};
use crate::number::Row;

/// The matrix of all equations for all unknowns.
pub(super) fn whole<M: Mechanism<Scalar = f64>>(linear: &Linear<M>) -> FactoredMatrix<M> {
    FactoredMatrix::new(Way::<M>::COUNT, |row, column| linear.jacobian[row][column])
}

/// The determinants of the Jacobians of the blocks. Their signs give the sides of the singular positions.
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

    /// Whether each determinant has kept its sign, and its size within a factor of two.
    pub(super) fn are_near(&self, other: &Self) -> bool {
        let mut pairs = self.0.as_ref().iter().zip(other.0.as_ref());
        pairs.all(|(one, other)| one.is_near(*other))
    }

    /// Whether a determinant is exactly zero.
    pub(super) fn has_zero(&self) -> bool {
        self.0.as_ref().iter().any(|orientation| orientation.sign == 0)
    }

    /// Whether a determinant has changed its sign or lost half of its size.
    pub(super) fn shrink_from(&self, other: &Self) -> bool {
        let mut pairs = self.0.as_ref().iter().zip(other.0.as_ref());
        pairs.any(|(one, other)| one.shrinks_from(*other))
    }

    /// Whether each determinant has kept its sign.
    pub(super) fn are_same(&self, other: &Self) -> bool {
        let mut pairs = self.0.as_ref().iter().zip(other.0.as_ref());
        pairs.all(|(one, other)| one.sign == other.sign)
    }

    /// The determinant of a block, divided by its earlier value.
    pub(super) fn relative(&self, reference: &Self, block: usize) -> f64 {
        let (now, then) = (self.0[block], reference.0[block]);
        f64::from(now.sign * then.sign) * Float::exp2(now.logarithm - then.logarithm)
    }

    /// The block whose determinant has shrunk most, and the base-2 logarithm of the ratio to its earlier size.
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

/// The closure with one unknown as the parameter and the travel as an unknown instead.
pub(super) fn bordered<M: Mechanism<Scalar = f64>>(linear: &Linear<M>, parameter: usize) -> FactoredMatrix<M> {
    FactoredMatrix::new(Way::<M>::COUNT, |row, column| {
        if column == parameter {
            linear.travel[row]
        } else {
            linear.jacobian[row][column]
        }
    })
}
