//! The side of its singular positions on which each block is.

use num_traits::Float;

use super::lent_rows::LentRows;
use super::way::{Linear, Way};
use crate::solve::{LentFactors, Orientation, lent_factors_length};

/// The determinants of the Jacobians of the blocks. Their signs give the sides of the singular positions.
#[derive(Clone, Copy)]
pub(crate) struct Sides<'s> {
    signs: &'s [f64],
    /// To base 2.
    logarithms: &'s [f64],
}

impl<'s> Sides<'s> {
    pub(crate) fn of(way: &Way<'_>, linear: &Linear<'_>, scratch: &mut LentRows<'s>) -> Self {
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
    pub(crate) fn read(memory: &'s [f64]) -> Self {
        let (signs, logarithms) = memory.split_at(memory.len() / 2);
        Self { signs, logarithms }
    }

    pub(crate) fn write(&self, memory: &mut [f64]) {
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
    pub(crate) fn are_near(&self, other: &Sides<'_>) -> bool {
        self.each().zip(other.each()).all(|(one, other)| one.is_near(other))
    }

    /// Whether a determinant is exactly zero.
    pub(crate) fn has_zero(&self) -> bool {
        self.signs.contains(&0.0)
    }

    /// Whether a determinant has changed its sign or lost half of its size.
    pub(crate) fn shrink_from(&self, other: &Sides<'_>) -> bool {
        self.each()
            .zip(other.each())
            .any(|(one, other)| one.shrinks_from(other))
    }

    /// Whether each determinant has kept its sign.
    pub(crate) fn are_same(&self, other: &Sides<'_>) -> bool {
        self.signs == other.signs
    }

    /// The determinant of a block, divided by its earlier value.
    pub(crate) fn relative(&self, reference: &Sides<'_>, block: usize) -> f64 {
        let sign = self.signs[block] * reference.signs[block];
        sign * Float::exp2(self.logarithms[block] - reference.logarithms[block])
    }

    /// The block whose determinant has shrunk most, and the base-2 logarithm of the ratio to its earlier size.
    pub(crate) fn most_shrunk(&self, reference: &Sides<'_>) -> (usize, f64) {
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
