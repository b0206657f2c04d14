//! What a program costs.

use std::ops::Add;

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
    /// No operation at all.
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
    pub(crate) const ARC_TANGENT: Self = Self {
        arc_tangents: 1,
        ..Self::NONE
    };
    /// A sine and a cosine of one angle.
    pub(crate) const SINE_COSINE: Self = Self {
        sine_cosines: 1,
        ..Self::NONE
    };

    /// Everything but roots, trigonometry and other functions.
    pub(crate) const fn arithmetic(self) -> usize {
        self.additions + self.multiplications + self.divisions + self.negations
    }

    /// The number of operations, where a function counts as twenty.
    pub(crate) const fn total(self) -> usize {
        self.arithmetic() + 20 * (self.square_roots + self.sine_cosines + self.arc_tangents + self.others)
    }

    /// The cost of factoring a matrix of so many rows, see `kin_core::solve::factor`.
    pub(crate) const fn of_factors(size: usize) -> Self {
        let mut products = 0;
        let mut rows = 1;
        while rows < size {
            products += rows * rows;
            rows += 1;
        }
        // rows and columns are levelled by powers of two
        let levelling = 2 * size * size;
        Self {
            additions: products,
            multiplications: products + levelling,
            divisions: size * (size - 1) / 2,
            ..Self::NONE
        }
    }

    /// The cost of solving by the factors of a matrix of so many rows, see `kin_core::solve::Factors::solve`.
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
