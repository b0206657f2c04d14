//! The numbers on which checks decide.

use core::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::Float;

use crate::number::single;

/// A real number on which a check decides: `f64` or `f32`, or a number that records what is compared.
///
/// A check states its conditions with these methods. So one text serves the solvers, which ask whether a condition
/// holds, and a record of the solver, which writes the condition down.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The answer to a comparison: `bool`, or a record of it.
    type Truth: Copy;

    /// A number that is known beforehand.
    #[must_use]
    fn of(value: f64) -> Self;

    /// The magnitude.
    #[must_use]
    fn magnitude(self) -> Self;

    /// The nearest integer; a half is rounded away from zero.
    #[must_use]
    fn rounded(self) -> Self;

    /// The smallest integer that is not less.
    #[must_use]
    fn raised(self) -> Self;

    /// Whether the number is greater than or equal to another. NaN never is.
    #[must_use]
    fn is_at_least(self, other: Self) -> Self::Truth;

    /// Whether the number is greater than another. NaN never is.
    #[must_use]
    fn exceeds(self, other: Self) -> Self::Truth;

    /// Whether the number is less than or equal to another. NaN never is.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_at_most(self, other: Self) -> Self::Truth {
        other.is_at_least(self)
    }

    /// Whether the number is less than another. NaN never is.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_below(self, other: Self) -> Self::Truth {
        other.exceeds(self)
    }

    /// Whether the number equals another. NaN never does.
    #[must_use]
    fn equals(self, other: Self) -> Self::Truth;

    /// Whether the number is neither NaN nor infinite.
    #[must_use]
    fn is_finite(self) -> Self::Truth;

    /// The answer to a question that needs no number.
    #[must_use]
    fn certainly(answer: bool) -> Self::Truth;

    /// Whether both hold. A plain number asks for the second only if the first holds.
    #[must_use]
    fn both(one: Self::Truth, other: impl FnOnce() -> Self::Truth) -> Self::Truth;

    /// Whether one of them holds, or both. A plain number asks for the second only if the first does not hold.
    #[must_use]
    fn either(one: Self::Truth, other: impl FnOnce() -> Self::Truth) -> Self::Truth;

    /// Whether it does not hold.
    #[must_use]
    fn not(truth: Self::Truth) -> Self::Truth;

    /// One number if it holds, otherwise the other. A plain number computes only the one that it takes.
    #[must_use]
    fn choose(truth: Self::Truth, one: impl FnOnce() -> Self, other: impl FnOnce() -> Self) -> Self;
}

macro_rules! real {
    ($float:ty, $from_f64:expr) => {
        impl Real for $float {
            type Truth = bool;

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn of(value: f64) -> Self {
                $from_f64(value)
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn magnitude(self) -> Self {
                self.abs()
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn rounded(self) -> Self {
                Float::round(self)
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn raised(self) -> Self {
                Float::ceil(self)
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn is_at_least(self, other: Self) -> bool {
                self >= other
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn exceeds(self, other: Self) -> bool {
                self > other
            }

            // The order of the operands decides which of them the machine has to copy.
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn is_at_most(self, other: Self) -> bool {
                self <= other
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn is_below(self, other: Self) -> bool {
                self < other
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn equals(self, other: Self) -> bool {
                self == other
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn is_finite(self) -> bool {
                <$float>::is_finite(self)
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn certainly(answer: bool) -> bool {
                answer
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn both(one: bool, other: impl FnOnce() -> bool) -> bool {
                one && other()
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn either(one: bool, other: impl FnOnce() -> bool) -> bool {
                one || other()
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn not(truth: bool) -> bool {
                !truth
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn choose(truth: bool, one: impl FnOnce() -> Self, other: impl FnOnce() -> Self) -> Self {
                if truth { one() } else { other() }
            }
        }
    };
}

real!(f64, core::convert::identity);
real!(f32, single);
