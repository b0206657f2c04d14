//! What to say when a closed form has no solution.

use num_traits::Float;

use crate::failure::Failure;

/// Whether a number is positive, and it and its reciprocal have full precision: both, or not. NaN is not. A square root of such a
/// number is such a number.
#[inline(always)]
pub(super) fn ordinary(number: f64, smallest: f64) -> [bool; 2] {
    ordinary_from(number, smallest, smallest)
}

/// The same for a number that must not be less than another one either, which is no smaller than the smallest.
#[inline(always)]
pub(super) fn ordinary_from(number: f64, least: f64, smallest: f64) -> [bool; 2] {
    [number >= least, number <= 1.0 / smallest]
}

/// The length of a vector, without overflow on the way.
pub(super) fn length(x: f64, y: f64) -> f64 {
    Float::hypot(x, y)
}

/// The square root of what may be negative by rounding; NaN stays NaN.
pub(super) fn root(x: f64) -> f64 {
    if x < 0.0 { 0.0 } else { Float::sqrt(x) }
}

/// The failure of a closed form that closes only while `margin` is positive.
///
/// `scale` is the size of what the margin is a difference of, so that a margin of a few `epsilon` times as much is
/// zero up to rounding; `quantity` says what must be finite.
pub(super) fn refusal(margin: f64, scale: f64, epsilon: f64, determinant: f64, quantity: &'static str) -> Failure {
    if !margin.is_finite() || !scale.is_finite() {
        Failure::NotFinite { quantity }
    } else if margin.abs() <= 8.0 * epsilon * scale {
        Failure::Singular { determinant }
    } else if margin < 0.0 {
        Failure::OutOfReach { margin }
    } else {
        // There is room, and the squares are beyond the range of the number type all the same.
        Failure::NotFinite { quantity }
    }
}
