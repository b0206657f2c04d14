//! What a file says of joints: `friction of knee = 0.1, radius 12mm;`, hinges of space, gears and racks.

use std::f64::consts::FRAC_PI_2;

use kin_core::reaction::{NamedReactions, ReactionError};
use kin_core::{Dimension, Space};

use super::super::fault::similar;
use super::super::loads::{Joint, JointFriction, JointKind, joints_of, space};
use super::super::units;
use super::super::value;
use super::loads::{Read, Reader};
use crate::file::{Entry, Mistake, Part};
use crate::forces::{StatedContact, StatedPitch, StatedPlace, StatedRadius};

/// The words with which a statement of a joint begins.
const KINDS: [&str; 4] = ["friction", "hinge", "gears", "rack"];

/// Whether an entry states something of a joint.
pub(super) fn is_of_joint(entry: &Entry) -> bool {
    KINDS.iter().any(|kind| entry.begins_with(kind))
}

/// Whether an entry states friction.
pub(super) fn is_friction(entry: &Entry) -> bool {
    entry.begins_with("friction")
}

/// How friction is written.
const FRICTION: &str = "friction is that of a pin or a slide: write `friction of knee = 0.1, radius 12mm;` or \
                        `friction of piston = 0.15;`";

/// How a hinge is written.
const HINGE: &str = "a hinge of space is a joint with an axis, which is a vector of the mechanism or one of the \
                     ground: write `hinge of pivot = axis;` or `hinge of pivot = (0, 0, 1);`";

/// How gears are written.
const GEARS: &str = "gears are two bodies, each with its centre and the radius of its pitch circle: write `gears mesh \
                     = crank at (0, 0) radius 40mm, wheel at pivot radius 50mm, pressure angle 20deg;`, or without \
                     pressure angle";

/// How a rack is written.
const RACK: &str = "a gear or a wheel with its centre and its radius rolls on a body in a direction: write `rack mesh \
                    = pinion at (0, 0) radius 20mm, bar along (1, 0), pressure angle 20deg;`, or without pressure \
                    angle";

/// A pitch circle, or the direction of a rack.
enum Flank {
    Circle((StatedPlace, StatedRadius)),
    Line(StatedPlace),
}

/// The name behind `of`, of an entry that has nothing else.
pub(super) fn behind_of(entry: &Entry) -> Option<&Part> {
    match entry.words.as_slice() {
        [_, of, word] if of.text == "of" && word.is_word() => Some(word),
        _ => None,
    }
}

/// The joint of a name.
fn named<'j>(word: &Part, joints: &'j [Joint]) -> Result<&'j Joint, Mistake> {
    let name = &word.text;
    joints.iter().find(|joint| joint.name == *name).ok_or_else(|| {
        let advice = similar(name, joints.iter().map(|joint| joint.name.as_str()));
        word.mistake(format!("there is no joint `{name}`; {advice}"))
    })
}

impl<'j> Reader<'_, '_, 'j> {
    fn joints(&self) -> Vec<Joint> {
        let reactions = self.reactions.as_ref();
        reactions.map_or_else(Vec::new, |reactions| joints_of(reactions, self.is_space))
    }

    /// `friction of knee = 0.1, radius 12mm`.
    pub(super) fn friction_of(&mut self, entry: &Entry) -> Result<Read, Mistake> {
        let word = behind_of(entry).ok_or_else(|| entry.head.mistake(FRICTION))?;
        let joints = self.joints();
        let joint = named(word, &joints)?;
        let name = joint.name.clone();
        if joint.kind == JointKind::Contact {
            let message = format!("`{name}` rolls, and friction is that of a pin or a slide: leave it out");
            return Err(word.mistake(message));
        }
        let parts = entry.value.parts();
        let Some((first, sizes)) = parts.split_first().filter(|(_, sizes)| sizes.len() < 2) else {
            return Err(entry.value.mistake(FRICTION));
        };
        let coefficient = value::quantity(Dimension::Scalar, &first.text, self.lengths);
        let coefficient = coefficient.map_err(|message| first.mistake(message))?;
        if coefficient < 0.0 {
            return Err(first.mistake(format!(
                "a coefficient of friction is not negative: write `{}`",
                -coefficient
            )));
        }
        let mut size = |word: &str| {
            let Some(value) = sizes.first().and_then(|part| part.behind(word)) else {
                return Ok(None);
            };
            let length = self.at_rest(units::LENGTH, &value)?;
            if length.is_positive() {
                Ok(Some(length))
            } else {
                Err(value.mistake(format!("the {word}is above zero, as in `{word}12mm`")))
            }
        };
        let friction = match (joint.kind == JointKind::Slide, size("radius ")?, size("length ")?) {
            (false, Some(radius), _) => JointFriction::Pin(coefficient, radius),
            (true, _, length) if length.is_none() == sizes.is_empty() => JointFriction::Slide(coefficient, length),
            (false, ..) => {
                let slide = format!("{name}_slide");
                let slide = joints.iter().find(|joint| joint.name == slide);
                let slide = slide.map_or_else(String::new, |slide| format!("; its slide is `{}`", slide.name));
                return Err(entry.value.mistake(format!(
                    "`{name}` is a pin, whose friction needs its radius: write `{}, radius 12mm`{slide}",
                    first.text
                )));
            }
            (true, ..) => {
                return Err(sizes[0].mistake(format!(
                    "`{name}` is a slide: write `{0}`, or `{0}, length 40mm` for a bushing whose \
                     moment rubs too",
                    first.text
                )));
            }
        };
        Ok(Read::Friction(name, friction))
    }

    /// `hinge of pivot = axis`.
    pub(super) fn hinge_of(&mut self, entry: &Entry) -> Result<Read, Mistake> {
        let word = behind_of(entry).ok_or_else(|| entry.head.mistake(HINGE))?;
        let name = named(word, &self.joints())?.name.clone();
        if !self.is_space {
            let no_ball = ReactionError::NoBall { reaction: name };
            return Err(word.mistake(no_ball.to_string()));
        }
        let axis = self.direction(&entry.value, HINGE)?;
        self.join(word, |reactions| Ok(reactions.hinge(&name, axis.own(1.0))?))?;
        Ok(Read::Hinge(name, axis))
    }

    /// `gears mesh = crank at (0, 0) radius 40mm, wheel at pivot radius 50mm, pressure angle 20deg`, or a `rack`.
    pub(super) fn contact(&mut self, entry: &Entry) -> Result<Read, Mistake> {
        let is_rack = entry.begins_with("rack");
        let form = if is_rack { RACK } else { GEARS };
        let [_, word] = entry.words.as_slice() else {
            return Err(entry.head.mistake(form));
        };
        if !word.is_word() {
            return Err(entry.head.mistake(form));
        }
        let parts = entry.value.parts();
        let ([one, other], angle) = match parts.as_slice() {
            [one, other] => ([one, other], None),
            [one, other, angle] => ([one, other], Some(angle)),
            _ => return Err(entry.value.mistake(form)),
        };
        let (first, one) = self.flank(one, form)?;
        let (second, other_flank) = self.flank(other, form)?;
        if first == second {
            return Err(other.mistake(format!(
                "`{first}` does not roll on itself: name another body, or `ground`"
            )));
        }
        let pitch = match (is_rack, one, other_flank) {
            (false, Flank::Circle(one), Flank::Circle(other)) => StatedPitch::Gears([one, other]),
            (true, Flank::Circle(gear), Flank::Line(along)) | (true, Flank::Line(along), Flank::Circle(gear)) => {
                StatedPitch::Rack(gear, along)
            }
            _ => return Err(entry.value.mistake(form)),
        };
        let contact = StatedContact {
            name: word.text.clone(),
            bodies: [first, second],
            pitch,
            pressure_angle: angle.map_or(Ok(0.0), |part| self.pressure_angle(part, form))?,
        };
        let linkage = self.linkage;
        self.join(word, |reactions| contact.added(reactions, linkage, 1.0))?;
        Ok(Read::Contact(contact))
    }

    /// Joins bodies as stated, unless the mechanism cannot have such a joint.
    fn join(
        &mut self,
        word: &Part,
        joined: impl FnOnce(NamedReactions<'j>) -> Result<NamedReactions<'j>, Box<ReactionError>>,
    ) -> Result<(), Mistake> {
        let reactions = self.reactions.clone().map(joined).transpose();
        self.reactions = reactions.map_err(|error| word.mistake(error.to_string()))?;
        Ok(())
    }

    /// A body of a contact, with its pitch circle or the direction of its rack.
    fn flank(&mut self, part: &Part, form: &str) -> Result<(String, Flank), Mistake> {
        if let Some((body, along)) = part.around(" along ") {
            return Ok((self.roller(&body)?, Flank::Line(self.direction(&along, form)?)));
        }
        let circle = part.around(" at ").and_then(|(body, rest)| {
            let (centre, radius) = rest.around(" radius ")?;
            Some((body, centre, radius))
        });
        let (body, centre, radius) = circle.ok_or_else(|| part.mistake(form))?;
        let body = self.roller(&body)?;
        let centre = if centre.text.starts_with('(') {
            StatedPlace::Fixed(space(self.fixed(&centre)?, 1.0))
        } else {
            self.vector(&centre)?
        };
        Ok((body, Flank::Circle((centre, self.radius(&radius)?))))
    }

    /// A body, or the ground.
    fn roller(&self, part: &Part) -> Result<String, Mistake> {
        let outline = self.linkage.outline();
        let bodies = outline.bodies.iter().map(|body| body.name).chain(["ground"]);
        if bodies.clone().any(|body| body == part.text) {
            return Ok(part.text.clone());
        }
        let advice = similar(&part.text, bodies);
        Err(part.mistake(format!("there is no body `{}`; {advice}", part.text)))
    }

    /// A length, or the name of a dimension.
    fn radius(&mut self, part: &Part) -> Result<StatedRadius, Mistake> {
        if part.is_word() {
            let parameters = self.description.parameters.iter();
            let lengths = parameters.filter(|own| own.dimension == Dimension::Length);
            let names: Vec<&str> = lengths.map(|own| own.name).collect();
            if names.contains(&part.text.as_str()) {
                return Ok(StatedRadius::Dimension(part.text.clone()));
            }
            let advice = similar(&part.text, names);
            return Err(part.mistake(format!("there is no length `{}`; {advice}", part.text)));
        }
        let radius = self.at_rest(units::LENGTH, part)?;
        if radius.is_positive() {
            Ok(StatedRadius::Metres(radius.own(1.0)))
        } else {
            Err(part.mistake("the radius is above zero, as in `radius 20mm`"))
        }
    }

    fn pressure_angle(&mut self, part: &Part, form: &str) -> Result<f64, Mistake> {
        let part = part.behind("pressure angle ").ok_or_else(|| part.mistake(form))?;
        let angle = value::quantity(Dimension::Angle, &part.text, self.lengths);
        let angle = angle.map_err(|message| part.mistake(message))?;
        if (0.0..FRAC_PI_2).contains(&angle) {
            Ok(angle)
        } else {
            Err(part.mistake("a pressure angle is at least zero and below a right angle, as in `20deg`"))
        }
    }

    /// A vector of the mechanism, or the coordinates of a direction.
    fn direction(&mut self, part: &Part, form: &str) -> Result<StatedPlace, Mistake> {
        if !part.text.starts_with('(') {
            return self.vector(part);
        }
        let own = part.coordinates().unwrap_or_default();
        let own = own.iter().map(|part| {
            let own = value::quantity(Dimension::Scalar, &part.text, self.lengths);
            own.map_err(|message| part.mistake(message))
        });
        let direction = match (own.collect::<Result<Vec<_>, _>>()?.as_slice(), self.is_space) {
            (&[x, y], false) => Space::new(x, y, 0.0),
            (&[x, y, z], true) => Space::new(x, y, z),
            _ => return Err(part.mistake(form)),
        };
        if direction == Space::zero() {
            return Err(part.mistake("a direction is not zero: write one of any length"));
        }
        Ok(StatedPlace::Fixed(direction))
    }

    /// A point or a vector of the mechanism.
    fn vector(&self, part: &Part) -> Result<StatedPlace, Mistake> {
        let names = self.names.points();
        if names.contains(&part.text.as_str()) {
            return Ok(StatedPlace::Named(part.text.clone()));
        }
        let advice = similar(&part.text, names);
        Err(part.mistake(format!("there is no point and no vector `{}`; {advice}", part.text)))
    }
}
