//! What comes of solving a system.

use core::error::Error;
use core::fmt;

/// A real solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution<const M: usize> {
    /// The variables.
    pub values: [f64; M],
    /// The number of paths that end here: one at a regular solution, in general more at a singular one.
    pub multiplicity: usize,
    /// By how much relative roundings in the equations are enlarged in the variables, both in units in which they are
    /// of size one. Infinite for a singular solution, which is exact to about the square root of the rounding error
    /// only.
    pub condition: f64,
}

impl<const M: usize> Solution<M> {
    /// Whether the Jacobian is regular at the solution, as far as double precision can tell: no other solution is so
    /// near that rounding could lead from one to the other.
    #[must_use]
    pub const fn is_regular(&self) -> bool {
        self.condition.is_finite()
    }
}

/// What became of the paths. Every path is counted once, as `regular`, `singular`, `at_infinity` or `lost`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct PathCounts {
    /// How many paths there are: at least as many as isolated solutions, real and complex.
    pub paths: usize,
    /// How many end at regular solutions, real and complex. Each has its own path, so that this is also the number of
    /// these solutions.
    pub regular: usize,
    /// How many regular solutions are real.
    pub real: usize,
    /// How many end at singular solutions, real and complex: double and multiple ones, and such that are not isolated.
    pub singular: usize,
    /// How many lead to infinity.
    pub at_infinity: usize,
    /// How many could not be followed to their end, or not without doubt.
    pub lost: usize,
}

impl PathCounts {
    /// Whether all isolated solutions have been found: no path was lost.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.lost == 0
    }
}

/// Why the solutions of a system cannot be found in this way.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unsuitable {
    /// The table is out of order, refers to equations, variables or coefficients that do not exist, or a degree is
    /// larger than 255.
    Table,
    /// A coefficient is not finite.
    NotFinite {
        /// Its place.
        coefficient: usize,
    },
    /// All terms of an equation that have a variable are zero.
    NoVariable {
        /// Which equation.
        equation: usize,
    },
    /// An equation of the first degree follows from others or contradicts them.
    Dependent {
        /// Which equation.
        equation: usize,
    },
    /// There are more paths than there is room for.
    TooManyPaths {
        /// How many.
        paths: usize,
    },
}

impl fmt::Display for Unsuitable {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Table => formatter.write_str("the table of terms is out of order or refers to what is not there"),
            Self::NotFinite { coefficient } => write!(formatter, "coefficient {coefficient} is not finite"),
            Self::NoVariable { equation } => write!(formatter, "equation {equation} has no variable"),
            Self::Dependent { equation } => write!(
                formatter,
                "equation {equation}, of the first degree, follows from others or contradicts them"
            ),
            Self::TooManyPaths { paths } => write!(formatter, "there is no room for {paths} paths"),
        }
    }
}

impl Error for Unsuitable {}
