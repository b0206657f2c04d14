//! The format of numbers in messages.

use core::fmt;

use num_traits::Float;

/// A number shown to seven significant figures, without trailing zeros.
///
/// Messages are for people: `1.9547687622336491` says no more to them than `1.954769`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Digits(pub(crate) f64);

impl fmt::Display for Digits {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let value = self.0;
        let size = value.abs();
        if value == 0.0 {
            return formatter.write_str("0");
        }
        if !(1e-4..1e7).contains(&size) {
            // The exponent form rounds; parsing the result again removes its trailing zeros.
            return if size.is_finite() {
                write!(formatter, "{:e}", round_to_digits(value))
            } else {
                write!(formatter, "{value}")
            };
        }
        write!(formatter, "{}", round_to_digits(value))
    }
}

/// The nearest number with seven significant decimal figures.
///
/// An integer divided by a power of ten is the double nearest to that decimal fraction. Printing uses the shortest
/// representation, which then has no further figures.
fn round_to_digits(value: f64) -> f64 {
    let exponent = 6.0 - Float::floor(Float::log10(value.abs()));
    let power = Float::powf(10.0, exponent.abs());
    if exponent >= 0.0 {
        // Below the range of normal numbers the power overflows; such a number is shown unchanged.
        if power.is_finite() {
            Float::round(value * power) / power
        } else {
            value
        }
    } else {
        let rounded = Float::round(value / power) * power;
        if rounded.is_finite() { rounded } else { value }
    }
}

#[cfg(test)]
mod tests {
    use super::Digits;
    use std::string::ToString;

    #[test]
    fn seven_figures_without_trailing_zeros() {
        for (value, shown) in [
            (1.954_768_762_233_649_1, "1.954769"),
            (3.0, "3"),
            (-0.0123, "-0.0123"),
            (123_456.789, "123456.8"),
            (0.0, "0"),
            (1e-9, "1e-9"),
            (2.5e12, "2.5e12"),
            (f64::NAN, "NaN"),
            (f64::NEG_INFINITY, "-inf"),
        ] {
            assert_eq!(Digits(value).to_string(), shown);
        }
    }

    #[test]
    fn extremes_are_shown() {
        for value in [f64::MAX, f64::MIN_POSITIVE, 5e-324] {
            assert!(Digits(value).to_string().contains('e'));
        }
    }
}
