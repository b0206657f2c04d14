//! The forces that loads cause, and questions to them along a sweep.

use kin_core::Space;
use kin_core::extremes::{AskedQuantity, ExtremeKind, ExtremesError, QuantityAlong, QuantitySource};
use kin_core::linkage::{AnyLinkage, AnySweep};
use kin_core::load::{LoadPoint, NamedLoads};
use kin_core::reaction::{Efficiency, Friction, NamedReactions, ReactionError, ReactionPart, Rolling};
use kin_core::sweep::SmoothDrive;

/// What is stated of joints and drives.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Stated {
    /// The axes of hinges of space, behind the names of their forces.
    pub(crate) hinges: Vec<(String, StatedPlace)>,
    /// The contacts in which bodies roll on each other.
    pub(crate) contacts: Vec<StatedContact>,
    /// The metres of the unit of lengths.
    pub(crate) metres: f64,
    /// The friction of joints, by the names of their forces.
    pub(crate) frictions: Vec<(String, Friction)>,
    /// The bodies that drives turn or push, behind the names of their inputs.
    pub(crate) drives: Vec<(String, String)>,
    /// The signs of the rates with which inputs are about to move where all of them rest.
    pub(crate) senses: Vec<(String, f64)>,
}

/// A point, of coordinates in metres, or a direction of any length.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(not(feature = "case"), expect(dead_code, reason = "files state them"))]
pub(crate) enum StatedPlace {
    /// One of the mechanism, by its name.
    Named(String),
    /// One of the ground.
    Fixed(Space<f64>),
}

/// The radius of a pitch circle.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(not(feature = "case"), expect(dead_code, reason = "files state them"))]
pub(crate) enum StatedRadius {
    /// A dimension of the mechanism, by its name.
    Dimension(String),
    /// A length in metres.
    Metres(f64),
}

/// Two bodies that roll on each other, of which the contact exerts its force on the second one.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct StatedContact {
    /// The name of its force.
    pub(crate) name: String,
    pub(crate) bodies: [String; 2],
    pub(crate) pitch: StatedPitch,
    pub(crate) pressure_angle: f64,
}

/// The pitch curves of two bodies: circles by their centres and radii, and the line of a rack by its direction.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(not(feature = "case"), expect(dead_code, reason = "files state them"))]
pub(crate) enum StatedPitch {
    Gears([(StatedPlace, StatedRadius); 2]),
    Rack((StatedPlace, StatedRadius), StatedPlace),
}

impl Default for Stated {
    fn default() -> Self {
        Self {
            hinges: Vec::new(),
            contacts: Vec::new(),
            metres: 1.0,
            frictions: Vec::new(),
            drives: Vec::new(),
            senses: Vec::new(),
        }
    }
}

impl StatedPlace {
    pub(crate) fn own(&self, metres: f64) -> LoadPoint<'_> {
        match self {
            Self::Named(name) => LoadPoint::Named(name),
            Self::Fixed(point) => LoadPoint::Fixed(point.scale(1.0 / metres)),
        }
    }
}

impl StatedRadius {
    /// In the unit of lengths. What is no dimension has no radius.
    pub(crate) fn own(&self, linkage: &AnyLinkage<'_>, metres: f64) -> f64 {
        let name = match self {
            Self::Metres(radius) => return radius / metres,
            Self::Dimension(name) => name,
        };
        let mut dimensions = linkage.description().parameters.iter().zip(linkage.parameters());
        let own = dimensions.find(|(quantity, _)| quantity.name == name);
        own.map_or(f64::NAN, |(_, value)| *value)
    }
}

impl StatedContact {
    /// Adds the contact to the joints of a mechanism.
    pub(crate) fn added<'m>(
        &self,
        reactions: NamedReactions<'m>,
        linkage: &AnyLinkage<'_>,
        metres: f64,
    ) -> Result<NamedReactions<'m>, Box<ReactionError>> {
        let rolling = match &self.pitch {
            StatedPitch::Gears([(one, first), (other, second)]) => {
                let radii = [first, second].map(|radius| radius.own(linkage, metres));
                Rolling::gears(one.own(metres), other.own(metres), radii)
            }
            StatedPitch::Rack((centre, radius), along) => {
                Rolling::rack(centre.own(metres), radius.own(linkage, metres), along.own(metres))
            }
        };
        let bodies = self.bodies.each_ref().map(String::as_str);
        Ok(reactions.rolling(&self.name, bodies, rolling.at_pressure_angle(self.pressure_angle))?)
    }
}

impl Stated {
    /// The joints of a mechanism with its hinges and contacts.
    pub(crate) fn joined<'m>(
        &self,
        linkage: &AnyLinkage<'m>,
        loads: &NamedLoads,
    ) -> Result<NamedReactions<'m>, Box<ReactionError>> {
        let mut reactions = linkage.reactions(loads)?;
        for (name, axis) in &self.hinges {
            reactions = reactions.hinge(name, axis.own(self.metres))?;
        }
        for contact in &self.contacts {
            reactions = contact.added(reactions, linkage, self.metres)?;
        }
        Ok(reactions)
    }

    /// The forces in joints.
    pub(crate) fn reactions<'m>(
        &self,
        linkage: &AnyLinkage<'m>,
        loads: &NamedLoads,
    ) -> Result<NamedReactions<'m>, Box<ReactionError>> {
        let mut reactions = self.joined(linkage, loads)?;
        for (input, body) in &self.drives {
            reactions = reactions.driving(input, body)?;
        }
        let reactions = reactions.frictions(self.frictions.iter().cloned())?;
        if self.senses.is_empty() {
            return Ok(reactions);
        }
        let sense = |name: &str| {
            self.senses
                .iter()
                .find(|(own, _)| own == name)
                .map_or(0.0, |(_, sense)| *sense)
        };
        let inputs = linkage.description().inputs.iter();
        Ok(reactions.about_to_move(&inputs.map(|input| sense(input.name)).collect::<Vec<_>>()))
    }

    pub(crate) fn has_friction(&self) -> bool {
        !self.frictions.is_empty()
    }
}

/// A force that loads cause.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Force {
    /// The effort of the drive of an input.
    Effort(usize),
    /// The power of the drive of an input.
    #[cfg_attr(not(feature = "case"), expect(dead_code, reason = "pages have no powers"))]
    Power(usize),
    /// A part of the force in a joint.
    Reaction(String, ReactionPart),
    /// The power that friction turns into heat.
    #[cfg_attr(not(feature = "case"), expect(dead_code, reason = "pages have no heat"))]
    Heat,
}

/// What forces follow from.
#[derive(Clone, Copy)]
pub(crate) struct Causes<'c> {
    pub(crate) loads: &'c NamedLoads,
    /// The forces in joints, if they are known.
    pub(crate) reactions: Option<&'c NamedReactions<'c>>,
    /// Whether friction is stated. Then efforts depend on the forces in joints.
    pub(crate) has_friction: bool,
}

impl Causes<'_> {
    /// The answer to a question about a force or one of its rates; none if it depends on forces in joints that are not
    /// known.
    pub(crate) fn ask<D: SmoothDrive, Q: ForceQuestion>(
        self,
        force: &Force,
        order: usize,
        sweep: &AnySweep<'_, D>,
        question: &Q,
    ) -> Option<Q::Answer> {
        let Self {
            loads,
            reactions,
            has_friction,
        } = self;
        Some(match force {
            Force::Effort(input) if has_friction => {
                question.ask(&sweep.of_effort_with_friction(reactions?, *input, order))
            }
            Force::Effort(input) => question.ask(&sweep.of_effort(loads, *input, order)),
            Force::Power(input) if has_friction => question.ask(&sweep.of_power_with_friction(reactions?, *input)),
            Force::Power(input) => question.ask(&sweep.of_power(loads, *input)),
            Force::Reaction(name, part) => question.ask(&sweep.of_reaction(reactions?, name, *part, order)),
            Force::Heat => question.ask(&sweep.of_heat(reactions?, order)),
        })
    }
}

/// The efficiency, unless friction locks the mechanism. It is zero where all power becomes heat but for rounding.
pub(crate) fn ratio(mean: Efficiency) -> Option<f64> {
    let ratio = mean.ratio().filter(|_| !mean.is_locked())?;
    Some(if ratio.abs() < ROUNDING { 0.0 } else { ratio })
}

/// Below this part of the peak, what is left of a zero is rounding.
pub(crate) const ROUNDING: f64 = 1e-12;

/// A question to a force along a sweep.
pub(crate) trait ForceQuestion {
    type Answer;

    fn ask<S: QuantitySource, Q: AskedQuantity<S>>(&self, quantity: &QuantityAlong<'_, S, Q>) -> Self::Answer;
}

/// An extreme value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reached {
    /// The value, or `None` if it grows beyond all bounds.
    pub(crate) value: Option<f64>,
    /// The place.
    pub(crate) at: f64,
    /// Whether the mechanism closes no further there.
    pub(crate) is_limit: bool,
}

/// What is the value that is largest in size?
pub(crate) struct OfPeak;

impl ForceQuestion for OfPeak {
    type Answer = Result<Reached, ExtremesError>;

    fn ask<S: QuantitySource, Q: AskedQuantity<S>>(&self, quantity: &QuantityAlong<'_, S, Q>) -> Self::Answer {
        let (value, at, is_limit) = match quantity.peak() {
            Ok(peak) => (Some(peak.value), peak.at, peak.kind == ExtremeKind::Limit),
            Err(ExtremesError::Unbounded { at }) => (None, at, false),
            Err(error) => return Err(error),
        };
        Ok(Reached { value, at, is_limit })
    }
}

/// What are the values in the rows?
pub(crate) struct OfRows;

impl ForceQuestion for OfRows {
    type Answer = Result<Vec<f64>, ExtremesError>;

    fn ask<S: QuantitySource, Q: AskedQuantity<S>>(&self, quantity: &QuantityAlong<'_, S, Q>) -> Self::Answer {
        quantity.column()
    }
}
