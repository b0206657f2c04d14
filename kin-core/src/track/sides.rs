//! The side of its singular positions on which each block is.

use num_traits::Float;

use super::lent_rows::LentRows;
use super::way::{Linear, Way};
use crate::solve::{LentFactors, Orientation, lent_factors_length};

/// The matrix of all equations for all unknowns.
pub(super) fn whole<'s>(linear: &Linear<'_>, scratch: &mut LentRows<'s>) -> LentFactors<'s> {
    let count = linear.travel.len();
    let memory = scratch.lend(lent_factors_length(count));
    LentFactors::new(memory, count, |row, column| linear.entry(row, column))
}

/// The determinants of the Jacobians of the blocks. Their signs give the sides of the singular positions.
#[derive(Clone, Copy)]
pub(super) struct Sides<'s> {
    signs: &'s [f64],
    /// To base 2.
    logarithms: &'s [f64],
}

impl<'s> Sides<'s> {
    pub(super) fn of(way: &Way<'_>, linear: &Linear<'_>, scratch: &mut LentRows<'s>) -> Self {
        let memory = scratch.lend(2 * way.description.blocks.len());
        let (signs, logarithms) = memory.split_at_mut(way.description.blocks.len());
        for (index, block) in way.description.blocks.iter().enumerate() {
            let count = block.members.len();
            let mut scope = scratch.scope();
            let memory = scope.lend(lent_factors_length(count));
            let factors = LentFactors::new(memory, count, |row, column| {
                linear.entry(block.equations[row], block.members[column])
            });
            let orientation = factors.orientation();
            (signs[index], logarithms[index]) = (orientation.sign, orientation.logarithm);
        }
        Self { signs, logarithms }
    }

    /// The numbers of [`written`](Self::written), read again.
    pub(super) fn read(memory: &'s [f64]) -> Self {
        let (signs, logarithms) = memory.split_at(memory.len() / 2);
        Self { signs, logarithms }
    }

    pub(super) fn write(&self, memory: &mut [f64]) {
        let (signs, logarithms) = memory.split_at_mut(self.signs.len());
        signs.copy_from_slice(self.signs);
        logarithms.copy_from_slice(self.logarithms);
    }

    fn each(&self) -> impl Iterator<Item = Orientation> {
        let pairs = self.signs.iter().zip(self.logarithms);
        pairs.map(|(sign, logarithm)| Orientation {
            sign: *sign,
            logarithm: *logarithm,
        })
    }

    /// Whether each determinant has kept its sign, and its size within a factor of two.
    pub(super) fn are_near(&self, other: &Sides<'_>) -> bool {
        self.each().zip(other.each()).all(|(one, other)| one.is_near(other))
    }

    /// Whether a determinant is exactly zero.
    pub(super) fn has_zero(&self) -> bool {
        self.signs.contains(&0.0)
    }

    /// Whether a determinant has changed its sign or lost half of its size.
    pub(super) fn shrink_from(&self, other: &Sides<'_>) -> bool {
        self.each()
            .zip(other.each())
            .any(|(one, other)| one.shrinks_from(other))
    }

    /// Whether each determinant has kept its sign.
    pub(super) fn are_same(&self, other: &Sides<'_>) -> bool {
        self.signs == other.signs
    }

    /// The determinant of a block, divided by its earlier value.
    pub(super) fn relative(&self, reference: &Sides<'_>, block: usize) -> f64 {
        let sign = self.signs[block] * reference.signs[block];
        sign * Float::exp2(self.logarithms[block] - reference.logarithms[block])
    }

    /// The block whose determinant has shrunk most, and the base-2 logarithm of the ratio to its earlier size.
    pub(super) fn most_shrunk(&self, reference: &Sides<'_>) -> (usize, f64) {
        let pairs = self.logarithms.iter().zip(reference.logarithms);
        let changes = pairs.map(|(now, then)| now - then);
        changes.enumerate().fold(
            (0, f64::INFINITY),
            |best, candidate| {
                if candidate.1 < best.1 { candidate } else { best }
            },
        )
    }
}

/// The closure with one unknown as the parameter and the travel as an unknown instead.
pub(super) fn bordered<'s>(linear: &Linear<'_>, parameter: usize, scratch: &mut LentRows<'s>) -> LentFactors<'s> {
    let count = linear.travel.len();
    let memory = scratch.lend(lent_factors_length(count));
    LentFactors::new(memory, count, |row, column| {
        if column == parameter {
            linear.travel[row]
        } else {
            linear.entry(row, column)
        }
    })
}
