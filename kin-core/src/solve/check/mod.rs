//! What a solver decides on the way: named checks with their operands.
//!
//! A number decides about a check by [`Scalar`](crate::Scalar): a plain number by its real part, several poses at once each for
//! itself. The check knows what it is called, what it compares, and how far it is from another outcome.

mod domain;
mod finite;
mod pivot;
mod regular;
mod sides;
mod sign;
mod size;
mod span;
mod told;
mod turns;

#[cfg(test)]
mod tests;

pub(super) use domain::{Domain, Ends};
pub(super) use finite::Finite;
pub(super) use pivot::Multiplier;
pub(super) use regular::Regular;
pub(super) use sides::SameSides;
pub use sign::Negative;
pub(super) use sign::{NotNegative, Zero};
pub(super) use size::{LargestLength, LargestSize, SumOfSizes};
pub(super) use span::{AngleInRange, SolutionInRange, Span, ValueInRange, out_of_range};
pub(super) use told::Told;
pub(super) use turns::{NearestTurns, TellsDirection, TurnsInto};

use crate::assembly::Assembly;
use crate::failure::Failure;

/// A condition on numbers, on which the way to a solution depends: `K` conditions on `N` operands, all of which must hold.
pub trait Check<T, const N: usize, const K: usize>: Copy {
    /// What is checked, in a few words.
    fn name(&self) -> &'static str;

    /// The numbers that are compared.
    fn operands(&self) -> [T; N];

    /// Whether the conditions hold for one pose, of which these are the operands. None of them holds by NaN.
    fn holds(&self, operands: [f64; N]) -> [bool; K];

    /// How far the check is from failing, in the unit of what is compared: negative where it fails for want of it.
    ///
    /// It is calculated in the number type, so that several poses have a margin each. A solver does not ask for it.
    fn margin(&self) -> T;
}

/// A choice between two solutions.
pub trait Choose<T, const N: usize>: Copy {
    /// What is chosen by, in a few words.
    fn name(&self) -> &'static str;

    /// The numbers that are compared.
    fn operands(&self) -> [T; N];

    /// The solution for one pose, of which these are the operands: open for the first, crossed for the second.
    ///
    /// # Errors
    /// If neither can be taken, or both.
    fn choose(&self, operands: [f64; N]) -> Result<Assembly, Failure>;

    /// How far the choice is from another outcome, in the unit of the solutions.
    fn margin(&self) -> T;
}

/// A constant that depends on the real parts of numbers, as a count of whole turns does.
pub trait Measure<T, const N: usize>: Copy {
    /// What is measured, in a few words.
    fn name(&self) -> &'static str;

    /// The numbers that it depends on.
    fn operands(&self) -> [T; N];

    /// The constant for one pose, of which these are the operands.
    fn measure(&self, operands: [f64; N]) -> f64;
}
