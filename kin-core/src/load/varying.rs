//! What a load accepts as a point, an angle, a force or a torque: constants and motions.

use crate::geometry::{Plane, Space};
use crate::motion::{Direction, Motion};
use crate::number::Number;
use crate::solve::Scalar;

/// A quantity that is constant, or that is given with its derivatives by time.
///
/// | for | accepted |
/// |---|---|
/// | a point | `Motion` of a `Plane` or a `Space` of a pose; a `Plane` or a `Space` for a point of the ground |
/// | an angle or a distance | `Motion` or `Direction` of a pose |
/// | a force | `Plane` or `Space`, or a `Motion` of them |
/// | a torque | `f64`, or a `Motion` |
///
/// A vector of the plane lies at z = 0. Do not implement it for other types: a new version may add items.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be taken for a point, an angle, a force or a torque here",
    note = "points are motions of a pose, as in `|pose| pose.tool`, or a `Plane` or `Space` of numbers with a decimal point; angles \
            are motions of a pose, as in `|pose| pose.theta3`; forces are vectors and torques are numbers"
)]
pub trait Varying<V>: Copy {
    /// The number of entries that are known: the value, and the derivatives in ascending order.
    const ENTRIES: usize;

    /// The value, order 0, or the derivative of another order below [`ENTRIES`](Self::ENTRIES).
    fn entry(&self, order: usize) -> V;
}

impl<T: Number> Varying<T> for f64 {
    const ENTRIES: usize = usize::MAX;

    fn entry(&self, order: usize) -> T {
        T::constant(if order == 0 { *self } else { 0.0 })
    }
}

impl<T: Number> Varying<Space<T>> for Plane<f64> {
    const ENTRIES: usize = usize::MAX;

    fn entry(&self, order: usize) -> Space<T> {
        Space::new(self.x, self.y, 0.0).entry(order)
    }
}

impl<T: Number> Varying<Space<T>> for Space<f64> {
    const ENTRIES: usize = usize::MAX;

    fn entry(&self, order: usize) -> Space<T> {
        Space::new(self.x.entry(order), self.y.entry(order), self.z.entry(order))
    }
}

impl<T: Number, const N: usize> Varying<T> for Motion<T, N> {
    const ENTRIES: usize = N;

    fn entry(&self, order: usize) -> T {
        self[order]
    }
}

impl<T: Number, const N: usize> Varying<Space<T>> for Motion<Plane<T>, N> {
    const ENTRIES: usize = N;

    fn entry(&self, order: usize) -> Space<T> {
        Space::new(self[order].x, self[order].y, T::constant(0.0))
    }
}

impl<T: Number, const N: usize> Varying<Space<T>> for Motion<Space<T>, N> {
    const ENTRIES: usize = N;

    fn entry(&self, order: usize) -> Space<T> {
        self[order]
    }
}

impl<T: Scalar, const N: usize> Varying<T> for Direction<T, N> {
    const ENTRIES: usize = N + 1;

    fn entry(&self, order: usize) -> T {
        match order.checked_sub(1) {
            None => self.angle(),
            Some(rate) => self.rates()[rate],
        }
    }
}
