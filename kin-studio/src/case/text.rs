//! Numbers with units as text.

use kin_core::Dimension;

/// The units in which values are shown.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Units {
    /// Whether angles are in degrees.
    pub(crate) in_degrees: bool,
    /// The unit of length, empty if there is none.
    pub(crate) length: &'static str,
}

impl Units {
    /// A value in the unit that is shown.
    pub(crate) fn value(self, dimension: Dimension, value: f64) -> f64 {
        match dimension {
            Dimension::Angle if self.in_degrees => value.to_degrees(),
            _ => value,
        }
    }

    /// The unit of a derivative.
    pub(crate) fn unit(self, dimension: Dimension, order: usize) -> String {
        const POWERS: [&str; 10] = ["⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"];
        let name = match dimension {
            Dimension::Angle if self.in_degrees => "deg",
            Dimension::Angle => "rad",
            Dimension::Length => self.length,
            Dimension::Scalar => "",
        };
        let name = if name.is_empty() && order > 0 && dimension == Dimension::Length {
            "L"
        } else {
            name
        };
        let second = match order {
            0 => return name.to_owned(),
            1 => "s".to_owned(),
            order => {
                let digits = order.to_string();
                let power = digits.bytes().map(|digit| POWERS[usize::from(digit - b'0')]);
                format!("s{}", power.collect::<String>())
            }
        };
        if name.is_empty() {
            format!("1/{second}")
        } else {
            format!("{name}/{second}")
        }
    }

    /// A value with its unit.
    pub(crate) fn text(self, dimension: Dimension, order: usize, value: f64) -> String {
        let unit = self.unit(dimension, order);
        let value = self.value(dimension, value);
        // an angle of zero, but for rounding
        let is_zero = dimension == Dimension::Angle && order == 0 && value.abs() < 1e-12;
        let number = digits(if is_zero { 0.0 } else { value });
        if unit.is_empty() {
            number
        } else {
            format!("{number} {unit}")
        }
    }
}

/// A number with six significant digits.
pub(crate) fn digits(value: f64) -> String {
    if value.is_nan() {
        return "-".to_owned();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let size = value.abs();
    if !(1e-4..1e9).contains(&size) {
        return format!("{value:.5e}");
    }
    let mut before: i32 = 0;
    let mut power = size;
    while power >= 10.0 {
        power /= 10.0;
        before += 1;
    }
    while power < 1.0 {
        power *= 10.0;
        before -= 1;
    }
    let behind = usize::try_from(5 - before).unwrap_or(0);
    let text = format!("{value:.behind$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// A column of numbers with as many decimals as six significant digits of the largest one take, so that their points
/// stand below each other.
pub(crate) fn aligned(values: &[f64]) -> Vec<String> {
    let sizes = values.iter().filter(|value| value.is_finite()).map(|value| value.abs());
    let largest = sizes.fold(0.0, f64::max);
    if largest != 0.0 && !(1e-4..1e9).contains(&largest) {
        return values.iter().map(|value| digits(*value)).collect();
    }
    let mut behind = 5_usize;
    let mut size = largest;
    while size >= 10.0 && behind > 0 {
        size /= 10.0;
        behind -= 1;
    }
    while size < 1.0 && size > 0.0 {
        size *= 10.0;
        behind += 1;
    }
    let shown = |value: &f64| {
        if value.is_nan() {
            return "-".to_owned();
        }
        let text = format!("{value:.behind$}");
        // what rounds to zero has no sign
        match text.strip_prefix('-') {
            Some(rest) if rest.bytes().all(|byte| byte == b'0' || byte == b'.') => rest.to_owned(),
            _ => text,
        }
    };
    values.iter().map(shown).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_six_digits() {
        for (value, text) in [
            (112.024_316, "112.024"),
            (0.5, "0.5"),
            (-0.000_123_456_78, "-0.000123457"),
            (1e-9, "1.00000e-9"),
            (0.0, "0"),
            (360.0, "360"),
            (1_234_567.0, "1234567"),
        ] {
            assert_eq!(digits(value), text);
        }
        assert_eq!(aligned(&[-0.000_000_1, 359.5]), ["0.000", "359.500"]);
    }
}
