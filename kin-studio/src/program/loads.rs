//! The loads of a file, in SI, and the efforts that they ask of the drives.

use kin_core::any::Description;
use kin_core::load::{NamedLoads, NoSuchPlace, PointPlace};
use kin_core::{Dimension, Space};

use super::fault::Fault;
use super::units::Kind;

/// The loads of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Loads {
    /// The acceleration of gravity.
    pub(crate) gravity: Option<[InSi; 3]>,
    /// The loads in their order.
    pub(crate) all: Vec<Load>,
}

/// A number in SI, which the unit of lengths of the mechanism divides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct InSi {
    value: f64,
    /// The power of the unit of lengths.
    lengths: i32,
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

    fn own(self, metres: f64) -> f64 {
        self.value / metres.powi(self.lengths)
    }
}

fn space(parts: [InSi; 3], metres: f64) -> Space<f64> {
    let [x, y, z] = parts.map(|part| part.own(metres));
    Space::new(x, y, z)
}

impl Loads {
    /// Whether nothing is said of loads.
    pub(crate) fn is_empty(&self) -> bool {
        self.all.is_empty() && self.gravity.is_none()
    }

    /// The loads on a mechanism whose unit of lengths has so many metres, if there are any.
    pub(crate) fn named(&self, description: &Description<'_>, metres: f64) -> Result<Option<NamedLoads>, Fault> {
        if self.is_empty() {
            return Ok(None);
        }
        let gravity = self.gravity.map_or(Space::zero(), |gravity| space(gravity, metres));
        let mut loads = NamedLoads::new(description).gravity(gravity);
        for load in &self.all {
            loads = load.added(loads, metres).map_err(Fault::wrong)?;
        }
        Ok(Some(loads))
    }
}

impl End {
    fn place(&self, metres: f64) -> PointPlace<'_> {
        match self {
            Self::Named(name) => PointPlace::Named(name),
            Self::Fixed(point) => PointPlace::Fixed(space(*point, metres)),
        }
    }
}

impl Load {
    fn added(&self, loads: NamedLoads, metres: f64) -> Result<NamedLoads, NoSuchPlace> {
        let own = |number: &InSi| number.own(metres);
        match self {
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

/// The effort of the drive of an input, or one of its rates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Effort {
    /// The input.
    pub(crate) input: usize,
    /// The order of the rate, 0 for the effort itself.
    pub(crate) order: usize,
}

impl Effort {
    /// The efforts of so many inputs with their rates.
    pub(crate) fn all(inputs: usize) -> impl Iterator<Item = Self> {
        (0..inputs).flat_map(|input| (0..RATES.len()).map(move |order| Self { input, order }))
    }

    /// The name of its column.
    pub(crate) fn name(self, description: &Description<'_>) -> String {
        format!("{}_{}", description.inputs[self.input].name, RATES[self.order].0)
    }

    /// Its unit.
    pub(crate) fn unit(self, description: &Description<'_>) -> String {
        let unit = match description.inputs[self.input].dimension {
            Dimension::Length => "N",
            Dimension::Angle | Dimension::Scalar => "N m",
        };
        format!("{unit}{}", RATES[self.order].1)
    }

    /// What one of it is in its unit, if the unit of lengths has so many metres.
    pub(crate) fn size(self, description: &Description<'_>, metres: f64) -> f64 {
        match description.inputs[self.input].dimension {
            Dimension::Length => metres,
            Dimension::Angle | Dimension::Scalar => metres * metres,
        }
    }
}

/// The names of an effort and its rates, each with the end of its unit.
const RATES: [(&str, &str); 3] = [("effort", ""), ("effort_rate", "/s"), ("effort_second_rate", "/s²")];
