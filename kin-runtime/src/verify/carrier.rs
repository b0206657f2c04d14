//! Numbers that carry time derivatives.

#[cfg(feature = "num-dual")]
use num_dual::{HyperDual, HyperDual64};

use crate::number::series::Series;
use crate::solve::Scalar;

/// A number that represents a function of time by its value and its derivatives at one moment.
pub trait Carrier: Scalar {
    /// The function with the given derivatives, value first. Missing derivatives are zero.
    fn carrying(derivatives: &[f64]) -> Self;

    /// The derivative of the given order; NaN beyond the orders that the number carries.
    fn derivative(&self, order: usize) -> f64;

    /// The derivatives up to an order, value first.
    fn derivatives_through(&self, order: usize) -> std::vec::Vec<f64> {
        (0..=order).map(|order| self.derivative(order)).collect()
    }
}

/// The carrier up to the fourth order: nested dual numbers.
///
/// With two steps inside and two outside, every subset of k steps holds the k-th
/// derivative (J. A. Fike and J. J. Alonso, "The development of hyper-dual numbers for exact second-derivative
/// calculations", AIAA 2011-886).
#[cfg(feature = "num-dual")]
pub type ThroughSnap = HyperDual<HyperDual64>;

/// The carrier up to the fourth order: a truncated Taylor series.
#[cfg(not(feature = "num-dual"))]
pub type ThroughSnap = Series<5>;

/// The name of the numbers that carry derivatives up to an order.
pub(super) const fn numbers_through(order: usize) -> &'static str {
    if cfg!(feature = "num-dual") && order <= 4 {
        "dual numbers"
    } else {
        "truncated Taylor series"
    }
}

#[cfg(feature = "num-dual")]
impl Carrier for ThroughSnap {
    fn carrying(derivatives: &[f64]) -> Self {
        let at = |order: usize| derivatives.get(order).copied().unwrap_or(0.0);
        let inner = |order: usize| HyperDual64::new(at(order), at(order + 1), at(order + 1), at(order + 2));
        Self::new(inner(0), inner(1), inner(1), inner(2))
    }

    fn derivative(&self, order: usize) -> f64 {
        match order {
            0 => self.re.re,
            1 => self.re.eps1,
            2 => self.re.eps1eps2,
            3 => self.eps1.eps1eps2,
            4 => self.eps1eps2.eps1eps2,
            _ => f64::NAN,
        }
    }
}

/// Carries derivatives up to order `N` - 1.
impl<const N: usize> Carrier for Series<N> {
    fn carrying(derivatives: &[f64]) -> Self {
        Self::from_derivatives(core::array::from_fn(|order| {
            derivatives.get(order).copied().unwrap_or(0.0)
        }))
    }

    fn derivative(&self, order: usize) -> f64 {
        self.derivatives().get(order).copied().unwrap_or(f64::NAN)
    }
}
