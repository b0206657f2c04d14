//! How an input moves, as people type it: `30deg`, `0..360deg at 60rpm`, `0..90deg by cycloidal in 0.4s`.

use kin_core::Dimension;
use kin_core::law::{ConstantSpeed, Dwell, LawError, Piecewise, Rise, Scca, Shape};

use super::fault::similar;
use super::value::{self, Lengths};

/// The motion of one input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum InputMotion {
    /// It stands.
    Stands(f64),
    /// It moves from one value to another, at a speed if one was given.
    Moves {
        /// The first value.
        from: f64,
        /// The last value.
        to: f64,
        /// The speed by second, without its sign.
        speed: Option<f64>,
    },
    /// It moves from rest to rest.
    Rises {
        /// The first value.
        from: f64,
        /// The last value.
        to: f64,
        /// The law.
        law: LawName,
        /// The time in seconds.
        time: f64,
    },
}

/// A motion law from rest to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LawName(Shape);

/// The laws by their names. The first name of a shape is the one that help and messages use.
fn laws() -> [(&'static str, Shape); 8] {
    [
        ("constant-speed", Shape::ConstantSpeed),
        ("simple-harmonic", Shape::SimpleHarmonic),
        ("cycloidal", Shape::Cycloidal),
        ("3-4-5", Shape::Polynomial345),
        ("4-5-6-7", Shape::Polynomial4567),
        ("5-6-7-8-9", Shape::Polynomial56789),
        ("modified-sine", Shape::ModifiedSine),
        ("modified-trapezoid", Shape::ModifiedTrapezoid),
    ]
}

impl LawName {
    /// The law of a name. Underscores are as good as hyphens.
    pub(crate) fn named(name: &str) -> Result<Self, String> {
        let shares = name
            .trim()
            .strip_prefix("scca(")
            .and_then(|rest| rest.strip_suffix(')'));
        if let Some(shares) = shares {
            return with_shares(shares);
        }
        let plain = name.trim().replace(['_', ' '], "-").to_lowercase();
        let plain = plain.strip_prefix("polynomial-").unwrap_or(&plain);
        let bare = |name: &str| name.replace('-', "");
        laws()
            .into_iter()
            .find(|(own, _)| bare(own) == bare(plain))
            .map(|(_, shape)| Self(shape))
            .ok_or_else(|| {
                let names = laws().map(|(name, _)| name);
                format!("there is no motion law `{}`; {}", name.trim(), similar(plain, names))
            })
    }
}

/// The law of the SCCA family with these shares.
fn with_shares(text: &str) -> Result<LawName, String> {
    let shares: Result<Vec<f64>, _> = text.split(',').map(|share| share.trim().parse()).collect();
    let Ok(&[sine, constant, cosine]) = shares.as_deref() else {
        return Err(format!(
            "`scca({text})` takes three shares of the time, as in `scca(0.25, 0, 0.75)`"
        ));
    };
    let law = Scca::new(sine, constant, cosine).map_err(|error| error.to_string())?;
    Ok(LawName(Shape::Scca(law)))
}

impl InputMotion {
    /// Reads a motion.
    pub(crate) fn read(dimension: Dimension, text: &str, lengths: &mut Lengths) -> Result<Self, String> {
        let text = text.trim();
        if !text.contains("..") {
            if let Some(message) = other_range(dimension, text) {
                return Err(message);
            }
            if text.contains(" at ") || text.contains(" by ") {
                return Err(format!(
                    "`{text}` has a speed or a law, and no range: write it as in `0..360deg at 60rpm`"
                ));
            }
            return value::quantity(dimension, text, lengths).map(Self::Stands);
        }
        if let Some(message) = bare_speed(text) {
            return Err(message);
        }
        if let Some((range, law)) = text.split_once(" by ") {
            let (from, to) = value::range(dimension, range, lengths)?;
            let Some((law, time)) = law.split_once(" in ") else {
                return Err(format!(
                    "a law takes a time: write `{} by {} in 0.4s`",
                    range.trim(),
                    law.trim()
                ));
            };
            return Ok(Self::Rises {
                from,
                to,
                law: LawName::named(law)?,
                time: value::time(time)?,
            });
        }
        let (range, speed) = match text.split_once(" at ") {
            Some((range, speed)) => (range, Some(speed)),
            None => (text, None),
        };
        let (from, to) = value::range(dimension, range, lengths)?;
        let speed = speed.map(|speed| value::speed(dimension, speed, lengths)).transpose()?;
        Ok(Self::Moves {
            from,
            to,
            speed: speed.map(checked).transpose()?,
        })
    }

    /// Its first value.
    pub(crate) fn start(&self) -> f64 {
        match *self {
            Self::Stands(value) => value,
            Self::Moves { from, .. } | Self::Rises { from, .. } => from,
        }
    }

    /// Its last value.
    pub(crate) fn end(&self) -> f64 {
        match *self {
            Self::Stands(value) => value,
            Self::Moves { to, .. } | Self::Rises { to, .. } => to,
        }
    }

    /// Whether it moves.
    pub(crate) fn moves(&self) -> bool {
        !matches!(self, Self::Stands(_))
    }

    /// The time that it takes, in seconds, if that is known.
    pub(crate) fn duration(&self) -> Option<f64> {
        match *self {
            Self::Stands(_) | Self::Moves { speed: None, .. } => None,
            Self::Moves {
                from,
                to,
                speed: Some(speed),
            } => Some((to - from).abs() / speed),
            Self::Rises { time, .. } => Some(time),
        }
    }

    /// The motion as a law over a time. What takes less time rests at its end.
    pub(crate) fn law(&self, duration: f64) -> Result<Box<dyn Piecewise<f64>>, LawError> {
        Ok(match *self {
            Self::Stands(value) => Box::new(Dwell::new(value, duration)?),
            Self::Moves { from, to, .. } => {
                let own = self.duration().unwrap_or(duration);
                Box::new(ConstantSpeed::new(from, (to - from) / own, own)?)
            }
            Self::Rises { from, to, law, time } => Box::new(Rise::new(law.0, from, to, time)?),
        })
    }
}

/// The message for a range as other programs write it: `0-360`, `0:360:10`, `0 to 360`.
fn other_range(dimension: Dimension, text: &str) -> Option<String> {
    let (from, behind) = value::split(text).ok()?;
    let behind = match behind.strip_prefix("to ") {
        Some(_) => behind,
        None => behind.trim_start_matches(char::is_alphabetic).trim_start(),
    };
    let signs = ["-", ":", "–", "—", "…", "to "];
    let rest = signs.into_iter().find_map(|sign| behind.strip_prefix(sign))?;
    let (to, unit) = value::split(rest).ok()?;
    let has_step = unit.starts_with(':');
    let unit: String = unit
        .chars()
        .take_while(|letter| letter.is_alphabetic() || *letter == '°')
        .collect();
    let unit = match dimension {
        Dimension::Angle if unit.is_empty() => "deg",
        _ => unit.as_str(),
    };
    let rows = if has_step {
        ", and `--rows` says how many rows there are"
    } else {
        ""
    };
    Some(format!(
        "`{text}` is no range: a range has two dots, as in `{from}..{to}{unit}`{rows}"
    ))
}

/// The message for a speed without `at`: `0..360deg 45rpm`.
fn bare_speed(text: &str) -> Option<String> {
    let (_, end) = text.split_once("..")?;
    let (_, unit) = value::split(end.strip_prefix('=').unwrap_or(end)).ok()?;
    let (unit, speed) = unit.split_once(char::is_whitespace)?;
    let speed = speed.trim();
    let begins = speed.starts_with(|letter: char| letter.is_ascii_digit());
    let range = text.strip_suffix(speed)?.trim();
    (begins && !unit.is_empty()).then(|| format!("`{text}` has a speed without `at`: write `{range} at {speed}`"))
}

/// A speed without its sign: the range tells the direction.
pub(crate) fn checked(speed: f64) -> Result<f64, String> {
    if speed > 0.0 {
        Ok(speed)
    } else {
        Err("a speed is positive: the range tells the direction, as in `360..0deg`".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn motions_are_read() {
        let read = |text| InputMotion::read(Dimension::Angle, text, &mut Lengths::default());
        assert_eq!(read("1rad"), Ok(InputMotion::Stands(1.0)));
        let turn = read("0..2rad at 4rad/s").unwrap();
        assert_eq!((turn.start(), turn.end(), turn.duration()), (0.0, 2.0, Some(0.5)));
        let servo = read("0 .. 90deg by modified_sine in 400ms").unwrap();
        assert_eq!(servo.duration(), Some(0.4));
        for name in ["3-4-5", "polynomial_345", "345", "Modified Sine", "scca(0.2, 0, 0.6)"] {
            assert!(LawName::named(name).is_ok(), "{name}");
        }
    }

    #[test]
    fn mistakes_say_what_to_write() {
        let read = |text| InputMotion::read(Dimension::Angle, text, &mut Lengths::default()).unwrap_err();
        assert!(read("0..90deg by cyclodial in 1s").contains("did you mean `cycloidal`?"));
        assert!(read("0..90deg by cycloidal").contains("in 0.4s"));
        assert!(read("90deg at 60rpm").contains("`0..360deg at 60rpm`"));
        assert!(read("0..90deg at -60rpm").contains("`360..0deg`"));
        for (text, advice) in [
            ("0-360", "`0..360deg`"),
            ("-10deg - 20deg", "`-10..20deg`"),
            ("0:360:10", "`0..360deg`, and `--rows`"),
            ("0:360", "`0..360deg`"),
            ("0 to 2rad", "`0..2rad`"),
            ("0..360deg 45rpm", "write `0..360deg at 45rpm`"),
            ("0deg..=360deg  45 rpm", "write `0deg..=360deg at 45 rpm`"),
        ] {
            assert!(read(text).contains(advice), "{text}: {}", read(text));
        }
        assert_eq!(
            InputMotion::read(Dimension::Angle, "-1e-3rad", &mut Lengths::default()),
            Ok(InputMotion::Stands(-1e-3))
        );
    }
}
