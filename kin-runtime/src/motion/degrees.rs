//! Degrees and revolutions per minute, for programs that meet people. Inside, angles are in radians.

use core::f64::consts::PI;

use super::Motion;
use crate::number::Number;

impl<T: Number, const N: usize> Motion<T, N> {
    /// The motion of an angle in degrees, degrees per unit of time, and so on.
    ///
    /// ```
    /// use core::f64::consts::PI;
    /// use kin_core::Motion;
    ///
    /// let crank = Motion::degrees([60.0, 180.0, 0.0]);
    /// assert!((crank.position() - PI / 3.0).abs() < 1e-15);
    /// assert!((crank.velocity() - PI).abs() < 1e-15);
    /// ```
    #[doc(alias = "deg")]
    #[doc(alias = "from_degrees")]
    #[inline]
    #[must_use]
    pub fn degrees(derivatives: [T; N]) -> Self {
        Self::new(derivatives).map(|derivative| derivative * T::constant(PI / 180.0))
    }

    /// The same motion of an angle with every derivative in degrees instead of radians.
    ///
    /// Everything else in this crate takes radians: the result is for reading only.
    ///
    /// ```
    /// use core::f64::consts::FRAC_PI_2;
    /// use kin_core::Motion;
    ///
    /// let rocker = Motion::from([FRAC_PI_2, -FRAC_PI_2]);
    /// assert_eq!(rocker.to_degrees().derivatives(), [90.0, -90.0]);
    /// ```
    #[doc(alias = "deg")]
    #[inline]
    #[must_use]
    pub fn to_degrees(self) -> Self {
        self.map(|derivative| derivative * T::constant(180.0 / PI))
    }
}

/// Revolutions per minute as an angular velocity in radians per second: x · π / 30.
///
/// Mechanisms have any unit of time. A speed from this function makes it the second, so velocities are per second,
/// accelerations per second squared, and so on.
///
/// ```
/// use core::f64::consts::PI;
/// use kin_core::{Motion, rpm};
///
/// assert_eq!(rpm(1500.0), 50.0 * PI);
/// let crank: Motion = Motion::at_constant_speed(0.0, rpm(1500.0));
/// # assert_eq!(crank.velocity(), 50.0 * PI);
/// ```
#[doc(alias = "revolutions")]
#[inline]
#[must_use]
pub fn rpm<T: Number>(revolutions_per_minute: T) -> T {
    revolutions_per_minute * T::constant(PI / 30.0)
}
