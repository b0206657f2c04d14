//! Points of the plane or of space, in a row.

use core::fmt::Debug;

use crate::geometry::{Plane, Space};
use crate::number::Number;

/// A point of the plane or of space.
#[doc(hidden)]
pub trait PlaneOrSpace: Copy + Debug {
    /// The number type.
    type Scalar;
    /// Whether it is a point of the plane.
    const IS_PLANE: bool;

    /// The same point in space; a plane point lies at the height zero.
    fn in_space(self) -> Space<Self::Scalar>;
}

impl<T: Number> PlaneOrSpace for Plane<T> {
    type Scalar = T;
    const IS_PLANE: bool = true;

    fn in_space(self) -> Space<T> {
        Space::new(self.x, self.y, T::constant(0.0))
    }
}

impl<T: Number> PlaneOrSpace for Space<T> {
    type Scalar = T;
    const IS_PLANE: bool = false;

    fn in_space(self) -> Space<T> {
        self
    }
}

/// An array of points.
#[doc(hidden)]
pub trait PointArray: Copy + Debug {
    /// The points, of the plane or of space.
    type Point: PlaneOrSpace;

    /// All of them.
    fn as_slice(&self) -> &[Self::Point];
}

impl<V: PlaneOrSpace, const N: usize> PointArray for [V; N] {
    type Point = V;

    fn as_slice(&self) -> &[V] {
        self
    }
}
