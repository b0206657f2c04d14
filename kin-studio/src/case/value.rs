//! Numbers with units, as people type them.

use kin_core::Dimension;

use super::units::{self, Kind, Unit};

/// The unit of the lengths of one run: the first one that is typed. Numbers without a unit are in it, too.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Lengths {
    /// The unit, if a unit was typed.
    pub(crate) unit: Option<Unit>,
}

impl Lengths {
    /// The unit of a name.
    pub(crate) fn named(name: &str) -> Result<Self, String> {
        Ok(Self {
            unit: Some(length_unit(name)?),
        })
    }

    /// The name of the unit, empty if none was typed.
    pub(crate) fn name(&self) -> &'static str {
        self.unit.map_or("", |unit| unit.name)
    }

    /// The metres of its unit. Lengths without a unit count as metres.
    pub(crate) fn metres(&self) -> f64 {
        self.unit.map_or(1.0, |unit| unit.size)
    }

    fn converted(&mut self, number: f64, unit: Unit) -> f64 {
        let common = *self.unit.get_or_insert(unit);
        if common == unit {
            number
        } else {
            number * (unit.size / common.size)
        }
    }
}

fn length_unit(name: &str) -> Result<Unit, String> {
    units::LENGTH.unit(name).ok_or_else(|| wrong_unit(units::LENGTH, name))
}

fn wrong_unit(kind: Kind, name: &str) -> String {
    let quantity = kind.name.split_once(' ').map_or(kind.name, |(_, name)| name);
    format!("`{name}` is not a unit of {quantity}; write {}", kind.listed())
}

/// A number with a unit, in SI. Only zero needs no unit.
pub(crate) fn in_si(kind: Kind, text: &str) -> Result<f64, String> {
    let (number, unit) = split(text)?;
    match kind.unit(unit) {
        Some(unit) => Ok(number * unit.size),
        None if unit.is_empty() && number == 0.0 => Ok(0.0),
        None if unit.is_empty() => Err(format!(
            "{} has a unit: write `{number}{}`{}",
            kind.name,
            kind.units[0].name,
            kind.units
                .get(1)
                .map_or(String::new(), |unit| format!(" or `{number}{}`", unit.name))
        )),
        None => Err(wrong_unit(kind, unit)),
    }
}

/// A number and the text behind it.
pub(crate) fn split(text: &str) -> Result<(f64, &str), String> {
    let text = text.trim();
    let is_number = |end: &usize| text.is_char_boundary(*end) && text[..*end].trim_end().parse::<f64>().is_ok();
    let begins = |text: &str| text.starts_with(|letter: char| letter.is_ascii_digit() || "+-.".contains(letter));
    let end = (1..=text.len()).rev().find(is_number);
    let (number, unit) = match end {
        Some(end) if begins(text) && text[end..].starts_with(',') => {
            return Err(format!(
                "`{text}` has a comma: write `{}` with a point",
                text.replacen(',', ".", 1)
            ));
        }
        Some(end) if begins(text) => text.split_at(end),
        _ => {
            return Err(format!(
                "`{text}` does not begin with a number, as in `45`, `0.5` or `30deg`"
            ));
        }
    };
    let number: f64 = number
        .trim_end()
        .parse()
        .map_err(|_| format!("`{text}` is not a number"))?;
    if number.is_finite() {
        Ok((number, unit.trim()))
    } else {
        Err(format!("`{text}` is too large a number"))
    }
}

/// A value of a dimension: an angle in radians, a length in the unit of the run, or a plain number.
pub(crate) fn quantity(dimension: Dimension, text: &str, lengths: &mut Lengths) -> Result<f64, String> {
    let (number, unit) = split(text)?;
    with_unit(dimension, number, unit, lengths)
}

fn with_unit(dimension: Dimension, number: f64, unit: &str, lengths: &mut Lengths) -> Result<f64, String> {
    match dimension {
        Dimension::Angle => angle(number, unit),
        Dimension::Length if unit.is_empty() => Ok(number),
        Dimension::Length => Ok(lengths.converted(number, length_unit(unit)?)),
        Dimension::Scalar if unit.is_empty() => Ok(number),
        Dimension::Scalar => Err(format!("this is a plain number: write `{number}`, without `{unit}`")),
    }
}

/// The unit of a number that was typed, and its size, where angles are in radians and lengths in the unit of the run.
/// An angle of zero, which needs none, has the first.
pub(crate) fn unit_of(dimension: Dimension, text: &str, lengths: Lengths) -> (&'static str, f64) {
    let typed = split(text).map_or("", |(_, unit)| unit);
    let (unit, common) = match dimension {
        Dimension::Angle => (units::ANGLE.unit(typed).or(units::ANGLE.units.first().copied()), 1.0),
        Dimension::Length => (units::LENGTH.unit(typed), lengths.metres()),
        Dimension::Scalar => (None, 1.0),
    };
    unit.map_or(("", 1.0), |unit| (unit.name, unit.size / common))
}

fn angle(number: f64, unit: &str) -> Result<f64, String> {
    match units::ANGLE.unit(unit) {
        Some(unit) => Ok(number * unit.size),
        None if !unit.is_empty() => Err(wrong_unit(units::ANGLE, unit)),
        None if number == 0.0 => Ok(0.0),
        None => Err(format!("an angle has a unit: write `{number}deg` or `{number}rad`")),
    }
}

/// A range, as in `0..360deg`. A start without a unit has that of the end.
pub(crate) fn range(dimension: Dimension, text: &str, lengths: &mut Lengths) -> Result<(f64, f64), String> {
    let Some((from, to)) = text.split_once("..") else {
        return Err(format!("`{}` is not a range, as in `0..360deg`", text.trim()));
    };
    let to = to.strip_prefix('=').unwrap_or(to);
    let ((from, from_unit), (to, to_unit)) = (split(from)?, split(to)?);
    let from_unit = if from_unit.is_empty() { to_unit } else { from_unit };
    let to = with_unit(dimension, to, to_unit, lengths)?;
    let from = with_unit(dimension, from, from_unit, lengths)?;
    if from == to {
        return Err(format!("the range `{}` has no length", text.trim()));
    }
    Ok((from, to))
}

/// The speed of an input, by second.
pub(crate) fn speed(dimension: Dimension, text: &str, lengths: &mut Lengths) -> Result<f64, String> {
    let (number, unit) = split(text)?;
    let unit = unit.replace(' ', "");
    if dimension == Dimension::Angle {
        return units::speed_of_angle(number, &unit).ok_or_else(|| {
            format!(
                "`{}` is not the speed of an angle: write `{number}rpm`, `{number}rad/s`, `{number}deg/s` or \
                 `{number}Hz`",
                text.trim()
            )
        });
    }
    match unit.strip_suffix("/s") {
        None if unit.is_empty() => Ok(number),
        Some("" | "1") if dimension == Dimension::Scalar => Ok(number),
        Some(unit) if dimension == Dimension::Length => Ok(lengths.converted(number, length_unit(unit)?)),
        _ => Err(format!(
            "`{}` is not the speed of this input: write `{number}` or `{number}{}`, per second",
            text.trim(),
            if dimension == Dimension::Length { "mm/s" } else { "/s" }
        )),
    }
}

/// A time in seconds.
pub(crate) fn time(text: &str) -> Result<f64, String> {
    let (number, unit) = split(text)?;
    let seconds = match unit {
        "s" | "" => number,
        "ms" => number / 1e3,
        "min" => number * 60.0,
        _ => return Err(format!("`{unit}` is not a unit of time; write `s`, `ms` or `min`")),
    };
    if seconds > 0.0 {
        Ok(seconds)
    } else {
        Err(format!("a time is positive, and `{}` is not", text.trim()))
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::*;

    #[test]
    fn units_are_converted() {
        let mut lengths = Lengths::default();
        assert_eq!(quantity(Dimension::Angle, "180deg", &mut lengths), Ok(PI));
        assert_eq!(quantity(Dimension::Angle, " -0.5 turn ", &mut lengths), Ok(-PI));
        assert_eq!(quantity(Dimension::Length, "45mm", &mut lengths), Ok(45.0));
        assert_eq!(quantity(Dimension::Length, "1e-1m", &mut lengths), Ok(100.0));
        assert_eq!(quantity(Dimension::Length, "7", &mut lengths), Ok(7.0));
        assert_eq!(lengths.name(), "mm");
        assert_eq!(range(Dimension::Angle, "0..360deg", &mut lengths), Ok((0.0, TAU)));
        assert_eq!(
            range(Dimension::Angle, "-90..=90deg", &mut lengths),
            Ok((-PI / 2.0, PI / 2.0))
        );
        assert_eq!(speed(Dimension::Angle, "1500rpm", &mut lengths), Ok(50.0 * PI));
        assert_eq!(speed(Dimension::Length, "0.2 m/s", &mut lengths), Ok(200.0));
        assert_eq!(time("400ms"), Ok(0.4));
    }

    #[test]
    fn mistakes_say_what_to_write() {
        let mut lengths = Lengths::default();
        for (dimension, text, word) in [
            (Dimension::Angle, "30", "write `30deg` or `30rad`"),
            (Dimension::Angle, "30mm", "write `deg`, `rad` or `turn`"),
            (Dimension::Length, "30deg", "write `mm`"),
            (Dimension::Scalar, "2mm", "write `2`, without `mm`"),
            (Dimension::Length, "long", "does not begin with a number"),
            (Dimension::Length, "inf", "does not begin with a number"),
            (Dimension::Length, "1e400", "too large"),
            (Dimension::Length, "45,5", "write `45.5` with a point"),
            (Dimension::Angle, "45,5deg", "write `45.5deg` with a point"),
        ] {
            let message = quantity(dimension, text, &mut lengths).unwrap_err();
            assert!(message.contains(word), "{message}");
        }
        assert!(
            range(Dimension::Angle, "90deg", &mut lengths)
                .unwrap_err()
                .contains("`0..360deg`")
        );
        assert!(
            speed(Dimension::Angle, "10", &mut lengths)
                .unwrap_err()
                .contains("`10rpm`")
        );
    }
}
