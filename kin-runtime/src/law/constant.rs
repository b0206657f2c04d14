//! Rest, and constant speed.

use super::LawError;
use super::error::{finite, positive};
use super::piecewise::Piecewise;
use crate::number::Number;

/// Rest at a value.
///
/// ```
/// use kin_core::law::{Dwell, Law};
///
/// let dwell = Dwell::new(30.0, 0.5)?;
/// assert_eq!(dwell.at::<3>(0.2).derivatives(), [30.0, 0.0, 0.0]);
/// # Ok::<(), kin_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dwell<T = f64> {
    value: T,
    duration: T,
}

impl<T: Number> Dwell<T> {
    /// Rest at `value` for a time.
    ///
    /// # Errors
    /// [`LawError::NotFinite`] for the value, [`LawError::NotPositive`] for the duration.
    pub fn new(value: T, duration: T) -> Result<Self, LawError> {
        Ok(Self {
            value: finite("value of the dwell", value)?,
            duration: positive("duration of the dwell", duration)?,
        })
    }
}

impl<T: Number> Piecewise<T> for Dwell<T> {
    fn end(&self, _: usize) -> T {
        self.duration
    }

    fn write(&self, _: usize, _: T, derivatives: &mut [T]) {
        line(self.value, T::constant(0.0), derivatives);
    }
}

/// Motion at constant speed.
///
/// ```
/// use kin_core::law::{ConstantSpeed, Law};
///
/// let belt = ConstantSpeed::new(1.0, 20.0, 0.5)?;
/// assert_eq!(belt.at::<3>(0.25).derivatives(), [6.0, 20.0, 0.0]);
/// # Ok::<(), kin_core::law::LawError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstantSpeed<T = f64> {
    from: T,
    speed: T,
    duration: T,
}

impl<T: Number> ConstantSpeed<T> {
    /// Motion from a value, at a speed in the value's unit per unit of time, for a time.
    ///
    /// # Errors
    /// [`LawError::NotFinite`] for value and speed, [`LawError::NotPositive`] for the duration.
    pub fn new(from: T, speed: T, duration: T) -> Result<Self, LawError> {
        Ok(Self {
            from: finite("value from which the motion starts", from)?,
            speed: finite("speed", speed)?,
            duration: positive("duration of constant speed", duration)?,
        })
    }
}

impl<T: Number> Piecewise<T> for ConstantSpeed<T> {
    fn end(&self, _: usize) -> T {
        self.duration
    }

    fn write(&self, _: usize, time: T, derivatives: &mut [T]) {
        line(self.from.plus_product(self.speed, time), self.speed, derivatives);
    }
}

/// Writes a value, its speed, and zeros.
pub(super) fn line<T: Number>(value: T, speed: T, derivatives: &mut [T]) {
    derivatives.fill(T::constant(0.0));
    for (entry, known) in derivatives.iter_mut().zip([value, speed]) {
        *entry = known;
    }
}
