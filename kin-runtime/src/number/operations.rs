//! Operation counts.

/// The number of operations of each kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Operations {
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Changes of sign.
    pub negations: usize,
    /// Square roots.
    pub square_roots: usize,
    /// Pairs of a sine and a cosine.
    pub sine_cosines: usize,
    /// Arctangents.
    pub arc_tangents: usize,
    /// Other functions.
    pub others: usize,
}

impl Operations {
    /// No operation at all.
    pub const NONE: Self = Self {
        additions: 0,
        multiplications: 0,
        divisions: 0,
        negations: 0,
        square_roots: 0,
        sine_cosines: 0,
        arc_tangents: 0,
        others: 0,
    };

    /// The counts that generated code states, in the order of the fields.
    #[doc(hidden)]
    #[must_use]
    pub const fn __of(counts: [usize; 8]) -> Self {
        let [
            additions,
            multiplications,
            divisions,
            negations,
            square_roots,
            sine_cosines,
            arc_tangents,
            others,
        ] = counts;
        Self {
            additions,
            multiplications,
            divisions,
            negations,
            square_roots,
            sine_cosines,
            arc_tangents,
            others,
        }
    }

    /// Additions, subtractions, multiplications, divisions and changes of sign together.
    #[must_use]
    pub const fn arithmetic(&self) -> usize {
        self.additions + self.multiplications + self.divisions + self.negations
    }

    /// The sum, kind by kind.
    #[must_use]
    pub const fn plus(self, other: Self) -> Self {
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
