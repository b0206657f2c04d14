//! The loads of a file, in SI, and the columns of the forces that they cause.

use kin_core::any::{Description, Outline};
use kin_core::linkage::{AnyLinkage, LinkageFunctions};
use kin_core::load::{LoadPoint, NamedLoads, NoSuchName, Solid};
use kin_core::reaction::{ForceProof, Friction, NamedReactions, ProofError, ProvenForce, ReactionError, ReactionPart};
use kin_core::{Dimension, Space};

use super::fault::Fault;
use super::units::{self, Kind};
use crate::forces::{Force, Stated, StatedContact, StatedPlace};

/// The loads of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Loads {
    /// The acceleration of gravity.
    pub(crate) gravity: Option<[InSi; 3]>,
    /// The loads in their order.
    pub(crate) all: Vec<Load>,
    /// The axes of hinges of space, behind the names of their reactions.
    pub(crate) hinges: Vec<(String, StatedPlace)>,
    /// The contacts in which bodies roll on each other.
    pub(crate) contacts: Vec<StatedContact>,
    /// The friction in joints, by the names of their reactions.
    pub(crate) frictions: Vec<(String, JointFriction)>,
    /// The bodies that drives turn or push, behind the names of their inputs.
    pub(crate) drives: Vec<(String, String)>,
    /// The signs of the rates with which inputs are about to move where all of them rest.
    pub(crate) senses: Vec<(String, f64)>,
}

/// Friction in a joint: its coefficient, and the radius of a pin or the length of a bushing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum JointFriction {
    /// In a pin.
    Pin(f64, InSi),
    /// On a slide.
    Slide(f64, Option<InSi>),
}

/// What a joint is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum JointKind {
    /// A pin of the plane, or a ball or a hinge of space.
    Pin,
    /// A slide.
    Slide,
    /// A contact in which bodies roll on each other.
    Contact,
}

/// A joint with a force.
#[derive(Clone, Debug)]
pub(crate) struct Joint {
    /// The name of its reaction.
    pub(crate) name: String,
    /// What it is.
    pub(crate) kind: JointKind,
    /// Whether it has a moment: that of a slide, or of a hinge of space.
    pub(crate) has_moment: bool,
    /// Whether it is one of space.
    pub(crate) is_space: bool,
}

/// The joints of a mechanism with forces.
fn joints(functions: &dyn LinkageFunctions, stated: &Stated) -> Result<Vec<Joint>, Box<ReactionError>> {
    let linkage = unit_linkage(functions);
    let reactions = stated.joined(&linkage, &linkage.loads())?;
    Ok(joints_of(&reactions, functions.is_space()))
}

/// A linkage with any dimensions, on which the names of its joints do not depend.
pub(crate) fn unit_linkage(functions: &dyn LinkageFunctions) -> AnyLinkage<'_> {
    AnyLinkage::new(functions, &vec![1.0; functions.description().parameters.len()])
}

pub(crate) fn joints_of(reactions: &NamedReactions<'_>, is_space: bool) -> Vec<Joint> {
    let joint = |name: &str| {
        let is_slide = reactions.is_slide(name) == Ok(true);
        let kind = match reactions.joint_of(name) {
            Err(_) => JointKind::Contact,
            Ok(_) if is_slide => JointKind::Slide,
            Ok(_) => JointKind::Pin,
        };
        Joint {
            name: name.to_owned(),
            kind,
            has_moment: is_slide || reactions.is_hinge(name) == Ok(true),
            is_space,
        }
    };
    reactions.names().map(joint).collect()
}

/// A number in SI, which the unit of lengths of the mechanism divides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct InSi {
    value: f64,
    /// The power of the unit of lengths.
    lengths: i32,
}

/// The centre of a body.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Centre {
    /// A point of the mechanism.
    Named(String),
    /// A point in the frame of the body.
    InBody([InSi; 3]),
}

/// The end of a spring or damper.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum End {
    /// A point of the mechanism.
    Named(String),
    /// A point of the ground.
    Fixed([InSi; 3]),
}

/// A load, at a point or on an angle or distance, by its name.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Load {
    /// The mass of a body, its centre, and its moment of inertia.
    Body(String, InSi, Centre, InSi),
    /// The mass of a body of space, its centre, and its tensor of inertia: xx, yy, zz, xy, xz and yz.
    Solid(String, InSi, [InSi; 3], [InSi; 6]),
    /// A mass at a point.
    Mass(InSi, String),
    /// A moment of inertia with an angle.
    Inertia(InSi, String),
    /// A force at a point.
    Force([InSi; 3], String),
    /// A torque on an angle, or a force along a distance.
    Torque(InSi, String),
    /// A spring between points: its stiffness, and its length at rest.
    Spring(InSi, InSi, [End; 2]),
    /// A damper between points.
    Damper(InSi, [End; 2]),
    /// A spring on an angle or a distance: its stiffness, and the value at rest.
    TorsionSpring(InSi, InSi, String),
    /// A damper on an angle or a distance.
    TorsionDamper(InSi, String),
}

impl InSi {
    /// A number of a kind.
    pub(crate) fn new(kind: Kind, value: f64) -> Self {
        Self {
            value,
            lengths: kind.lengths,
        }
    }

    /// Whether it is above zero.
    pub(crate) fn is_positive(self) -> bool {
        self.value > 0.0
    }

    /// In a unit of lengths.
    pub(crate) fn own(self, metres: f64) -> f64 {
        self.value / metres.powi(self.lengths)
    }
}

pub(crate) fn space(parts: [InSi; 3], metres: f64) -> Space<f64> {
    let [x, y, z] = parts.map(|part| part.own(metres));
    Space::new(x, y, z)
}

impl Loads {
    /// Whether nothing is said of loads.
    pub(crate) fn is_empty(&self) -> bool {
        self.all.is_empty() && self.gravity.is_none() && self.frictions.is_empty()
    }

    /// The loads on a mechanism whose unit of lengths has so many metres, if there are any.
    pub(crate) fn named(
        &self,
        description: &Description<'_>,
        outline: &Outline<'_>,
        metres: f64,
    ) -> Result<Option<NamedLoads>, Fault> {
        if self.is_empty() {
            return Ok(None);
        }
        let gravity = self.gravity.map_or(Space::zero(), |gravity| space(gravity, metres));
        let mut loads = NamedLoads::new(description).with_bodies(outline).gravity(gravity);
        for load in &self.all {
            loads = load.added(loads, metres).map_err(Fault::wrong)?;
        }
        Ok(Some(loads))
    }

    /// What is stated of joints and drives of a mechanism whose unit of lengths has so many metres.
    pub(crate) fn stated(&self, metres: f64) -> Stated {
        let own = |friction: JointFriction| match friction {
            JointFriction::Pin(coefficient, radius) => Friction::Pin {
                coefficient,
                radius: radius.own(metres),
            },
            JointFriction::Slide(coefficient, length) => Friction::Slide {
                coefficient,
                length: length.map(|length| length.own(metres)),
            },
        };
        let all = self.frictions.iter();
        Stated {
            hinges: self.hinges.clone(),
            contacts: self.contacts.clone(),
            metres,
            frictions: all.map(|(name, friction)| (name.clone(), own(*friction))).collect(),
            drives: self.drives.clone(),
            senses: self.senses.clone(),
        }
    }
}

impl End {
    fn place(&self, metres: f64) -> LoadPoint<'_> {
        match self {
            Self::Named(name) => LoadPoint::Named(name),
            Self::Fixed(point) => LoadPoint::Fixed(space(*point, metres)),
        }
    }
}

impl Load {
    fn added(&self, loads: NamedLoads, metres: f64) -> Result<NamedLoads, NoSuchName> {
        let own = |number: &InSi| number.own(metres);
        match self {
            Self::Body(body, mass, Centre::Named(centre), inertia) => {
                loads.mass_of(body, own(mass), centre.as_str(), own(inertia))
            }
            Self::Body(body, mass, Centre::InBody(centre), inertia) => {
                loads.mass_of(body, own(mass), space(*centre, metres), own(inertia))
            }
            Self::Solid(body, mass, centre, [xx, yy, zz, xy, xz, yz]) => {
                let [xx, yy, zz, xy, xz, yz] = [xx, yy, zz, xy, xz, yz].map(own);
                let solid = Solid {
                    mass: own(mass),
                    centre: space(*centre, metres),
                    inertia: [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]],
                };
                loads.solid_of(body, solid)
            }
            Self::Mass(mass, point) => loads.mass(own(mass), point),
            Self::Inertia(inertia, angle) => loads.inertia(own(inertia), angle),
            Self::Force(force, point) => loads.force(space(*force, metres), point),
            Self::Torque(torque, angle) => loads.torque(own(torque), angle),
            Self::Spring(stiffness, rest, [from, to]) => {
                loads.spring(own(stiffness), own(rest), from.place(metres), to.place(metres))
            }
            Self::Damper(damping, [from, to]) => loads.damper(own(damping), from.place(metres), to.place(metres)),
            Self::TorsionSpring(stiffness, rest, angle) => loads.torsion_spring(own(stiffness), own(rest), angle),
            Self::TorsionDamper(damping, angle) => loads.torsion_damper(own(damping), angle),
        }
    }
}

/// A column of a force or a power that the loads cause, or of one of its rates.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ForceColumn {
    /// What it is.
    pub(crate) force: Force,
    /// The order of the rate, 0 for the force itself.
    pub(crate) order: usize,
}

/// The columns of forces, and why there are none of joints.
#[derive(Clone, Debug, Default)]
pub(crate) struct ForceColumns {
    /// All of them.
    pub(crate) all: Vec<ForceColumn>,
    /// Why there are none of joints, and the names of those that there would be if the bodies were as guessed.
    joints: Option<(Box<ReactionError>, Vec<String>)>,
}

impl ForceColumns {
    /// Those of a mechanism under loads.
    pub(crate) fn of(functions: &dyn LinkageFunctions, stated: &Stated, has_friction: bool) -> Self {
        let description = functions.description();
        let mut all: Vec<ForceColumn> = Vec::new();
        for input in 0..description.inputs.len() {
            all.extend(with_rates(Force::Effort(input)));
            let (force, order) = (Force::Power(input), 0);
            all.push(ForceColumn { force, order });
        }
        let joints = match joints(functions, stated) {
            Ok(joints) => {
                all.extend(of_joints(&joints));
                None
            }
            Err(error) => {
                let linkage = unit_linkage(functions);
                let guessed = linkage.reactions_as_guessed(&linkage.loads());
                let guessed =
                    guessed.map_or_else(|_| Vec::new(), |reactions| joints_of(&reactions, functions.is_space()));
                let names = of_joints(&guessed).into_iter().map(|column| column.name(description));
                Some((error, names.collect()))
            }
        };
        if has_friction {
            all.extend(with_rates(Force::Heat));
        }
        Self { all, joints }
    }

    /// Why there are no forces in joints.
    pub(crate) fn no_joints(&self) -> Option<&ReactionError> {
        self.joints.as_ref().map(|(error, _)| &**error)
    }

    /// The efforts of drives alone.
    pub(crate) fn efforts(&self) -> impl Iterator<Item = &ForceColumn> {
        let is_effort = |column: &&ForceColumn| matches!(column.force, Force::Effort(_));
        self.all.iter().filter(is_effort)
    }

    /// Why a name is that of no column, if it is meant to be a force in a joint.
    pub(crate) fn advice(&self, name: &str) -> Option<String> {
        let (error, guessed) = self.joints.as_ref()?;
        let is_force = guessed.iter().any(|own| own == name) || looks_like_a_force(name, &["_force", "_moment"]);
        is_force.then(|| format!("there is no column `{name}`: {error}"))
    }

    /// Whether a name could be that of a force in a joint of a body that is not declared.
    pub(crate) fn could_be_of_a_joint(name: &str) -> bool {
        looks_like_a_force(name, &["_x", "_y", "_force", "_moment"])
    }
}

fn looks_like_a_force(name: &str, parts: &[&str]) -> bool {
    let mut rates = RATES.iter().rev();
    let whole = rates.find_map(|(rate, _)| name.strip_suffix(rate)).unwrap_or(name);
    parts.iter().any(|part| whole.ends_with(part))
}

fn with_rates(force: Force) -> impl Iterator<Item = ForceColumn> {
    (0..RATES.len()).map(move |order| ForceColumn {
        force: force.clone(),
        order,
    })
}

/// The columns of the forces in joints.
fn of_joints(joints: &[Joint]) -> Vec<ForceColumn> {
    let columns = joints.iter().flat_map(|joint| {
        let z = joint.is_space.then_some(ReactionPart::Z);
        let moment = joint.has_moment.then_some(ReactionPart::Moment);
        let moments = [ReactionPart::MomentX, ReactionPart::MomentY, ReactionPart::MomentZ];
        let moments = moments.into_iter().filter(|_| joint.is_space && joint.has_moment);
        let parts = [ReactionPart::X, ReactionPart::Y].into_iter().chain(z);
        let parts = parts.chain([ReactionPart::Force]).chain(moment).chain(moments);
        parts.map(|part| Force::Reaction(joint.name.clone(), part))
    });
    columns.flat_map(with_rates).collect()
}

pub(crate) fn is_moment(part: ReactionPart) -> bool {
    matches!(
        part,
        ReactionPart::Moment | ReactionPart::MomentX | ReactionPart::MomentY | ReactionPart::MomentZ
    )
}

impl ForceColumn {
    /// Whether it is a coordinate of a force or of a moment.
    pub(crate) fn is_coordinate(&self) -> bool {
        matches!(&self.force, Force::Reaction(_, part) if !matches!(part, ReactionPart::Force | ReactionPart::Moment))
    }

    /// Its name.
    pub(crate) fn name(&self, description: &Description<'_>) -> String {
        let rate = RATES[self.order].0;
        match &self.force {
            Force::Effort(input) => format!("{}_effort{rate}", description.inputs[*input].name),
            Force::Power(input) => format!("{}_power", description.inputs[*input].name),
            Force::Reaction(name, part) => {
                let part = match part {
                    ReactionPart::X => "x",
                    ReactionPart::Y => "y",
                    ReactionPart::Z => "z",
                    ReactionPart::Force => "force",
                    ReactionPart::Moment => "moment",
                    ReactionPart::MomentX => "moment_x",
                    ReactionPart::MomentY => "moment_y",
                    ReactionPart::MomentZ => "moment_z",
                };
                format!("{name}_{part}{rate}")
            }
            Force::Heat => format!("{HEAT}{rate}"),
        }
    }

    /// The name by which a page plots it, where every page has it.
    pub(crate) fn plot(&self, description: &Description<'_>) -> Option<String> {
        match &self.force {
            Force::Effort(input) => Some(format!("{}_effort", description.inputs[*input].name)),
            Force::Reaction(_, part) if is_moment(*part) => None,
            Force::Power(_) | Force::Heat => None,
            Force::Reaction(name, _) => Some(format!("{name}_force")),
        }
    }

    /// Its unit without that of its rate, and the power of the unit of lengths in it.
    fn base(&self, description: &Description<'_>) -> (&'static str, i32) {
        let is_torque = match &self.force {
            Force::Power(_) | Force::Heat => return ("W", 2),
            Force::Effort(input) => description.inputs[*input].dimension != Dimension::Length,
            Force::Reaction(_, part) => is_moment(*part),
        };
        if is_torque { ("N m", 2) } else { ("N", 1) }
    }

    /// The kind of its limits; none of a power, and of rates.
    pub(crate) fn kind(&self, description: &Description<'_>) -> Option<Kind> {
        match self.base(description) {
            _ if self.order > 0 => None,
            ("N", _) => Some(units::FORCE),
            ("N m", _) => Some(units::TORQUE),
            _ => None,
        }
    }

    /// What is to be proved of it.
    pub(crate) fn proven<'p>(&self, proof: ForceProof<'p>) -> Result<ProvenForce<'p>, ProofError> {
        match &self.force {
            Force::Reaction(name, part) => proof.of(name, *part),
            Force::Effort(input) | Force::Power(input) => proof.of_effort(*input),
            Force::Heat => Err(ProofError::Friction),
        }
    }

    /// Its unit.
    pub(crate) fn unit(&self, description: &Description<'_>) -> String {
        format!("{}{}", self.base(description).0, RATES[self.order].1)
    }

    /// What one of it is in its unit, if the unit of lengths has so many metres.
    pub(crate) fn size(&self, description: &Description<'_>, metres: f64) -> f64 {
        metres.powi(self.base(description).1)
    }
}

/// The name of the power that friction turns into heat.
pub(crate) const HEAT: &str = "friction_heat";

/// The ends of the names of a force and its rates, each with the end of its unit.
const RATES: [(&str, &str); 3] = [("", ""), ("_rate", "/s"), ("_second_rate", "/s²")];
