//! The case to be solved: the dimensions of a mechanism, the motions of its inputs, and its assembly.

use kin_core::Dimension;
use kin_core::any::{Description, Quantity};
use kin_core::load::NamedLoads;

use super::assembly;
use super::fault::{Fault, listed, similar};
use super::loads::{ForceColumns, Loads};
use super::motion::{InputMotion, LawName, Step, checked};
use super::subject::{Subject, Wanted};
use super::text::Units;
use super::value::{self, Lengths};
use crate::forces::Stated;

/// The case as it was typed, before it is compared with the mechanism.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Typed {
    /// Names of dimensions or of inputs that stand, with their values.
    pub(crate) set: Vec<String>,
    /// The number of these values that a file states. The others are options.
    pub(crate) set_by_file: usize,
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
    /// The loads.
    pub(crate) loads: Loads,
}

/// The case to be solved.
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
    /// The loads, none if nothing was said of them.
    pub(crate) loads: Option<NamedLoads>,
    /// The friction in joints.
    pub(crate) stated: Stated,
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

    /// The case as it was typed, with each of its assemblies alone, and the name of each assembly.
    pub(crate) fn each_assembly(&self, subject: &Subject) -> Vec<(String, Self)> {
        let names = self
            .assembly
            .as_deref()
            .map(|text| assembly::each(text, &subject.assemblies()));
        let names = names.unwrap_or_default().into_iter();
        let alone = names.map(|name| {
            let assembly = Some(name.clone());
            (
                name,
                Self {
                    assembly,
                    ..self.clone()
                },
            )
        });
        let all: Vec<_> = alone.collect();
        if all.is_empty() {
            return vec![(String::new(), self.clone())];
        }
        all
    }

    /// The case as it was typed, with the first of its assemblies: for commands that answer for all assemblies or for
    /// none.
    pub(crate) fn first_assembly(&self, subject: &Subject) -> Self {
        let first = self.each_assembly(subject).into_iter().next();
        first.map_or_else(|| self.clone(), |(_, typed)| typed)
    }

    /// Compares the typed case with a mechanism.
    pub(crate) fn case(&self, subject: &Subject) -> Result<Case, Fault> {
        self.compared(subject, None)
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
            loads: self
                .loads
                .named(subject.description(), &subject.outline(), lengths.metres())?,
            stated: self.loads.stated(lengths.metres()),
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

    /// Remarks on lengths that no link has, each behind the name of its dimension. An offset may be negative, so they
    /// are not refused.
    pub(crate) fn remarks(&self, subject: &Subject) -> Vec<(String, String)> {
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
            let remark = match value {
                _ if !is_link => None,
                0.0 => Some(format!(
                    "`{name}` is zero: a link of this length joins its pins into one"
                )),
                value if value < 0.0 => Some(format!(
                    "`{name}` is negative: a link of this length points half a turn away from its angle; an offset \
                     lies on the other side"
                )),
                _ => None,
            };
            remark.map(|remark| (name.to_owned(), remark))
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
                let (quantity, slot) = match index_of(description.parameters, &name) {
                    Some(index) => (description.parameters[index], &mut parameters[index]),
                    None => match index_of(description.inputs, &name) {
                        Some(index) => (description.inputs[index], &mut standing[index]),
                        None => return Err(no_dimension(description, &name)),
                    },
                };
                let value = value::quantity(quantity.dimension, value, lengths)
                    .map_err(|message| Fault::wrong(format!("{name}: {message}")))?;
                *slot = Some(value);
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
        match (&self.assembly, subject.example(), names.as_slice()) {
            (Some(text), ..) => {
                if let [first, _, ..] = assembly::each(text, &names).as_slice() {
                    return Err(Fault::wrong(format!(
                        "there are several assemblies, and this is done in one: write `--assembly {first}`"
                    )));
                }
                assembly::wanted(&names, subject.description().unknowns, text, lengths).map_err(Fault::Wrong)
            }
            (None, Some(example), _) => Ok(example.assembly.clone()),
            (None, None, []) => Ok(Wanted::Unknown),
            (None, None, _) => Ok(Wanted::Named(0)),
        }
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
            if let Some(index) = index_of(inputs, text.trim()) {
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
                    let index = index_of(inputs, name.trim()).ok_or_else(|| {
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
            if let Some(option) = self.value_by_option(inputs[index].name) {
                return Err(Fault::wrong(format!(
                    "`{}` has a motion, so `--set {option}` would not be read: `--over {option}` lets it stand there",
                    inputs[index].name
                )));
            }
            motions[index] = Some(motion);
        }
        Ok(motions)
    }

    /// The option that gives a value to an input.
    fn value_by_option(&self, input: &str) -> Option<&str> {
        let mut options = self.set.iter().skip(self.set_by_file);
        let option = options.find(|text| text.split_once('=').is_some_and(|(name, _)| name.trim() == input));
        option.map(String::as_str)
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
            let said = motions[lead].take();
            let range = default_range(subject, lead, said.as_ref());
            let stated = example.map(|example| InputMotion::Stands(example.inputs[lead]));
            motions[lead] = Some(match (range, otherwise) {
                (Err(_), Some(value)) => said.or(stated).unwrap_or(InputMotion::Stands(value)),
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
            whole.push(motion);
        }
        let lead = whole.iter().position(InputMotion::moves);
        for (index, motion) in whole.iter_mut().enumerate() {
            *motion = self.driven(motion, &inputs[index], lead == Some(index), lengths)?;
        }
        Ok(whole)
    }

    /// The motion with the speed, or under the law, of the other options. The speed is that of the leading input, which
    /// the others follow.
    fn driven(
        &self,
        motion: &InputMotion,
        input: &Quantity<'_>,
        is_lead: bool,
        lengths: &mut Lengths,
    ) -> Result<InputMotion, Fault> {
        let &InputMotion::Moves { from, to, speed } = motion else {
            return self.unchanged(motion, input.name);
        };
        let at = |message| Fault::wrong(format!("{}: {message}", input.name));
        if let Some(law) = &self.law {
            let Some(time) = &self.time else {
                return Err(Fault::wrong(format!(
                    "a law takes a time: write `--law {law} --time 0.4s`"
                )));
            };
            let (law, time) = (LawName::named(law).map_err(at)?, value::time(time).map_err(at)?);
            return Ok(InputMotion::Runs(vec![Step::under_law(from, to, law, time)]));
        }
        if self.speed.is_some() && !is_lead {
            let speed = None;
            return Ok(InputMotion::Moves { from, to, speed });
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
    fn unchanged(&self, motion: &InputMotion, name: &str) -> Result<InputMotion, Fault> {
        let options = [("--speed", &self.speed), ("--law", &self.law), ("--time", &self.time)];
        let unread = options
            .into_iter()
            .find_map(|(option, text)| text.as_ref().map(|_| option));
        match unread {
            Some(option) if motion.moves() => Err(Fault::wrong(format!(
                "`{name}` has a law already, behind `by`, which `{option}` does not change: leave `{option}` out, or \
                 write another motion, as in `--over '{name}=…'`"
            ))),
            _ => Ok(motion.clone()),
        }
    }
}

impl Case {
    /// The time of the motion, if an input moves under a law, or if inputs with speeds take different times.
    pub(crate) fn time_of_laws(&self) -> Option<f64> {
        let times: Vec<f64> = self.motions.iter().filter_map(InputMotion::duration).collect();
        let longest = times.iter().copied().fold(0.0, f64::max);
        let has_law = self.motions.iter().any(|motion| matches!(motion, InputMotion::Runs(_)));
        let is_uneven = times.iter().any(|time| longest - time > 1e-9 * longest);
        (has_law || is_uneven).then_some(longest)
    }

    /// The speed of the leading input, without its sign. An input without a speed takes the time of the other inputs.
    pub(crate) fn speed(&self) -> f64 {
        let Some(InputMotion::Moves { from, to, speed }) = self.motions.get(self.lead) else {
            return 1.0;
        };
        let time = || self.motions.iter().find_map(InputMotion::duration);
        speed
            .or_else(|| time().map(|time| (to - from).abs() / time))
            .unwrap_or(1.0)
    }

    /// The forces that the loads cause.
    pub(crate) fn forces(&self, subject: &Subject) -> ForceColumns {
        self.loads
            .as_ref()
            .map_or_else(ForceColumns::default, |_| subject.forces(&self.stated))
    }

    /// The units in which values are shown.
    pub(crate) fn units(&self) -> Units {
        Units {
            in_degrees: self.in_degrees,
            length: self.length,
        }
    }

    /// The metres of the unit of length.
    pub(crate) fn metres(&self) -> f64 {
        Lengths::named(self.length).map_or(1.0, |lengths| lengths.metres())
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

/// The range of an input of which nothing is said: a revolution.
fn default_range(subject: &Subject, index: usize, said: Option<&InputMotion>) -> Result<InputMotion, Fault> {
    let input = &subject.description().inputs[index];
    if input.dimension != Dimension::Angle {
        return Err(Fault::wrong(format!(
            "the input `{}` is no angle, so it has no full revolution: give its range, as in `--over {0}=10..60`",
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

fn index_of(quantities: &[Quantity<'_>], name: &str) -> Option<usize> {
    quantities.iter().position(|quantity| quantity.name == name)
}

fn no_dimension(description: &Description<'_>, name: &str) -> Fault {
    let point = format!("{name}.x");
    if index_of(description.parameters, &point).is_some() {
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

    /// A length has no usual range, so that a motion must be given where one is needed.
    #[test]
    fn a_range_is_asked_for_where_it_is_needed() {
        let subject = Subject::of::<Pantograph>();
        let set = typed(&["upper=3", "lower=3", "factor=2", "y=-1.5"], &[]);
        assert!(set.case(&subject).is_err());
        let case = set.case_without_range(&subject, 2.5).unwrap();
        assert_eq!(case.lead, 0);
        assert_eq!(case.motions, [2.5, -1.5].map(InputMotion::Stands));
    }

    /// Inputs whose speeds take the same time move along a line, and others by the time.
    #[test]
    fn each_input_may_have_a_speed() {
        let subject = Subject::of::<FiveBar>();
        for (first, second, time, speed) in [
            ("alpha=0..90deg at 60rpm", "beta=0..45deg at 30rpm", None, 60.0),
            ("alpha=0..90deg at 60rpm", "beta=0..45deg", None, 60.0),
            ("alpha=0..90deg", "beta=0..45deg at 60rpm", None, 120.0),
            (
                "alpha=0..90deg at 60rpm",
                "beta=0..45deg by cycloidal in 0.4s",
                Some(0.4),
                60.0,
            ),
            ("alpha=0..90deg at 60rpm", "beta=0..45deg at 15rpm", Some(0.5), 60.0),
        ] {
            let case = typed(&FIVE, &[first, second]).case(&subject).unwrap();
            let close = |one: f64, other: f64| (one - other).abs() < 1e-12;
            assert!(
                close(case.time_of_laws().unwrap_or(0.0), time.unwrap_or(0.0)),
                "{second}"
            );
            assert!(close(case.speed(), kin_core::rpm(speed)), "{second}");
        }
        // the option is that of the first input, which the other follows
        let speed = Some("60rpm".to_owned());
        let both = typed(&FIVE, &["alpha=0..90deg", "beta=0..45deg at 60rpm"]);
        let case = Typed { speed, ..both }.case(&subject).unwrap();
        assert_eq!(case.time_of_laws(), None);
    }

    #[test]
    fn remarks_on_lengths_that_no_link_has() {
        let subject = Subject::of::<FiveBar>();
        let mut set = FIVE;
        assert!(typed(&set, &[]).remarks(&subject).is_empty());
        set[1] = "left=-2";
        set[3] = "right_rod=0";
        let remarks = typed(&set, &[]).remarks(&subject);
        assert!(
            remarks[0].1.contains("`left` is negative") && remarks[1].1.contains("`right_rod` is zero"),
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
        let under_law = || typed(&FIVE, &["alpha=0..90deg by cycloidal in 1s", "beta=50deg"]);
        assert!(under_law().case(&subject).is_ok());
        let text = || Some("1s".to_owned());
        for other in [
            Typed {
                time: text(),
                ..under_law()
            },
            Typed {
                speed: text(),
                ..under_law()
            },
            Typed {
                law: text(),
                ..under_law()
            },
        ] {
            let fault = other.case(&subject).unwrap_err();
            assert!(fault.to_string().contains("--over 'alpha=…'"), "{fault}");
        }
    }
}
