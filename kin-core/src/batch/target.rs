//! Where the motions of a batch go.

use crate::geometry::{Plane, Space};
use crate::motion::{Direction, Motion};

/// A place for one number of each pose: a vector or a slice, or nothing if the number is not wanted.
pub trait Target {
    /// The place, as long as there are poses; nothing if the number is not wanted.
    fn slice(&mut self) -> Option<&mut [f64]>;
}

impl Target for &mut [f64] {
    #[inline(always)]
    fn slice(&mut self) -> Option<&mut [f64]> {
        Some(self)
    }
}

impl<const N: usize> Target for [f64; N] {
    #[inline(always)]
    fn slice(&mut self) -> Option<&mut [f64]> {
        Some(self)
    }
}

#[cfg(feature = "std")]
impl Target for std::vec::Vec<f64> {
    #[inline(always)]
    fn slice(&mut self) -> Option<&mut [f64]> {
        Some(self)
    }
}

impl<C: Target> Target for Option<C> {
    #[inline(always)]
    fn slice(&mut self) -> Option<&mut [f64]> {
        self.as_mut().and_then(Target::slice)
    }
}

/// Which number of a pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// The derivative of an order of an input.
    Input(usize, usize),
    /// The derivative of an order of an unknown; of a direction, the cosine at order 0.
    Unknown(usize, usize),
    /// The sine of an unknown that is a direction.
    Sine(usize),
    /// The derivative of an order of a scalar output.
    Output(usize, usize),
}

/// A pose with something of type `C` in the place of each number, as its structure is generic. Implemented by the `mechanism!` macro.
pub trait Columns<C> {
    /// Has each place visited.
    fn each<'a>(&'a mut self, visitor: &mut impl Visitor<'a, C>)
    where
        C: 'a;
}

/// Who visits the places of a pose, one after the other.
///
/// Not a function, as a closure cannot be told to be inlined.
pub trait Visitor<'a, C> {
    /// Sees a place, and what is there.
    fn visit(&mut self, place: Place, there: &'a mut C);
}

/// A motion with something in the place of each number.
pub trait MotionColumns<C> {
    /// With what a function gives for each.
    fn filled(fill: &mut impl FnMut() -> C) -> Self;

    /// Has each place visited. The scalar quantities that make it up count from `first`.
    fn each<'a>(&'a mut self, first: usize, place: impl Fn(usize, usize) -> Place, visitor: &mut impl Visitor<'a, C>)
    where
        C: 'a;
}

impl<C, const N: usize> MotionColumns<C> for Motion<C, N> {
    fn filled(fill: &mut impl FnMut() -> C) -> Self {
        Self::new(core::array::from_fn(|_| fill()))
    }

    #[inline(always)]
    fn each<'a>(&'a mut self, first: usize, place: impl Fn(usize, usize) -> Place, visitor: &mut impl Visitor<'a, C>)
    where
        C: 'a,
    {
        for (order, entry) in self.as_mut().iter_mut().enumerate() {
            visitor.visit(place(first, order), entry);
        }
    }
}

/// Directions are of unknowns alone, which count as one each.
impl<C, const N: usize> MotionColumns<C> for Direction<C, N> {
    fn filled(fill: &mut impl FnMut() -> C) -> Self {
        Self::new(Plane::new(fill(), fill()), core::array::from_fn(|_| fill()))
    }

    #[inline(always)]
    fn each<'a>(&'a mut self, first: usize, place: impl Fn(usize, usize) -> Place, visitor: &mut impl Visitor<'a, C>)
    where
        C: 'a,
    {
        let (unit, rates) = self.parts_mut();
        visitor.visit(place(first, 0), &mut unit.x);
        visitor.visit(Place::Sine(first), &mut unit.y);
        for (below, entry) in rates.iter_mut().enumerate() {
            visitor.visit(place(first, below + 1), entry);
        }
    }
}

impl<C, const N: usize> MotionColumns<C> for Motion<Plane<C>, N> {
    fn filled(fill: &mut impl FnMut() -> C) -> Self {
        Self::new(core::array::from_fn(|_| Plane::new(fill(), fill())))
    }

    #[inline(always)]
    fn each<'a>(&'a mut self, first: usize, place: impl Fn(usize, usize) -> Place, visitor: &mut impl Visitor<'a, C>)
    where
        C: 'a,
    {
        for (order, entry) in self.as_mut().iter_mut().enumerate() {
            visitor.visit(place(first, order), &mut entry.x);
            visitor.visit(place(first + 1, order), &mut entry.y);
        }
    }
}

impl<C, const N: usize> MotionColumns<C> for Motion<Space<C>, N> {
    fn filled(fill: &mut impl FnMut() -> C) -> Self {
        Self::new(core::array::from_fn(|_| Space::new(fill(), fill(), fill())))
    }

    #[inline(always)]
    fn each<'a>(&'a mut self, first: usize, place: impl Fn(usize, usize) -> Place, visitor: &mut impl Visitor<'a, C>)
    where
        C: 'a,
    {
        for (order, entry) in self.as_mut().iter_mut().enumerate() {
            visitor.visit(place(first, order), &mut entry.x);
            visitor.visit(place(first + 1, order), &mut entry.y);
            visitor.visit(place(first + 2, order), &mut entry.z);
        }
    }
}
