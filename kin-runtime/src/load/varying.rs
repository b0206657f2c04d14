//! What a load accepts as a point, an angle, a force or a torque: constants and motions.

use crate::geometry::{Plane, Space};
use crate::motion::{Direction, Motion};
use crate::number::Number;
use crate::solve::Scalar;

/// A vector that is constant, or that is given with its derivatives by time: a point, a force, or the acceleration of
/// gravity.
///
/// | for | accepted |
/// |---|---|
/// | a point | `Motion` of a `Plane` or a `Space` of a pose; a `Plane` or a `Space` for a point of the ground |
/// | a force | `Plane` or `Space`, or a `Motion` of them |
/// | gravity | `Plane` or `Space` |
///
/// A vector of the plane lies at z = 0. Do not implement it for other types: a new version may add items.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a vector: points, forces and gravity are",
    label = "write a vector: `Plane::new(0.0, -9.81)`, or `Space::new(..)` in space",
    note = "points are motions of a pose, as in `|pose| pose.tool`, or a `Plane` or `Space` of numbers with a decimal \
    point for a point of the ground; the force on a slider along its own distance is a number: `torque(force, |pose| \
    pose.s)`"
)]
pub trait VaryingVector<T>: Copy {
    /// The number of entries that are known: the value, and the derivatives in ascending order.
    const ENTRIES: usize;

    /// The value, order 0, or the derivative of another order below [`ENTRIES`](Self::ENTRIES).
    fn entry(&self, order: usize) -> Space<T>;
}

/// A number that is constant, or that is given with its derivatives by time: an angle, a distance, or a torque.
///
/// | for | accepted |
/// |---|---|
/// | an angle or a distance | `Motion` or `Direction` of a pose |
/// | a torque | `f64`, or a `Motion` |
///
/// Do not implement it for other types: a new version may add items.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a number: angles, distances and torques are",
    label = "write a number with a decimal point, or choose an angle or a distance: `|pose| pose.theta3`",
    note = "what moves a point is a force: `force(Plane::new(10.0, 0.0), |pose| pose.tool)`"
)]
pub trait VaryingNumber<T>: Copy {
    /// The number of entries that are known: the value, and the derivatives in ascending order.
    const ENTRIES: usize;

    /// The value, order 0, or the derivative of another order below [`ENTRIES`](Self::ENTRIES).
    fn entry(&self, order: usize) -> T;
}

impl<T: Number> VaryingNumber<T> for f64 {
    const ENTRIES: usize = usize::MAX;

    fn entry(&self, order: usize) -> T {
        T::constant(if order == 0 { *self } else { 0.0 })
    }
}

impl<T: Number, const N: usize> VaryingNumber<T> for Motion<T, N> {
    const ENTRIES: usize = N;

    fn entry(&self, order: usize) -> T {
        self[order]
    }
}

impl<T: Scalar, const N: usize> VaryingNumber<T> for Direction<T, N> {
    const ENTRIES: usize = N + 1;

    fn entry(&self, order: usize) -> T {
        match order.checked_sub(1) {
            None => self.angle(),
            Some(rate) => self.rates()[rate],
        }
    }
}

impl<T: Number> VaryingVector<T> for Plane<f64> {
    const ENTRIES: usize = usize::MAX;

    fn entry(&self, order: usize) -> Space<T> {
        Space::new(self.x, self.y, 0.0).entry(order)
    }
}

impl<T: Number> VaryingVector<T> for Space<f64> {
    const ENTRIES: usize = usize::MAX;

    fn entry(&self, order: usize) -> Space<T> {
        Space::new(self.x.entry(order), self.y.entry(order), self.z.entry(order))
    }
}

impl<T: Number, const N: usize> VaryingVector<T> for Motion<Plane<T>, N> {
    const ENTRIES: usize = N;

    fn entry(&self, order: usize) -> Space<T> {
        Space::new(self[order].x, self[order].y, T::constant(0.0))
    }
}

impl<T: Number, const N: usize> VaryingVector<T> for Motion<Space<T>, N> {
    const ENTRIES: usize = N;

    fn entry(&self, order: usize) -> Space<T> {
        self[order]
    }
}
