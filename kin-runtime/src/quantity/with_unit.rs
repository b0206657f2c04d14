//! Values with their units.

use core::fmt;

use super::Digits;

/// The largest number of degrees that is shown beside radians. Beyond it, people think in revolutions.
const MOST_DEGREES: f64 = 1e4;

/// A value for people: an angle has its unit, and its degrees in parentheses.
///
/// Lengths have the mechanism's unit, which has no name. Without a precision, the number has seven significant figures.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WithUnit {
    pub(crate) value: f64,
    pub(crate) is_angle: bool,
}

impl fmt::Display for WithUnit {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match formatter.precision() {
            Some(precision) => write!(formatter, "{:.precision$}", self.value)?,
            None => write!(formatter, "{}", Digits(self.value))?,
        }
        if !self.is_angle {
            return Ok(());
        }
        formatter.write_str(" rad")?;
        let degrees = self.value.to_degrees();
        if degrees.abs() < MOST_DEGREES {
            write!(formatter, " ({degrees:.1}°)")?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use std::{format, string::ToString};

    use super::WithUnit;
    #[test]
    fn angles_are_shown_in_degrees_too() {
        let angle = |value| WithUnit { value, is_angle: true }.to_string();
        assert_eq!(angle(0.855_211_333), "0.8552113 rad (49.0°)");
        assert_eq!(angle(-core::f64::consts::PI), "-3.141593 rad (-180.0°)");
        assert_eq!(angle(0.0), "0 rad (0.0°)");
        assert_eq!(angle(1e15), "1e15 rad");
        assert_eq!(angle(f64::INFINITY), "inf rad");
        assert_eq!(angle(f64::NAN), "NaN rad");
        assert_eq!(
            format!(
                "{:.2}",
                WithUnit {
                    value: 0.855_211_333,
                    is_angle: true
                }
            ),
            "0.86 rad (49.0°)"
        );
        let length = WithUnit {
            value: 0.25,
            is_angle: false,
        };
        assert_eq!(length.to_string(), "0.25");
    }
}
