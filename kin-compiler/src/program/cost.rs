//! The cost of a program.

use std::ops::Add;

use crate::algebra::WorkUnit;

/// A number of operations, by kind.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Cost {
    pub(crate) additions: usize,
    pub(crate) multiplications: usize,
    pub(crate) divisions: usize,
    pub(crate) negations: usize,
    pub(crate) square_roots: usize,
    pub(crate) sine_cosines: usize,
    pub(crate) arc_tangents: usize,
    pub(crate) others: usize,
}

impl Cost {
    /// No operations.
    pub(crate) const NONE: Self = Self {
        additions: 0,
        multiplications: 0,
        divisions: 0,
        negations: 0,
        square_roots: 0,
        sine_cosines: 0,
        arc_tangents: 0,
        others: 0,
    };
    /// One arctangent.
    pub(crate) const ARC_TANGENT: Self = Self::of(&[WorkUnit::ArcTangent]);
    /// A sine and a cosine of one angle.
    pub(crate) const SINE_COSINE: Self = Self::of(&[WorkUnit::SineCosine]);

    /// All operations except roots, trigonometry and other functions.
    pub(crate) const fn arithmetic(self) -> usize {
        self.additions + self.multiplications + self.divisions + self.negations
    }

    /// The number of operations, with each function counted as twenty.
    pub(crate) const fn total(self) -> usize {
        self.arithmetic() + 20 * (self.square_roots + self.sine_cosines + self.arc_tangents + self.others)
    }

    /// The cost of a list of work.
    pub(crate) const fn of(work: &[WorkUnit]) -> Self {
        let mut cost = Self::NONE;
        let mut rest = work;
        while let [piece, others @ ..] = rest {
            let count = match piece {
                WorkUnit::Multiplication => &mut cost.multiplications,
                WorkUnit::Division => &mut cost.divisions,
                WorkUnit::SquareRoot => &mut cost.square_roots,
                WorkUnit::SineCosine => &mut cost.sine_cosines,
                WorkUnit::ArcTangent => &mut cost.arc_tangents,
                WorkUnit::Other => &mut cost.others,
            };
            *count += 1;
            rest = others;
        }
        cost
    }

    /// The cost of factoring a matrix of `size` rows, see `kin_core::solve::factor`.
    pub(crate) const fn of_factors(size: usize) -> Self {
        let mut products = 0;
        let mut rows = 1;
        while rows < size {
            products += rows * rows;
            rows += 1;
        }
        // rows and columns are scaled by powers of two
        let levelling = 2 * size * size;
        Self {
            additions: products,
            multiplications: products + levelling,
            divisions: size * (size - 1) / 2,
            ..Self::NONE
        }
    }

    /// The cost of a solution with the factors of a matrix of `size` rows, see `kin_core::solve::Factors::solve`.
    pub(crate) const fn of_substitution(size: usize) -> Self {
        Self {
            additions: size * (size - 1),
            multiplications: size * (size + 1),
            divisions: size,
            ..Self::NONE
        }
    }
}

impl Add for Cost {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            additions: self.additions + other.additions,
            multiplications: self.multiplications + other.multiplications,
            divisions: self.divisions + other.divisions,
            negations: self.negations + other.negations,
            square_roots: self.square_roots + other.square_roots,
            sine_cosines: self.sine_cosines + other.sine_cosines,
            arc_tangents: self.arc_tangents + other.arc_tangents,
            others: self.others + other.others,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ONE: Cost = Cost {
        additions: 1,
        multiplications: 20,
        divisions: 300,
        negations: 4000,
        square_roots: 5,
        sine_cosines: 60,
        arc_tangents: 700,
        others: 8000,
    };

    /// Costs are added kind by kind.
    #[test]
    fn costs_add_up_by_kind() {
        let double = Cost {
            additions: 2,
            multiplications: 40,
            divisions: 600,
            negations: 8000,
            square_roots: 10,
            sine_cosines: 120,
            arc_tangents: 1400,
            others: 16000,
        };
        assert_eq!(ONE + ONE, double);
        assert_eq!(ONE + Cost::default(), ONE);
        assert_eq!(ONE.arithmetic(), 4321);
        // a function is worth twenty operations
        assert_eq!(ONE.total(), 4321 + 20 * 8765);
    }

    /// Each piece of work is counted under its kind, as often as it occurs.
    #[test]
    fn work_is_counted_by_kind() {
        use WorkUnit::{ArcTangent, Division, Multiplication, Other, SineCosine, SquareRoot};
        let work = [
            Division,
            Other,
            Division,
            Multiplication,
            SquareRoot,
            SineCosine,
            ArcTangent,
            Other,
            Other,
        ];
        let expected = Cost {
            multiplications: 1,
            divisions: 2,
            square_roots: 1,
            sine_cosines: 1,
            arc_tangents: 1,
            others: 3,
            ..Cost::NONE
        };
        assert_eq!(Cost::of(&work), expected);
        assert_eq!(Cost::of(&[]), Cost::NONE);
    }

    /// Gaussian elimination of three rows takes one division for each of the three entries below the diagonal. Each of
    /// these entries also takes a product and a difference for each entry left in its row: 2 · 2 and 1. A solution
    /// takes a product and a difference for each of the six entries beside the diagonal, a division for each row, and
    /// the scaling of rows and columns.
    #[test]
    fn factors_cost_what_elimination_takes() {
        let factors = Cost::of_factors(3);
        assert_eq!(
            (factors.additions, factors.multiplications, factors.divisions),
            (5, 5 + 2 * 9, 3)
        );
        let substitution = Cost::of_substitution(3);
        assert_eq!(
            (
                substitution.additions,
                substitution.multiplications,
                substitution.divisions
            ),
            (6, 6 + 2 * 3, 3)
        );
    }
}
