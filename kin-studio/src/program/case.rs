//! What is asked of a mechanism: its dimensions, how its inputs move, and its assembly.

use kin_core::any::{Description, Quantity};
use kin_core::{Dimension, assembly_named};

use super::fault::{Fault, listed, similar};
use super::motion::{InputMotion, LawName, checked};
use super::subject::{Subject, Wanted};
use super::value::{self, Lengths};

/// What was typed, before it is compared with the mechanism.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Typed {
    /// Names of dimensions or of inputs that stand, with their values.
    pub(crate) set: Vec<String>,
    /// Ranges of inputs, with a name in front if there are several inputs.
    pub(crate) over: Vec<String>,
    /// The speed.
    pub(crate) speed: Option<String>,
    /// The name of the motion law.
    pub(crate) law: Option<String>,
    /// The time that the motion law takes.
    pub(crate) time: Option<String>,
    /// The assembly.
    pub(crate) assembly: Option<String>,
    /// The unit of lengths.
    pub(crate) units: Option<String>,
    /// Whether angles are shown in radians.
    pub(crate) radians: bool,
}

/// What is asked of a mechanism.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Case {
    /// A value for each scalar parameter.
    pub(crate) parameters: Vec<f64>,
    /// A motion for each input.
    pub(crate) motions: Vec<InputMotion>,
    /// The input that the others follow: the first one that moves.
    pub(crate) lead: usize,
    /// The assembly.
    pub(crate) assembly: Wanted,
    /// The name of the unit of length, empty if there is none.
    pub(crate) length: &'static str,
    /// Whether angles are shown in degrees.
    pub(crate) in_degrees: bool,
}

/// The values that are known before anything moves.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Known {
    /// A value for each scalar parameter.
    pub(crate) parameters: Vec<f64>,
    /// The inputs that stand, and the first values of those that move.
    pub(crate) inputs: Vec<Option<f64>>,
    /// The name of the unit of length, empty if there is none.
    pub(crate) length: &'static str,
}

impl Typed {
    /// Whether a range of an input was typed.
    pub(crate) fn has_range(&self) -> bool {
        !self.over.is_empty()
    }

    /// Compares what was typed with a mechanism.
    pub(crate) fn case(&self, subject: &Subject) -> Result<Case, Fault> {
        let case = self.compared(subject, None)?;
        // the option is for the leading input, and says nothing of the others
        if self.speed.is_none() {
            case.check_pace(subject.description().inputs)?;
        }
        Ok(case)
    }

    /// The same where no input must move. A leading input without a range and without a value stands at `otherwise`.
    pub(crate) fn case_without_range(&self, subject: &Subject, otherwise: f64) -> Result<Case, Fault> {
        self.compared(subject, Some(otherwise))
    }

    /// The values alone.
    pub(crate) fn known(&self, subject: &Subject) -> Result<Known, Fault> {
        let mut lengths = self.lengths()?;
        let (parameters, standing) = self.values(subject, &mut lengths)?;
        self.assembly(subject, &mut lengths)?;
        let motions = self.said(subject, &standing, &mut lengths)?;
        Ok(Known {
            parameters,
            inputs: motions
                .iter()
                .map(|motion| motion.as_ref().map(InputMotion::start))
                .collect(),
            length: lengths.name(),
        })
    }

    fn compared(&self, subject: &Subject, otherwise: Option<f64>) -> Result<Case, Fault> {
        let mut lengths = self.lengths()?;
        let (parameters, standing) = self.values(subject, &mut lengths)?;
        let assembly = self.assembly(subject, &mut lengths)?;
        let said = self.said(subject, &standing, &mut lengths)?;
        let lead = leading(&said);
        Ok(Case {
            parameters,
            motions: self.motions(subject, said, otherwise, &mut lengths)?,
            lead,
            assembly,
            length: lengths.name(),
            in_degrees: !self.radians,
        })
    }

    fn lengths(&self) -> Result<Lengths, Fault> {
        match &self.units {
            Some(name) => Lengths::named(name).map_err(Fault::Wrong),
            None => Ok(Lengths::default()),
        }
    }

    /// Remarks on lengths that no link has. An offset may be negative, so they are not refused.
    pub(crate) fn remarks(&self, subject: &Subject) -> Vec<String> {
        let example = subject.example();
        let Ok((values, _)) = self.values(subject, &mut Lengths::default()) else {
            return Vec::new();
        };
        let description = subject.description();
        let quantities = description.parameters.iter().zip(values).enumerate();
        let remarks = quantities.filter_map(|(index, (quantity, value))| {
            let usual = example.as_ref().map_or(1.0, |example| example.parameters[index]);
            let is_link = quantity.dimension == Dimension::Length && !quantity.name.contains('.') && usual > 0.0;
            let name = quantity.name;
            match value {
                _ if !is_link => None,
                0.0 => Some(format!(
                    "`{name}` is zero: a link of this length joins its pins into one"
                )),
                value if value < 0.0 => Some(format!(
                    "`{name}` is negative: a link of this length points half a turn away from its angle; an offset \
                     lies on the other side"
                )),
                _ => None,
            }
        });
        remarks.collect()
    }

    /// A value for each dimension.
    pub(crate) fn dimensions(&self, subject: &Subject) -> Result<Vec<f64>, Fault> {
        Ok(self.values(subject, &mut Lengths::default())?.0)
    }

    /// The dimensions, and the inputs that stand.
    fn values(&self, subject: &Subject, lengths: &mut Lengths) -> Result<(Vec<f64>, Vec<Option<f64>>), Fault> {
        let description = subject.description();
        let example = subject.example();
        let mut parameters: Vec<Option<f64>> = match &example {
            Some(example) => example.parameters.iter().copied().map(Some).collect(),
            None => vec![None; description.parameters.len()],
        };
        let mut standing = vec![None; description.inputs.len()];
        for text in &self.set {
            let Some((name, value)) = text.split_once('=') else {
                return Err(Fault::wrong(format!(
                    "`{text}` is not a name with a value, as in `--set {text}=30`"
                )));
            };
            if value.contains('=') {
                return Err(several(text));
            }
            for (name, value) in parts(name.trim(), value.trim())? {
                let (quantity, place) = match place_of(description.parameters, &name) {
                    Some(index) => (description.parameters[index], &mut parameters[index]),
                    None => match place_of(description.inputs, &name) {
                        Some(index) => (description.inputs[index], &mut standing[index]),
                        None => return Err(no_dimension(description, &name)),
                    },
                };
                let value = value::quantity(quantity.dimension, value, lengths)
                    .map_err(|message| Fault::wrong(format!("{name}: {message}")))?;
                *place = Some(value);
            }
        }
        let missing: Vec<&str> = description
            .parameters
            .iter()
            .zip(&parameters)
            .filter_map(|(quantity, value)| value.is_none().then_some(quantity.name))
            .collect();
        if let Some(first) = missing.first() {
            return Err(Fault::wrong(format!(
                "{} {} no value: write `--set {first}=…`",
                listed(&missing),
                if missing.len() == 1 { "has" } else { "have" }
            )));
        }
        Ok((parameters.into_iter().flatten().collect(), standing))
    }

    fn assembly(&self, subject: &Subject, lengths: &mut Lengths) -> Result<Wanted, Fault> {
        let names = subject.assemblies();
        let Some(text) = &self.assembly else {
            return match (subject.example(), names.as_slice()) {
                (Some(example), _) => Ok(example.assembly.clone()),
                (None, []) => Ok(Wanted::Unknown),
                (None, _) => Ok(Wanted::Named(0)),
            };
        };
        if let Some(index) = assembly_named(&names, text) {
            return Ok(Wanted::Named(index));
        }
        if text.contains('=') && (names.is_empty() || text.contains(|letter: char| letter.is_ascii_digit())) {
            return near(subject, text, lengths);
        }
        if names.is_empty() {
            let example: Vec<String> = subject
                .description()
                .unknowns
                .iter()
                .map(|unknown| format!("{}=…", unknown.name))
                .collect();
            return Err(Fault::wrong(format!(
                "the positions of this mechanism have no names: give values of its unknowns near the one you mean, as \
                 in `--assembly {}`",
                example.join(",")
            )));
        }
        if names.iter().all(String::is_empty) {
            return Err(Fault::wrong(
                "this mechanism has one assembly only: leave `--assembly` out",
            ));
        }
        Err(Fault::wrong(format!(
            "there is no assembly `{text}`; {}",
            similar(text, names.iter().map(String::as_str))
        )))
    }

    /// The motions that were typed.
    fn said(
        &self,
        subject: &Subject,
        standing: &[Option<f64>],
        lengths: &mut Lengths,
    ) -> Result<Vec<Option<InputMotion>>, Fault> {
        let inputs = subject.description().inputs;
        let mut motions: Vec<Option<InputMotion>> =
            standing.iter().map(|value| value.map(InputMotion::Stands)).collect();
        for text in &self.over {
            if let Some(index) = place_of(inputs, text.trim()) {
                let Quantity { name, dimension, .. } = inputs[index];
                let range = if dimension == Dimension::Angle {
                    "0..360deg"
                } else {
                    "10..60"
                };
                return Err(Fault::wrong(format!(
                    "`{name}` has no range: write `--over {name}={range}`"
                )));
            }
            let (index, text) = match text.split_once('=').filter(|(name, _)| !name.contains('.')) {
                Some((name, text)) => {
                    let index = place_of(inputs, name.trim()).ok_or_else(|| {
                        let names = inputs.iter().map(|input| input.name);
                        Fault::wrong(format!("there is no input `{}`; {}", name.trim(), similar(name, names)))
                    })?;
                    (index, text)
                }
                None if inputs.len() == 1 => (0, text.as_str()),
                None => {
                    let first = inputs.first().map_or("", |input| input.name);
                    return Err(Fault::wrong(format!(
                        "there are {} inputs: say which one moves, as in `--over {first}={text}`",
                        inputs.len()
                    )));
                }
            };
            let motion = InputMotion::read(inputs[index].dimension, text, lengths)
                .map_err(|message| Fault::wrong(format!("{}: {message}", inputs[index].name)))?;
            motions[index] = Some(motion);
        }
        Ok(motions)
    }

    /// A motion for each input. The leading one moves if none was said to.
    fn motions(
        &self,
        subject: &Subject,
        mut motions: Vec<Option<InputMotion>>,
        otherwise: Option<f64>,
        lengths: &mut Lengths,
    ) -> Result<Vec<InputMotion>, Fault> {
        let inputs = subject.description().inputs;
        let example = subject.example();
        if !motions.iter().flatten().any(InputMotion::moves) {
            let lead = leading(&motions);
            let own = motions[lead].or(example
                .as_ref()
                .map(|example| InputMotion::Stands(example.inputs[lead])));
            motions[lead] = Some(match (default_range(subject, lead, motions[lead]), otherwise) {
                (Err(_), Some(value)) => own.unwrap_or(InputMotion::Stands(value)),
                (range, _) => range?,
            });
        }
        let mut whole = Vec::new();
        for (index, motion) in motions.into_iter().enumerate() {
            let stands = || {
                example
                    .as_ref()
                    .map(|example| InputMotion::Stands(example.inputs[index]))
            };
            let motion = motion.or_else(stands).ok_or_else(|| {
                let name = inputs[index].name;
                Fault::wrong(format!(
                    "the input `{name}` has no value: write `--set {name}=…`, or `--over {name}=…` if it moves"
                ))
            })?;
            whole.push(self.driven(motion, &inputs[index], lengths)?);
        }
        Ok(whole)
    }

    /// The motion with the speed, or under the law, of the other options.
    fn driven(&self, motion: InputMotion, input: &Quantity<'_>, lengths: &mut Lengths) -> Result<InputMotion, Fault> {
        let InputMotion::Moves { from, to, speed } = motion else {
            return self.unchanged(motion, input.name);
        };
        let at = |message| Fault::wrong(format!("{}: {message}", input.name));
        if let Some(law) = &self.law {
            let Some(time) = &self.time else {
                return Err(Fault::wrong(format!(
                    "a law takes a time: write `--law {law} --time 0.4s`"
                )));
            };
            return Ok(InputMotion::Rises {
                from,
                to,
                law: LawName::named(law).map_err(at)?,
                time: value::time(time).map_err(at)?,
            });
        }
        let typed = self
            .speed
            .as_ref()
            .map(|speed| value::speed(input.dimension, speed, lengths).and_then(checked))
            .transpose()
            .map_err(at)?;
        let by_time = self
            .time
            .as_ref()
            .map(|time| value::time(time))
            .transpose()
            .map_err(at)?;
        Ok(InputMotion::Moves {
            from,
            to,
            speed: typed.or(by_time.map(|time| (to - from).abs() / time)).or(speed),
        })
    }

    /// A motion that the options for a speed or a law do not change. They are refused beside a law, since they would
    /// not be read.
    fn unchanged(&self, motion: InputMotion, name: &str) -> Result<InputMotion, Fault> {
        let options = [("--speed", &self.speed), ("--law", &self.law), ("--time", &self.time)];
        let unread = options
            .into_iter()
            .find_map(|(option, text)| text.as_ref().map(|_| option));
        match unread {
            Some(option) if motion.moves() => Err(Fault::wrong(format!(
                "`{name}` has a law already, behind `by`, which `{option}` does not change: leave `{option}` out, or \
                 write another motion, as in `--over '{name}=…'`"
            ))),
            _ => Ok(motion),
        }
    }
}

impl Case {
    /// Without laws the leading input alone has a speed. One of another input is refused, unless both take the same
    /// time.
    fn check_pace(&self, inputs: &[Quantity<'_>]) -> Result<(), Fault> {
        if self.time_of_laws().is_some() {
            return Ok(());
        }
        let time = self.motions[self.lead].duration();
        let is_unread = |own: f64| time.is_none_or(|time| (own - time).abs() > 1e-9 * time);
        let unread = self
            .motions
            .iter()
            .position(|motion| motion.duration().is_some_and(is_unread));
        let Some(index) = unread else { return Ok(()) };
        let (lead, own) = (inputs[self.lead].name, inputs[index].name);
        Err(Fault::wrong(format!(
            "`{own}` moves together with `{lead}`, whose speed alone is read: leave the speed of `{own}` out, or write \
             `by constant-speed in 0.4s` in its place"
        )))
    }

    /// The time of the motion, if an input moves under a law.
    pub(crate) fn time_of_laws(&self) -> Option<f64> {
        let has_law = |motion: &InputMotion| matches!(motion, InputMotion::Rises { .. });
        let durations = || self.motions.iter().filter_map(InputMotion::duration);
        self.motions
            .iter()
            .any(has_law)
            .then(|| durations().fold(0.0, f64::max))
    }

    /// The speed of the leading input, without its sign.
    pub(crate) fn speed(&self) -> f64 {
        match self.motions.get(self.lead) {
            Some(InputMotion::Moves { speed: Some(speed), .. }) => *speed,
            _ => 1.0,
        }
    }

    /// The inputs at the beginning and at the end.
    pub(crate) fn ends(&self) -> [Vec<f64>; 2] {
        [InputMotion::start, InputMotion::end].map(|end| self.motions.iter().map(end).collect())
    }
}

/// The first input that was said to move; otherwise the first of which nothing was said.
fn leading(said: &[Option<InputMotion>]) -> usize {
    let moving = said
        .iter()
        .position(|motion| motion.as_ref().is_some_and(InputMotion::moves));
    moving.or_else(|| said.iter().position(Option::is_none)).unwrap_or(0)
}

/// The range of an input of which nothing is said: a turn.
fn default_range(subject: &Subject, index: usize, said: Option<InputMotion>) -> Result<InputMotion, Fault> {
    let input = &subject.description().inputs[index];
    if input.dimension != Dimension::Angle {
        return Err(Fault::wrong(format!(
            "the input `{}` is no angle, so it has no full turn: give its range, as in `--over {0}=10..60`",
            input.name
        )));
    }
    let start = match (said, subject.example()) {
        (Some(motion), _) => motion.start(),
        (None, Some(example)) if subject.assemblies().is_empty() => example.inputs[index],
        _ => 0.0,
    };
    Ok(InputMotion::Moves {
        from: start,
        to: start + std::f64::consts::TAU,
        speed: None,
    })
}

/// Several dimensions behind one `--set`.
fn several(text: &str) -> Fault {
    let mut parts: Vec<String> = Vec::new();
    for part in text.split(',') {
        match parts.last_mut() {
            // the coordinates of a point
            Some(last) if !part.contains('=') => last.extend([",", part]),
            _ => parts.push(part.trim().to_owned()),
        }
    }
    let quoted = |part: &String| {
        if part.contains('(') {
            format!("'{part}'")
        } else {
            part.clone()
        }
    };
    let options: Vec<String> = parts.iter().map(|part| format!("--set {}", quoted(part))).collect();
    Fault::wrong(format!(
        "`{text}` has several dimensions: write `--set` in front of each, as in `{}`",
        options.join(" ")
    ))
}

/// The names of coordinates.
const AXES: [&str; 3] = ["x", "y", "z"];

/// A value, or the coordinates of a point, as in `(1.4, 1.5)`.
fn parts<'v>(name: &str, value: &'v str) -> Result<Vec<(String, &'v str)>, Fault> {
    let Some(inner) = value.strip_prefix('(') else {
        return Ok(vec![(name.to_owned(), value)]);
    };
    let Some(inner) = inner.strip_suffix(')') else {
        return Err(Fault::wrong(format!("`{value}` has no closing parenthesis")));
    };
    let count = inner.split(',').count();
    if count > AXES.len() {
        return Err(Fault::wrong(format!(
            "`{value}` has {count} coordinates: write the two or three of the point, as in `{name}=(1.4, 1.5)`"
        )));
    }
    Ok(AXES
        .into_iter()
        .zip(inner.split(','))
        .map(|(part, value)| (format!("{name}.{part}"), value.trim()))
        .collect())
}

fn place_of(quantities: &[Quantity<'_>], name: &str) -> Option<usize> {
    quantities.iter().position(|quantity| quantity.name == name)
}

fn no_dimension(description: &Description<'_>, name: &str) -> Fault {
    let point = format!("{name}.x");
    if place_of(description.parameters, &point).is_some() {
        return Fault::wrong(format!(
            "`{name}` is a point: write `{name}=(1.4, 1.5)`, or `{name}.x=1.4`"
        ));
    }
    let names = description
        .parameters
        .iter()
        .chain(description.inputs)
        .map(|one| one.name);
    Fault::wrong(format!(
        "there is no dimension and no input `{name}`; {}",
        similar(name, names)
    ))
}

/// Values of all unknowns near a position.
fn near(subject: &Subject, text: &str, lengths: &mut Lengths) -> Result<Wanted, Fault> {
    let unknowns = subject.description().unknowns;
    let mut values = vec![None; unknowns.len()];
    for part in text.split(',').map(str::trim).filter(|part| !part.is_empty()) {
        let Some((name, value)) = part.split_once('=') else {
            return Err(Fault::wrong(format!(
                "`{part}` is not an unknown with a value near its own"
            )));
        };
        let name = name.trim();
        let Some(index) = place_of(unknowns, name) else {
            return Err(Fault::wrong(format!(
                "there is no unknown `{name}`; {}",
                similar(name, unknowns.iter().map(|unknown| unknown.name))
            )));
        };
        let value = value::quantity(unknowns[index].dimension, value, lengths)
            .map_err(|message| Fault::wrong(format!("{name}: {message}")))?;
        values[index] = Some(value);
    }
    let missing: Vec<&str> = unknowns
        .iter()
        .zip(&values)
        .filter_map(|(unknown, value)| value.is_none().then_some(unknown.name))
        .collect();
    if missing.is_empty() {
        Ok(Wanted::Near(values.into_iter().flatten().collect()))
    } else {
        Err(Fault::wrong(format!(
            "the assembly gives no value near {}",
            listed(&missing)
        )))
    }
}

#[cfg(test)]
mod tests {
    use super::super::subject::Subject;
    use super::*;
    use kin_core::library::{FiveBar, Pantograph};

    fn typed(set: &[&str], over: &[&str]) -> Typed {
        let owned = |texts: &[&str]| texts.iter().map(|&text| text.to_owned()).collect();
        Typed {
            set: owned(set),
            over: owned(over),
            ..Typed::default()
        }
    }

    const FIVE: [&str; 5] = ["ground=2", "left=2", "left_rod=3", "right_rod=3", "right=2"];

    /// A length has no range of its own, so that a motion must be given where one is needed.
    #[test]
    fn a_range_is_asked_for_where_it_is_needed() {
        let subject = Subject::of::<Pantograph>();
        let set = typed(&["upper=3", "lower=3", "factor=2", "y=-1.5"], &[]);
        assert!(set.case(&subject).is_err());
        let case = set.case_without_range(&subject, 2.5).unwrap();
        assert_eq!(case.lead, 0);
        assert_eq!(case.motions, [2.5, -1.5].map(InputMotion::Stands));
    }

    /// The speed of a second input is either that of the first one or refused.
    #[test]
    fn speeds_that_are_not_read_are_refused() {
        let subject = Subject::of::<FiveBar>();
        let lead = "alpha=0..90deg at 60rpm";
        for (second, is_read) in [
            ("beta=0..45deg at 30rpm", true),
            ("beta=0..45deg", true),
            ("beta=0..45deg by cycloidal in 0.4s", true),
            ("beta=0..45deg at 60rpm", false),
        ] {
            let case = typed(&FIVE, &[lead, second]).case(&subject);
            assert_eq!(case.is_ok(), is_read, "{second}");
        }
        let case = typed(&FIVE, &["alpha=0..90deg", "beta=0..45deg at 60rpm"]).case(&subject);
        assert!(case.is_err());
    }

    #[test]
    fn lengths_that_no_link_has_are_told() {
        let subject = Subject::of::<FiveBar>();
        let mut set = FIVE;
        assert!(typed(&set, &[]).remarks(&subject).is_empty());
        set[1] = "left=-2";
        set[3] = "right_rod=0";
        let remarks = typed(&set, &[]).remarks(&subject);
        assert!(
            remarks[0].contains("`left` is negative") && remarks[1].contains("`right_rod` is zero"),
            "{remarks:?}"
        );
        // coordinates and plain numbers are what they are
        let subject = Subject::of::<Pantograph>();
        let set = typed(&["upper=3", "lower=3", "factor=-2"], &[]);
        assert!(set.remarks(&subject).is_empty());
    }

    #[test]
    fn options_beside_a_law_are_refused() {
        let subject = Subject::of::<FiveBar>();
        let own = || typed(&FIVE, &["alpha=0..90deg by cycloidal in 1s", "beta=50deg"]);
        assert!(own().case(&subject).is_ok());
        let text = || Some("1s".to_owned());
        for other in [
            Typed { time: text(), ..own() },
            Typed { speed: text(), ..own() },
            Typed { law: text(), ..own() },
        ] {
            let fault = other.case(&subject).unwrap_err();
            assert!(fault.to_string().contains("--over 'alpha=…'"), "{fault}");
        }
    }
}
