//! The loads of a file: `mass tip = 2kg;`.

use std::ops::Range;

use kin_core::Dimension;
use kin_core::any::Description;
use kin_core::linkage::AnyLinkage;
use kin_core::load::NamedLoads;
use kin_core::reaction::{NamedReactions, ReactionError};

use super::super::fault::{listed, similar};
use super::super::loads::{Centre, End, InSi, JointFriction, Load, Loads};
use super::super::units::{self, Kind};
use super::super::value::{self, Lengths};
use super::joints::{behind_of, is_of_joint};
use crate::file::{Entry, Mistake, Part};
use crate::forces::{StatedContact, StatedPlace};

/// The words with which a load begins.
const KINDS: [&str; 13] = [
    "gravity", "mass", "inertia", "force", "torque", "spring", "damper", "friction", "hinge", "gears", "rack", "drive",
    "sense",
];

/// The loads, and what is wrong in them.
pub(super) fn read<'j>(
    entries: &[Entry],
    names: NamedLoads,
    (linkage, joints, is_space): (&AnyLinkage<'j>, Result<NamedReactions<'j>, ReactionError>, bool),
    description: &Description<'_>,
    section: Option<Range<usize>>,
    lengths: &mut Lengths,
) -> (Loads, Vec<Mistake>) {
    let (mut loads, mut mistakes) = (Loads::default(), Vec::new());
    let (reactions, no_joints) = match joints {
        Ok(reactions) => (Some(reactions), None),
        Err(error) => (None, Some(error)),
    };
    let mut reader = Reader {
        names,
        linkage,
        reactions,
        is_space,
        description,
        lengths,
    };
    let mut is_reported = false;
    for entry in entries {
        if let (Some(error), true) = (&no_joints, is_of_joint(entry)) {
            if !is_reported {
                let message = format!("friction, hinges, gears and racks are those of joints: {error}");
                mistakes.push(entry.head.mistake(message));
            }
            is_reported = true;
            continue;
        }
        let gravity = loads.gravity.is_some();
        match reader.load(entry) {
            Ok(Read::Gravity(_)) if gravity => mistakes.push(entry.head.mistake("gravity has two values")),
            Ok(Read::Gravity(acceleration)) => loads.gravity = Some(acceleration),
            Ok(Read::Load(load)) => loads.all.push(load),
            Ok(Read::Friction(name, _)) if loads.frictions.iter().any(|(own, _)| *own == name) => {
                mistakes.push(entry.head.mistake(format!("`{name}` has friction already")));
            }
            Ok(Read::Friction(name, friction)) => loads.frictions.push((name, friction)),
            Ok(Read::Hinge(name, axis)) => loads.hinges.push((name, axis)),
            Ok(Read::Contact(contact)) => loads.contacts.push(contact),
            Ok(Read::Drive(input, _)) if loads.drives.iter().any(|(own, _)| *own == input) => {
                mistakes.push(entry.head.mistake(format!("the drive of `{input}` has a body already")));
            }
            Ok(Read::Drive(input, body)) => loads.drives.push((input, body)),
            Ok(Read::Sense(input, _)) if loads.senses.iter().any(|(own, _)| *own == input) => {
                mistakes.push(entry.head.mistake(format!("the sense of `{input}` is given already")));
            }
            Ok(Read::Sense(input, sense)) => loads.senses.push((input, sense)),
            Err(mistake) => mistakes.push(mistake),
        }
    }
    let mut parameters = description.parameters.iter();
    let length = parameters.find(|quantity| quantity.dimension == Dimension::Length);
    if let (Some(length), Some(section), None, [_, ..]) = (length, section, reader.lengths.unit, entries) {
        let message = format!(
            "loads need the unit of the lengths: write one of them with its unit, as in `{} = 45mm;`",
            length.name
        );
        mistakes.push(Mistake::new(message, section));
    }
    (loads, mistakes)
}

const TENSOR: &str = "a body of space has its centre in its frame, and three moments of inertia, or six with the \
                      entries xy, xz and yz of the tensor: write `2kg at (30mm, 0, 5mm), inertia (0.02kgm2, 0.03kgm2, \
                      0.04kgm2)`";

/// Whether a mass is that of a body which there is not.
pub(super) fn lack_a_body(entries: &[Entry], bodies: &[String]) -> bool {
    let is_one =
        |entry: &Entry| entry.begins_with("mass") && behind_of(entry).is_some_and(|body| !bodies.contains(&body.text));
    entries.iter().any(is_one)
}

/// What an entry says.
pub(super) enum Read {
    Gravity([InSi; 3]),
    Load(Load),
    Hinge(String, StatedPlace),
    Contact(StatedContact),
    Friction(String, JointFriction),
    Drive(String, String),
    Sense(String, f64),
}

/// What a load acts on.
enum Target {
    Point(String),
    Fixed([InSi; 3]),
    Angle(String),
    Distance(String),
}

pub(super) struct Reader<'r, 'd, 'j> {
    /// The names of points, angles and bodies.
    pub(super) names: NamedLoads,
    /// Any linkage of the mechanism, and the joints that are known of it.
    pub(super) linkage: &'r AnyLinkage<'j>,
    pub(super) reactions: Option<NamedReactions<'j>>,
    pub(super) is_space: bool,
    pub(super) description: &'r Description<'d>,
    pub(super) lengths: &'r mut Lengths,
}

impl Reader<'_, '_, '_> {
    fn load(&mut self, entry: &Entry) -> Result<Read, Mistake> {
        let first = entry.words.first().unwrap_or(&entry.head);
        let kind = &first.text;
        let Some(kind) = KINDS.into_iter().find(|own| own == kind) else {
            let message = match similar(kind, KINDS) {
                advice if advice.starts_with("did") => format!("there is no load `{kind}`; {advice}"),
                _ => format!(
                    "a load begins with its kind, as in `mass tip = 2kg;`; there are {}",
                    listed(&KINDS)
                ),
            };
            return Err(first.mistake(message));
        };
        if kind == "mass" && entry.words.get(1).is_some_and(|word| word.text == "of") {
            return self.mass_of(entry).map(Read::Load);
        }
        if kind == "friction" {
            return self.friction_of(entry);
        }
        if kind == "hinge" {
            return self.hinge_of(entry);
        }
        if kind == "gears" || kind == "rack" {
            return self.contact(entry);
        }
        if kind == "drive" {
            return self.drive_of(entry);
        }
        if kind == "sense" {
            return self.sense_of(entry);
        }
        let targets = self.targets_of(entry)?;
        let value = &entry.value;
        let load = match (kind, targets.as_slice()) {
            ("gravity", []) => return vector(units::ACCELERATION, value).map(Read::Gravity),
            ("mass", [Target::Point(point)]) => Load::Mass(size(units::MASS, value)?, point.clone()),
            ("inertia", [Target::Angle(angle)]) => Load::Inertia(size(units::INERTIA, value)?, angle.clone()),
            ("force", [Target::Point(point)]) => Load::Force(vector(units::FORCE, value)?, point.clone()),
            ("force", [Target::Distance(distance)]) => Load::Torque(number(units::FORCE, value)?, distance.clone()),
            ("torque", [Target::Angle(angle)]) => Load::Torque(number(units::TORQUE, value)?, angle.clone()),
            ("spring", [Target::Angle(angle)]) => {
                let (stiffness, rest) = self.spring(units::TORSION_STIFFNESS, units::ANGLE, value)?;
                Load::TorsionSpring(stiffness, rest, angle.clone())
            }
            ("spring", [Target::Distance(distance)]) => {
                let (stiffness, rest) = self.spring(units::STIFFNESS, units::LENGTH, value)?;
                Load::TorsionSpring(stiffness, rest, distance.clone())
            }
            ("damper", [Target::Angle(angle)]) => {
                Load::TorsionDamper(number(units::TORSION_DAMPING, value)?, angle.clone())
            }
            ("damper", [Target::Distance(distance)]) => {
                Load::TorsionDamper(number(units::DAMPING, value)?, distance.clone())
            }
            ("spring" | "damper", [from, to]) => {
                let (Some(from), Some(to)) = (end(from), end(to)) else {
                    return Err(entry
                        .head
                        .mistake(format!("a {kind} is between two points, or on one angle")));
                };
                let ends = [from, to];
                if kind == "damper" {
                    Load::Damper(number(units::DAMPING, value)?, ends)
                } else {
                    let (stiffness, rest) = self.spring(units::STIFFNESS, units::LENGTH, value)?;
                    Load::Spring(stiffness, rest, ends)
                }
            }
            _ => return Err(entry.head.mistake(self.advice(kind))),
        };
        Ok(Read::Load(load))
    }

    /// How a load of a kind is written.
    fn advice(&self, kind: &str) -> String {
        let angles = |dimension: Dimension| {
            let names = self.names.angles().into_iter();
            names
                .map(str::to_owned)
                .find(|name| self.dimension(name) == Some(dimension))
        };
        let angle = angles(Dimension::Angle).unwrap_or_else(|| "psi".to_owned());
        let point = self
            .names
            .points()
            .first()
            .map_or_else(|| "tip".to_owned(), |&name| name.to_owned());
        match kind {
            "gravity" => "gravity is written as `gravity = (0, -9.81m/s2);`".to_owned(),
            "mass" => match self.names.bodies().first() {
                Some(body) => format!(
                    "a mass is at a point, or that of a body: write `mass {point} = 2kg;` or `mass of {body} = 2kg \
                     at (30mm, 0), inertia 0.02kgm2;`"
                ),
                None => format!("a mass is at a point: write `mass {point} = 2kg;`"),
            },
            "inertia" => format!("a moment of inertia is with an angle: write `inertia {angle} = 0.02kgm2;`"),
            "force" => match angles(Dimension::Length) {
                Some(distance) => format!(
                    "a force is at a point or along a distance: write `force {point} = (0, -10N);` or `force \
                     {distance} = 10N;`"
                ),
                None => format!("a force is at a point: write `force {point} = (0, -10N);`"),
            },
            "torque" => format!("a torque is on an angle: write `torque {angle} = 3Nm;`"),
            "spring" => format!(
                "a spring is between two points, or on an angle: write `spring {point} to (0, 200mm) = 900N/m, rest \
                 150mm;` or `spring {angle} = 12Nm/rad, rest 30deg;`"
            ),
            _ => format!(
                "a damper is between two points, or on an angle: write `damper {point} to (0, 200mm) = 5Ns/m;` or \
                 `damper {angle} = 0.1Nms/rad;`"
            ),
        }
    }

    /// The input behind `of`, or how the whole is written.
    fn input_of(&self, entry: &Entry, form: &str) -> Result<String, Mistake> {
        let inputs = self.description.inputs;
        let word = behind_of(entry).ok_or_else(|| entry.head.mistake(form))?;
        let name = &word.text;
        if inputs.iter().any(|own| own.name == name) {
            return Ok(name.clone());
        }
        let advice = similar(name, inputs.iter().map(|own| own.name));
        Err(word.mistake(format!("there is no input `{name}`; {advice}")))
    }

    /// `drive of theta = crank`.
    fn drive_of(&self, entry: &Entry) -> Result<Read, Mistake> {
        let bodies = self.names.bodies();
        let (input, body) = (self.description.inputs.first(), bodies.first());
        let [input, body] = [
            input.map_or("theta", |input| input.name),
            body.copied().unwrap_or("crank"),
        ];
        let form = format!("a drive turns or pushes a body: write `drive of {input} = {body};`");
        let input = self.input_of(entry, &form)?;
        let body = entry.value.text.trim().to_owned();
        if bodies.contains(&body.as_str()) {
            return Ok(Read::Drive(input, body));
        }
        let advice = match bodies.as_slice() {
            [] => "bodies are declared, as in `body crank: 0, pin;`".to_owned(),
            bodies => similar(&body, bodies.iter().copied()),
        };
        Err(entry.value.mistake(format!("there is no body `{body}`; {advice}")))
    }

    /// `sense of theta = forwards`.
    fn sense_of(&self, entry: &Entry) -> Result<Read, Mistake> {
        let input = self.description.inputs.first().map_or("theta", |input| input.name);
        let form = format!(
            "where all inputs rest, friction opposes the motion that is about to begin: write `sense of {input} = \
             forwards;` or `backwards`"
        );
        let input = self.input_of(entry, &form)?;
        match entry.value.text.trim() {
            "forwards" => Ok(Read::Sense(input, 1.0)),
            "backwards" => Ok(Read::Sense(input, -1.0)),
            _ => Err(entry.value.mistake(form)),
        }
    }

    /// `mass of rod = 2kg at (30mm, 0), inertia 0.02kgm2`.
    fn mass_of(&mut self, entry: &Entry) -> Result<Load, Mistake> {
        let form = "the mass of a body has a centre and an inertia: write `2kg at (30mm, 0), inertia 0.02kgm2`, or a \
                    point of the body behind `at`";
        let word = behind_of(entry).ok_or_else(|| entry.head.mistake(self.advice("mass")))?;
        let body = word.text.clone();
        if !self.names.bodies().contains(&body.as_str()) {
            let message = match self.names.bodies().as_slice() {
                [] => format!("there is no body `{body}`; bodies are declared, as in `body {body}: 0, pin;`"),
                bodies => format!("there is no body `{body}`; {}", similar(&body, bodies.iter().copied())),
            };
            return Err(word.mistake(message));
        }
        let parts = entry.value.parts();
        let (mass, inertia) = match parts.as_slice() {
            [mass] => (mass, None),
            [mass, inertia] => (
                mass,
                Some(inertia.behind("inertia ").ok_or_else(|| inertia.mistake(form))?),
            ),
            _ => return Err(entry.value.mistake(form)),
        };
        let (mass, centre) = mass.around(" at ").ok_or_else(|| mass.mistake(form))?;
        let zero = InSi::new(units::LENGTH, 0.0);
        let centre_point = if self.names.points().contains(&centre.text.as_str()) {
            Centre::Named(centre.text.clone())
        } else {
            let parts = centre.coordinates().unwrap_or_default();
            let own = parts.iter().map(|part| self.at_rest(units::LENGTH, part));
            match *own.collect::<Result<Vec<_>, _>>()? {
                [x, y] => Centre::InBody([x, y, zero]),
                [x, y, z] => Centre::InBody([x, y, z]),
                _ => return Err(centre.mistake(form)),
            }
        };
        let mass = size(units::MASS, &mass)?;
        let none = InSi::new(units::INERTIA, 0.0);
        let Some(inertia) = inertia else {
            return Ok(Load::Body(body, mass, centre_point, none));
        };
        let Some(tensor) = inertia.coordinates() else {
            return Ok(Load::Body(body, mass, centre_point, size(units::INERTIA, &inertia)?));
        };
        let tensor = tensor.iter().enumerate().map(|(index, part)| match index {
            0..3 => size(units::INERTIA, part),
            // products of inertia have any sign
            _ => number(units::INERTIA, part),
        });
        let tensor = match *tensor.collect::<Result<Vec<_>, _>>()? {
            [xx, yy, zz] => [xx, yy, zz, none, none, none],
            [xx, yy, zz, xy, xz, yz] => [xx, yy, zz, xy, xz, yz],
            _ => return Err(inertia.mistake(TENSOR)),
        };
        match centre_point {
            Centre::InBody(centre) => Ok(Load::Solid(body, mass, centre, tensor)),
            Centre::Named(_) => Err(centre.mistake(TENSOR)),
        }
    }

    /// The dimension of a quantity that moves.
    fn dimension(&self, name: &str) -> Option<Dimension> {
        let Description {
            inputs,
            unknowns,
            outputs,
            ..
        } = self.description;
        let mut all = inputs.iter().chain(*unknowns).chain(*outputs);
        all.find(|quantity| quantity.name == name)
            .map(|quantity| quantity.dimension)
    }

    /// The targets behind the first word, with `to` between them.
    fn targets_of(&mut self, entry: &Entry) -> Result<Vec<Target>, Mistake> {
        let Some(words) = entry.words.get(1..).filter(|words| !words.is_empty()) else {
            return Ok(Vec::new());
        };
        let start = entry.head.range.start;
        let mut targets = Vec::new();
        for words in words.split(|word| word.text == "to") {
            let (Some(first), Some(last)) = (words.first(), words.last()) else {
                return Err(entry.head.mistake("a point is missing beside `to`"));
            };
            let range = first.range.start..last.range.end;
            let text = entry.head.text[range.start - start..range.end - start].to_owned();
            targets.push(self.target(&Part { text, range })?);
        }
        Ok(targets)
    }

    fn target(&mut self, part: &Part) -> Result<Target, Mistake> {
        if part.text.starts_with('(') {
            return self.fixed(part).map(Target::Fixed);
        }
        let name = part.text.clone();
        if self.names.points().contains(&name.as_str()) {
            return Ok(Target::Point(name));
        }
        match self.dimension(&name) {
            Some(Dimension::Angle) => Ok(Target::Angle(name)),
            Some(Dimension::Length) if !name.contains('.') => Ok(Target::Distance(name)),
            Some(Dimension::Length) => {
                let point = name.split('.').next().unwrap_or("");
                Err(part.mistake(format!("loads act on the whole point: write `{point}`")))
            }
            Some(Dimension::Scalar) => Err(part.mistake(format!("`{name}` is a plain number, on which no load acts"))),
            None if self.names.bodies().contains(&name.as_str()) => Err(part.mistake(format!(
                "`{name}` is a body: write `mass of {name} = 2kg at (30mm, 0), inertia 0.02kgm2;`, or name a point"
            ))),
            None => {
                let (points, angles) = (self.names.points(), self.names.angles());
                let advice = similar(&name, points.iter().chain(&angles).copied());
                let more = if points.is_empty() {
                    "; points are declared, as in `output tip: Point = ..;`"
                } else {
                    ""
                };
                Err(part.mistake(format!("there is no point and no angle `{name}`; {advice}{more}")))
            }
        }
    }

    /// A point of the ground.
    pub(super) fn fixed(&mut self, part: &Part) -> Result<[InSi; 3], Mistake> {
        let mut point = [InSi::new(units::LENGTH, 0.0); 3];
        let parts = part.coordinates().filter(|parts| (2..=3).contains(&parts.len()));
        let parts = parts.ok_or_else(|| part.mistake("a point of the ground is written as `(0, 200mm)`"))?;
        for (coordinate, part) in point.iter_mut().zip(parts) {
            *coordinate = self.at_rest(units::LENGTH, &part)?;
        }
        Ok(point)
    }

    /// A length or an angle.
    pub(super) fn at_rest(&mut self, kind: Kind, part: &Part) -> Result<InSi, Mistake> {
        let is_length = kind == units::LENGTH;
        let dimension = if is_length { Dimension::Length } else { Dimension::Angle };
        let value = value::quantity(dimension, &part.text, self.lengths).map_err(|message| part.mistake(message))?;
        let metres = if is_length { self.lengths.metres() } else { 1.0 };
        Ok(InSi::new(kind, value * metres))
    }

    /// A stiffness, and what it is at rest, which is zero if it is not given.
    fn spring(&mut self, kind: Kind, at_rest: Kind, part: &Part) -> Result<(InSi, InSi), Mistake> {
        let parts = part.parts();
        let example = if at_rest == units::ANGLE { "30deg" } else { "150mm" };
        match parts.as_slice() {
            [stiffness] => Ok((number(kind, stiffness)?, InSi::new(at_rest, 0.0))),
            [stiffness, rest] => {
                let value = rest.behind("rest ").ok_or_else(|| {
                    rest.mistake(format!("behind the stiffness comes the rest: write `rest {example}`"))
                })?;
                Ok((number(kind, stiffness)?, self.at_rest(at_rest, &value)?))
            }
            _ => Err(part.mistake(format!(
                "a spring has a stiffness and a rest: write `{}{}, rest {example}`",
                900, kind.units[0].name
            ))),
        }
    }
}

fn number(kind: Kind, part: &Part) -> Result<InSi, Mistake> {
    let value = value::in_si(kind, &part.text).map_err(|message| part.mistake(message))?;
    Ok(InSi::new(kind, value))
}

/// A mass or a moment of inertia.
fn size(kind: Kind, part: &Part) -> Result<InSi, Mistake> {
    if part.text.starts_with('-') {
        return Err(part.mistake(format!(
            "{} is not negative: a hole is part of its link, whose mass and centre are those of the whole",
            kind.name
        )));
    }
    number(kind, part)
}

fn vector(kind: Kind, part: &Part) -> Result<[InSi; 3], Mistake> {
    let parts = part.coordinates().filter(|parts| (2..=3).contains(&parts.len()));
    let parts = parts.ok_or_else(|| {
        let name = kind.units[0].name;
        part.mistake(format!("{} has a direction: write `(0, -10{name})`", kind.name))
    })?;
    let mut vector = [InSi::new(kind, 0.0); 3];
    for (coordinate, part) in vector.iter_mut().zip(parts) {
        *coordinate = number(kind, &part)?;
    }
    Ok(vector)
}

fn end(target: &Target) -> Option<End> {
    match target {
        Target::Point(name) => Some(End::Named(name.clone())),
        Target::Fixed(point) => Some(End::Fixed(*point)),
        Target::Angle(_) | Target::Distance(_) => None,
    }
}
