//! The motion of an input, as people type it: `30deg`, `0..360deg at 60rpm`, `0..90deg by cycloidal in 0.4s, rest
//! 0.1s`.

use std::ops::Range;

use kin_core::Dimension;
use kin_core::law::{ConstantSpeed, Dwell, LawError, Piecewise, Rise, Scca, Sequence, Shape};

use super::fault::similar;
use super::text::Units;
use super::value::{self, Lengths};
use crate::file::parts;

/// The motion of one input.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum InputMotion {
    /// The input stands.
    Stands(f64),
    /// The input moves from one value to another, at a speed if one was given.
    Moves {
        /// The first value.
        from: f64,
        /// The last value.
        to: f64,
        /// The speed by second, without its sign.
        speed: Option<f64>,
    },
    /// The input moves under laws, one after the other.
    Runs(Vec<Step>),
}

/// A part of a motion, which takes a known time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Step {
    /// The first value.
    from: f64,
    /// The last value.
    to: f64,
    /// The law; none at constant speed, and at rest.
    law: Option<LawName>,
    /// The time in seconds.
    time: f64,
}

impl Step {
    /// A motion from rest to rest.
    pub(crate) fn under_law(from: f64, to: f64, law: LawName, time: f64) -> Self {
        Self {
            from,
            to,
            law: Some(law),
            time,
        }
    }

    fn law(self) -> Result<Box<dyn Piecewise<f64>>, LawError> {
        let Self { from, to, law, time } = self;
        Ok(match law {
            Some(LawName(shape)) => Box::new(Rise::new(shape, from, to, time)?),
            None if from == to => Box::new(Dwell::new(from, time)?),
            None => Box::new(ConstantSpeed::new(from, (to - from) / time, time)?),
        })
    }
}

/// The mistake in a motion, and the bytes of its text that are at fault.
pub(crate) type WrongPart = (String, Range<usize>);

/// A motion law from rest to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LawName(Shape);

/// The laws by their names. Help and messages use the first name of a shape.
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
            .find(|(known, _)| bare(known) == bare(plain))
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
        Self::read_parts(dimension, text, lengths).map_err(|(message, _)| message)
    }

    /// Reads a motion. The mistakes in its parts have their positions.
    pub(crate) fn read_parts(dimension: Dimension, text: &str, lengths: &mut Lengths) -> Result<Self, WrongPart> {
        let parts = parts(text);
        let [_, _, ..] = parts.as_slice() else {
            return Self::read_one(dimension, text, lengths).map_err(|message| (message, 0..text.len()));
        };
        let mut steps: Vec<Step> = Vec::new();
        // rests before the first value is known
        let mut waits: Vec<f64> = Vec::new();
        for range in parts {
            let at = |message| (message, range.clone());
            let part = &text[range.clone()];
            let end = steps.last().map(|step| step.to);
            if let Some(time) = rest(part) {
                let time = value::time(time).map_err(at)?;
                match end {
                    None => waits.push(time),
                    Some(value) => steps.push(Step::at_rest(value, time)),
                }
                continue;
            }
            let step = Step::read(dimension, part, lengths).map_err(at)?;
            if let Some(end) = end
                && (step.from - end).abs() > 1e-9 * end.abs().max(step.from.abs())
            {
                let units = Units {
                    in_degrees: true,
                    length: lengths.name(),
                };
                let [end, start] = [end, step.from].map(|value| units.text(dimension, 0, value));
                return Err(at(format!(
                    "the motion jumps from {end} to {start}: a part begins where the one before it ends"
                )));
            }
            steps.extend(waits.drain(..).map(|time| Step::at_rest(step.from, time)));
            steps.push(step);
        }
        if steps.is_empty() {
            let message = format!("`{text}` rests only: write the value alone, as in `30deg`");
            return Err((message, 0..text.len()));
        }
        Ok(Self::Runs(steps))
    }

    fn read_one(dimension: Dimension, text: &str, lengths: &mut Lengths) -> Result<Self, String> {
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
            if rest(text).is_some() {
                return Err(format!(
                    "`{text}` says nowhere where it rests: write the value alone, as in `30deg`, or a rest between \
                     motions, as in `0..90deg by cycloidal in 0.4s, rest 0.1s`"
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
            let (law, time) = (LawName::named(law)?, value::time(time)?);
            return Ok(Self::Runs(vec![Step::under_law(from, to, law, time)]));
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

    /// The values at the beginning, between the parts, and at the end.
    pub(crate) fn stations(&self) -> Vec<f64> {
        match self {
            Self::Stands(value) => vec![*value],
            Self::Moves { from, to, .. } => vec![*from, *to],
            Self::Runs(steps) => {
                let first = steps.first().map(|step| step.from);
                first.into_iter().chain(steps.iter().map(|step| step.to)).collect()
            }
        }
    }

    /// Its first value.
    pub(crate) fn start(&self) -> f64 {
        self.stations().first().copied().unwrap_or(f64::NAN)
    }

    /// Its last value.
    pub(crate) fn end(&self) -> f64 {
        self.stations().last().copied().unwrap_or(f64::NAN)
    }

    /// Its lowest and its highest value.
    pub(crate) fn extent(&self) -> (f64, f64) {
        let stations = self.stations();
        let fold = |pick: fn(f64, f64) -> f64| stations.iter().copied().reduce(pick).unwrap_or(f64::NAN);
        (fold(f64::min), fold(f64::max))
    }

    /// Whether it moves.
    pub(crate) fn moves(&self) -> bool {
        !matches!(self, Self::Stands(_))
    }

    /// The time that it takes, in seconds, if that is known.
    pub(crate) fn duration(&self) -> Option<f64> {
        match self {
            Self::Stands(_) | Self::Moves { speed: None, .. } => None,
            Self::Moves {
                from,
                to,
                speed: Some(speed),
            } => Some((to - from).abs() / speed),
            Self::Runs(steps) => Some(steps.iter().map(|step| step.time).sum()),
        }
    }

    /// The motion as a law over a time. A shorter motion rests at its end.
    pub(crate) fn law(&self, duration: f64) -> Result<Box<dyn Piecewise<f64>>, LawError> {
        let alone = |from, to, time| Step {
            from,
            to,
            law: None,
            time,
        };
        match self {
            Self::Stands(value) => alone(*value, *value, duration).law(),
            Self::Moves { from, to, .. } => alone(*from, *to, self.duration().unwrap_or(duration)).law(),
            Self::Runs(steps) => match steps.as_slice() {
                [only] => only.law(),
                steps => {
                    let laws: Result<Vec<_>, _> = steps.iter().map(|step| step.law()).collect();
                    Ok(Box::new(Sequence::of_boxes(laws?)?))
                }
            },
        }
    }
}

impl Step {
    fn at_rest(value: f64, time: f64) -> Self {
        Self {
            from: value,
            to: value,
            law: None,
            time,
        }
    }

    /// A part of a motion, whose time must be known.
    fn read(dimension: Dimension, text: &str, lengths: &mut Lengths) -> Result<Self, String> {
        let example = || {
            format!(
                "a part of a motion takes a time: write `{} by cycloidal in 0.4s`, or a rest, as in `rest 0.1s`",
                text.trim()
            )
        };
        match InputMotion::read_one(dimension, text, lengths)? {
            InputMotion::Runs(steps) => steps.first().copied().ok_or_else(example),
            motion @ InputMotion::Moves { from, to, .. } => {
                let time = motion.duration().ok_or_else(example)?;
                Ok(Self {
                    from,
                    to,
                    law: None,
                    time,
                })
            }
            InputMotion::Stands(_) => Err(format!("`{}` is no range, as in `0..90deg`, and no rest", text.trim())),
        }
    }
}

/// The time of a rest.
fn rest(text: &str) -> Option<&str> {
    text.trim().strip_prefix("rest ")
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

/// The message for a speed without `at`, or a law without `by`: `0..360deg 45rpm`.
fn bare_speed(text: &str) -> Option<String> {
    let (_, end) = text.split_once("..")?;
    let (_, unit) = value::split(end.strip_prefix('=').unwrap_or(end)).ok()?;
    let (unit, speed) = unit.split_once(char::is_whitespace)?;
    let speed = speed.trim();
    let begins = speed.starts_with(|letter: char| letter.is_ascii_digit());
    let range = text.strip_suffix(speed)?.trim();
    // behind a zero without a unit stands the word itself
    if !begins || ["", "at", "by"].contains(&unit) {
        return None;
    }
    Some(if speed.contains(" in ") {
        format!("`{text}` has a law without `by`: write `{range} by {speed}`")
    } else {
        format!("`{text}` has a speed without `at`: write `{range} at {speed}`")
    })
}

/// A speed without its sign: the range gives the direction.
pub(crate) fn checked(speed: f64) -> Result<f64, String> {
    if speed > 0.0 {
        Ok(speed)
    } else {
        Err("a speed is positive: the range gives the direction, as in `360..0deg`".to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn motions_are_read() {
        let read = |text| InputMotion::read(Dimension::Angle, text, &mut Lengths::default());
        assert_eq!(read("1rad"), Ok(InputMotion::Stands(1.0)));
        let motion = read("0..2rad at 4rad/s").unwrap();
        assert_eq!((motion.start(), motion.end(), motion.duration()), (0.0, 2.0, Some(0.5)));
        let servo = read("0 .. 90deg by modified_sine in 400ms").unwrap();
        assert_eq!(servo.duration(), Some(0.4));
        for name in ["3-4-5", "polynomial_345", "345", "Modified Sine", "scca(0.2, 0, 0.6)"] {
            assert!(LawName::named(name).is_ok(), "{name}");
        }
    }

    #[test]
    fn parts_follow_each_other() {
        let read = |text| InputMotion::read_parts(Dimension::Angle, text, &mut Lengths::default());
        let text = "rest 0.1s, 0..90deg by scca(0.2, 0, 0.6) in 0.4s, rest 50ms, 90deg..0 by 4-5-6-7 in 1s";
        let motion = read(text).unwrap();
        let right = 90_f64.to_radians();
        assert_eq!(motion.stations(), [0.0, 0.0, right, right, 0.0]);
        assert_eq!((motion.duration(), motion.extent()), (Some(1.55), (0.0, right)));
        let law = motion.law(2.0).unwrap();
        assert!((law.duration() - 1.55).abs() < 1e-15);
        for (text, part, advice) in [
            (
                "0..90deg by cycloidal in 1s, 80deg..0 by cycloidal in 1s",
                "80deg..0 by cycloidal in 1s",
                "jumps from 90 deg to 80 deg",
            ),
            ("0..90deg, rest 1s", "0..90deg", "`0..90deg by cycloidal in 0.4s`"),
            ("0..90deg at 60rpm, rest 1deg", "rest 1deg", "unit of time"),
            ("0..90deg at 60rpm, 90deg", "90deg", "no rest"),
            ("rest 1s, rest 2s", "rest 1s, rest 2s", "rests only"),
            ("rest 1s", "rest 1s", "the value alone"),
        ] {
            let (message, range) = read(text).unwrap_err();
            assert_eq!(&text[range], part);
            assert!(message.contains(advice), "{text}: {message}");
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
            ("0..90deg 3-4-5 in 1s", "write `0..90deg by 3-4-5 in 1s`"),
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
