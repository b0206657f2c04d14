//! The outcome of solving a system.

use core::error::Error;
use core::fmt;

/// A real solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution<const M: usize> {
    /// The values of the variables.
    pub values: [f64; M],
    /// The number of paths that end here: one at a regular solution, usually more at a singular one.
    pub multiplicity: usize,
    /// The factor by which relative rounding errors in the equations are magnified in the variables, with both in units
    /// in which they are of size one. It is infinite for a singular solution, whose error is about the square root of
    /// the rounding error.
    pub condition: f64,
}

impl<const M: usize> Solution<M> {
    /// Whether the Jacobian is regular at the solution, as far as double precision can decide: no other solution is so
    /// close that rounding could lead from one to the other.
    #[must_use]
    pub const fn is_regular(&self) -> bool {
        self.condition.is_finite()
    }
}

/// The outcome of the paths. Every path is counted once, as `regular`, `singular`, `at_infinity` or `lost`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct PathCounts {
    /// The number of paths, which is at least the number of isolated solutions, real and complex.
    pub paths: usize,
    /// The number of paths that end at regular solutions, real and complex. Each such solution has a separate path, so
    /// this is also the number of regular solutions.
    pub regular: usize,
    /// The number of real regular solutions.
    pub real: usize,
    /// The number of paths that end at singular solutions, real and complex: double and multiple solutions, and
    /// solutions that are not isolated.
    pub singular: usize,
    /// The number of paths that lead to infinity.
    pub at_infinity: usize,
    /// The number of paths that could not be followed to their end, or not with certainty.
    pub lost: usize,
}

impl PathCounts {
    /// Whether all isolated solutions have been found: no path was lost.
    #[must_use]
    pub const fn is_complete(&self) -> bool {
        self.lost == 0
    }
}

/// The reason why continuation cannot solve a system.
#[derive(Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unsuitable {
    /// The table is invalid: it is out of order, refers to equations, variables or coefficients that do not exist, or
    /// has a degree larger than 255.
    Table,
    /// A coefficient is not finite.
    NotFinite {
        /// The index of the coefficient.
        coefficient: usize,
    },
    /// All terms of an equation that contain a variable are zero.
    NoVariable {
        /// The index of the equation.
        equation: usize,
    },
    /// An equation of first degree follows from the others or contradicts them.
    Dependent {
        /// The index of the equation.
        equation: usize,
    },
    /// There are more paths than the caller has room for.
    TooManyPaths {
        /// The number of paths.
        paths: usize,
    },
}

impl fmt::Display for Unsuitable {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Table => {
                formatter.write_str("the table of terms is out of order or refers to items that do not exist")
            }
            Self::NotFinite { coefficient } => write!(formatter, "coefficient {coefficient} is not finite"),
            Self::NoVariable { equation } => write!(formatter, "equation {equation} has no variable"),
            Self::Dependent { equation } => write!(
                formatter,
                "equation {equation}, of first degree, follows from the others or contradicts them"
            ),
            Self::TooManyPaths { paths } => write!(formatter, "there is no room for {paths} paths"),
        }
    }
}

crate::__debug_by_display!(Unsuitable);

impl Error for Unsuitable {}
