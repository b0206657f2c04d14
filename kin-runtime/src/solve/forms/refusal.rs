//! The failure of a closed form that has no solution.

use num_traits::Float;

use crate::failure::Failure;

/// The length of a vector, computed without overflow.
pub(super) fn length(x: f64, y: f64) -> f64 {
    Float::hypot(x, y)
}

/// The square root of a number that may be negative by rounding; NaN stays NaN.
pub(super) fn root(x: f64) -> f64 {
    if x < 0.0 { 0.0 } else { Float::sqrt(x) }
}

/// The failure of a closed form that closes only while `margin` is positive.
///
/// `scale` is the size of the numbers whose difference is the margin. A margin of a few `epsilon` times that size is
/// zero up to rounding. `quantity` names the quantity that must be finite.
pub(super) fn refusal(margin: f64, scale: f64, epsilon: f64, determinant: f64, quantity: &'static str) -> Failure {
    if !margin.is_finite() || !scale.is_finite() {
        Failure::not_finite(quantity)
    } else if margin.abs() <= 8.0 * epsilon * scale {
        Failure::Singular { determinant }
    } else if margin < 0.0 {
        Failure::OutOfReach { margin }
    } else {
        // The links reach, but the squares exceed the range of the number type.
        Failure::not_finite(quantity)
    }
}
