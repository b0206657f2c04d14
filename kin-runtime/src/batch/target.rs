//! The columns for the motions of a batch.

use crate::geometry::{Plane, Space};
use crate::motion::{Direction, Motion};
use crate::number::Number;

/// The column for one number of each pose: a vector or a slice, or nothing if the number is not wanted.
pub trait Target<T = f64> {
    /// The column, with one entry for each pose, or `None` if the number is not wanted.
    fn slice(&mut self) -> Option<&mut [T]>;
}

impl<T> Target<T> for &mut [T] {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn slice(&mut self) -> Option<&mut [T]> {
        Some(self)
    }
}

impl<T, const N: usize> Target<T> for [T; N] {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn slice(&mut self) -> Option<&mut [T]> {
        Some(self)
    }
}

#[cfg(feature = "std")]
impl<T> Target<T> for std::vec::Vec<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn slice(&mut self) -> Option<&mut [T]> {
        Some(self)
    }
}

impl<T, C: Target<T>> Target<T> for Option<C> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn slice(&mut self) -> Option<&mut [T]> {
        self.as_mut().and_then(Target::slice)
    }
}

/// The slot of a number in a pose: which quantity it belongs to, and which derivative it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Slot {
    /// The derivative of an input: its index and its order.
    Input(usize, usize),
    /// The derivative of an unknown: its index and its order. Order 0 of a direction is its cosine.
    Unknown(usize, usize),
    /// The sine of an unknown that is a direction: its index.
    Sine(usize),
    /// The derivative of a scalar output: its index and its order.
    Output(usize, usize),
}

/// Replaces the cosines of a direction, as a batch stores them, by its angles: in (-π, π], NaN where a pose has none.
///
/// ```
/// use kin_core::batch::angles_from_cosines;
///
/// let mut column = [0.0, -1.0];
/// angles_from_cosines(&mut column, &[1.0, 0.0]);
/// assert_eq!(column, [core::f64::consts::FRAC_PI_2, core::f64::consts::PI]);
/// ```
pub fn angles_from_cosines(cosines: &mut [f64], sines: &[f64]) {
    for (angle, sine) in cosines.iter_mut().zip(sines) {
        *angle = Number::atan2(*sine, *angle);
    }
}

/// A pose with a `C` instead of each number. The structures of poses are generic for this; the `mechanism!` macro
/// implements it.
pub trait Columns<C> {
    /// Calls the visitor for each slot.
    fn each<'a>(&'a mut self, visitor: &mut impl Visitor<'a, C>)
    where
        C: 'a;
}

/// A visitor of the slots of a pose, one after the other.
///
/// This is a trait and not a closure, because closures cannot be marked for inlining.
pub trait Visitor<'a, C> {
    /// Visits a slot and its content.
    fn visit(&mut self, slot: Slot, there: &'a mut C);
}

/// A motion with a `C` instead of each number.
pub trait MotionColumns<C> {
    /// A motion filled by a function, which is called once per number.
    fn filled(fill: &mut impl FnMut() -> C) -> Self;

    /// Calls the visitor for each slot. The scalar quantities of this motion count from `first`.
    fn each<'a>(&'a mut self, first: usize, slot: impl Fn(usize, usize) -> Slot, visitor: &mut impl Visitor<'a, C>)
    where
        C: 'a;
}

impl<C, const N: usize> MotionColumns<C> for Motion<C, N> {
    fn filled(fill: &mut impl FnMut() -> C) -> Self {
        Self::new(core::array::from_fn(|_| fill()))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn each<'a>(&'a mut self, first: usize, slot: impl Fn(usize, usize) -> Slot, visitor: &mut impl Visitor<'a, C>)
    where
        C: 'a,
    {
        for (order, entry) in self.as_mut().iter_mut().enumerate() {
            visitor.visit(slot(first, order), entry);
        }
    }
}

/// Only unknowns are directions, and each counts as one quantity.
impl<C, const N: usize> MotionColumns<C> for Direction<C, N> {
    fn filled(fill: &mut impl FnMut() -> C) -> Self {
        Self::new(Plane::new(fill(), fill()), core::array::from_fn(|_| fill()))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn each<'a>(&'a mut self, first: usize, slot: impl Fn(usize, usize) -> Slot, visitor: &mut impl Visitor<'a, C>)
    where
        C: 'a,
    {
        let (unit, rates) = self.parts_mut();
        visitor.visit(slot(first, 0), &mut unit.x);
        visitor.visit(Slot::Sine(first), &mut unit.y);
        for (below, entry) in rates.iter_mut().enumerate() {
            visitor.visit(slot(first, below + 1), entry);
        }
    }
}

impl<C, const N: usize> MotionColumns<C> for Motion<Plane<C>, N> {
    fn filled(fill: &mut impl FnMut() -> C) -> Self {
        Self::new(core::array::from_fn(|_| Plane::new(fill(), fill())))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn each<'a>(&'a mut self, first: usize, slot: impl Fn(usize, usize) -> Slot, visitor: &mut impl Visitor<'a, C>)
    where
        C: 'a,
    {
        for (order, entry) in self.as_mut().iter_mut().enumerate() {
            visitor.visit(slot(first, order), &mut entry.x);
            visitor.visit(slot(first + 1, order), &mut entry.y);
        }
    }
}

impl<C, const N: usize> MotionColumns<C> for Motion<Space<C>, N> {
    fn filled(fill: &mut impl FnMut() -> C) -> Self {
        Self::new(core::array::from_fn(|_| Space::new(fill(), fill(), fill())))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn each<'a>(&'a mut self, first: usize, slot: impl Fn(usize, usize) -> Slot, visitor: &mut impl Visitor<'a, C>)
    where
        C: 'a,
    {
        for (order, entry) in self.as_mut().iter_mut().enumerate() {
            visitor.visit(slot(first, order), &mut entry.x);
            visitor.visit(slot(first + 1, order), &mut entry.y);
            visitor.visit(slot(first + 2, order), &mut entry.z);
        }
    }
}
