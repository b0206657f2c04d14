//! Dimensions and angles for property tests of the closed forms.

use core::f64::consts::PI;

use proptest::strategy::Strategy;

use crate::geometry::Plane;
use crate::number::Number;

/// Link lengths over twelve decades, evenly on a logarithmic scale.
pub(super) fn dimension() -> impl Strategy<Value = f64> {
    (-6.0..6.0).prop_map(|exponent: f64| 10.0_f64.powf(exponent))
}

/// Coordinates of either sign over twelve decades.
pub(super) fn coordinate() -> impl Strategy<Value = f64> {
    (dimension(), proptest::bool::ANY).prop_map(|(size, negative)| if negative { -size } else { size })
}

/// Any angle.
pub(super) fn angle() -> impl Strategy<Value = f64> {
    -PI..PI
}

/// The unit vector at an angle.
pub(super) fn direction(angle: f64) -> Plane {
    let (sine, cosine) = Number::sin_cos(angle);
    Plane::new(cosine, sine)
}

/// The length of a vector.
pub(super) fn norm(vector: Plane) -> f64 {
    vector.x.hypot(vector.y)
}
