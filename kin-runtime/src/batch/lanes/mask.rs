//! Conditions that hold in some lanes.
//!
//! The checks of a solver decide about whole vectors, unless they [are long](crate::solve::Check::IS_LONG). If they
//! decided about one lane after the other, the compiler would find vectors again, but with the lanes in another order:
//! Newton's method takes a seventh longer then.

use core::ops::{BitAnd, BitOr, Not};

use num_traits::Zero;

use super::{Element, Lanes};
use crate::number::Number;
use crate::solve::Real;

/// The lanes in which a condition holds: all bits of a number there, and none in the others.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Mask<const W: usize, const BITS: usize, E>(pub(super) Lanes<W, BITS, E>);

impl<const W: usize, const BITS: usize, E: Element> Mask<W, BITS, E> {
    /// One number where the condition holds, and another elsewhere.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn chosen(self, one: Lanes<W, BITS, E>, other: Lanes<W, BITS, E>) -> Lanes<W, BITS, E> {
        Lanes(E::selection::<W, BITS>(&self.0.0, &one.0, &other.0))
    }

    /// Whether the condition holds in every lane.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn is_every(self) -> bool {
        !(!self).is_any()
    }

    /// Whether the condition holds in any lane.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn is_any(self) -> bool {
        E::is_any::<W, BITS>(&self.0.0)
    }
}

impl<const W: usize, const BITS: usize, E: Element> BitAnd for Mask<W, BITS, E> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn bitand(self, other: Self) -> Self {
        Self(Lanes(E::conjunction::<W, BITS>(&self.0.0, &other.0.0)))
    }
}

impl<const W: usize, const BITS: usize, E: Element> BitOr for Mask<W, BITS, E> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn bitor(self, other: Self) -> Self {
        Self(Lanes(E::disjunction::<W, BITS>(&self.0.0, &other.0.0)))
    }
}

impl<const W: usize, const BITS: usize, E: Element> Not for Mask<W, BITS, E> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn not(self) -> Self {
        let Self(all) = Lanes::certainly(true);
        Self(Lanes(E::exclusion::<W, BITS>(&self.0.0, &all.0)))
    }
}

impl<const W: usize, const BITS: usize, E: Element> Lanes<W, BITS, E> {
    /// The larger of two numbers. NaN does not count if it is the other one.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn or_larger(self, other: Self) -> Self {
        Self(E::larger::<W, BITS>(&self.0, &other.0))
    }
}

/// All lanes at once: where a plain number computes one of two numbers, lanes compute both.
impl<const W: usize, const BITS: usize, E: Element> Real for Lanes<W, BITS, E> {
    type Truth = Mask<W, BITS, E>;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of(value: f64) -> Self {
        Self::constant(value)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn magnitude(self) -> Self {
        Self(E::absolute_value::<W, BITS>(&self.0))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rounded(self) -> Self {
        Self::from_fn(|lane| self.0[lane].rounded())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn raised(self) -> Self {
        Self::from_fn(|lane| self.0[lane].raised())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_at_least(self, other: Self) -> Self::Truth {
        Mask(Self(E::at_least::<W, BITS>(&self.0, &other.0)))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn exceeds(self, other: Self) -> Self::Truth {
        Mask(Self(E::exceeding::<W, BITS>(&self.0, &other.0)))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn equals(self, other: Self) -> Self::Truth {
        Mask(Self(E::equal::<W, BITS>(&self.0, &other.0)))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_finite(self) -> Self::Truth {
        Lanes([E::max_value(); W]).is_at_least(self.magnitude())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn certainly(answer: bool) -> Self::Truth {
        let none = E::Bits::zero();
        Mask(Self([E::of_bits(if answer { !none } else { none }); W]))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn both(one: Self::Truth, other: impl FnOnce() -> Self::Truth) -> Self::Truth {
        one & other()
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn either(one: Self::Truth, other: impl FnOnce() -> Self::Truth) -> Self::Truth {
        one | other()
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn not(truth: Self::Truth) -> Self::Truth {
        !truth
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn choose(truth: Self::Truth, one: impl FnOnce() -> Self, other: impl FnOnce() -> Self) -> Self {
        truth.chosen(one(), other())
    }
}
