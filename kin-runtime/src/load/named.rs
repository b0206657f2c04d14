//! Loads by the names of points and angles.

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::error::Error;
use core::fmt;
use core::marker::PhantomData;

use crate::geometry::{Plane, Space};
use crate::load::kinds::{
    BetweenPoints, Damper, Force, Inertia, Load, Mass, OnAngle, Solid, SpaceBody, Spring, Torque,
};
use crate::load::plane_body::{BodyFrame, PlaneBody, centre_on_line, third_point};
use crate::load::{Change, LoadError, LoadedSystem, Totals, VaryingNumber, VaryingVector};
use crate::mechanism::Description;
use crate::number::Number;
use crate::picture::Outline;
use crate::solve::Scalar;

/// The number of entries of a motion: the value, and the derivatives from which the second rate of an effort follows.
pub(crate) const ENTRIES: usize = 5;

/// The number of entries of an effort: its value and two rates.
pub(crate) const EFFORT_ENTRIES: usize = ENTRIES - 2;

/// A quantity in motion, with its changes along one input.
pub(crate) type NamedMotion<T> = [Change<T>; ENTRIES];

/// A point on which a load acts: one of the mechanism by its name, or one of the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LoadPoint<'n> {
    /// An output, a parameter or another quantity with coordinates.
    Named(&'n str),
    /// A point of the ground.
    Fixed(Space<f64>),
}

impl<'n> From<&'n str> for LoadPoint<'n> {
    fn from(name: &'n str) -> Self {
        Self::Named(name)
    }
}

impl From<Plane<f64>> for LoadPoint<'_> {
    fn from(point: Plane<f64>) -> Self {
        Self::Fixed(Space::new(point.x, point.y, 0.0))
    }
}

impl From<Space<f64>> for LoadPoint<'_> {
    fn from(point: Space<f64>) -> Self {
        Self::Fixed(point)
    }
}

/// Masses, moments of inertia, gravity, forces, torques, springs and dampers on a mechanism without its type. Points,
/// angles and distances are called by their names.
///
/// The loads and their units are those of [`Loads`](crate::load::Loads). A sweep tells the effort of a drive with its
/// two rates: [`of_effort`](crate::linkage::AnySweep::of_effort).
///
/// ```
/// use std::f64::consts::TAU;
/// use kin_core::any::AssemblyChoice;
/// use kin_core::linkage::AnyLinkage;
/// use kin_core::load::NamedLoads;
/// use kin_core::prelude::*;
///
/// mechanism! {
///     /// Slider-crank in metres.
///     pub struct Engine { pub r: Length, pub l: Length }
///     input theta: Angle;
///     unknown phi: Angle, s: Length;
///     r * cis(theta) + l * cis(phi) == vec2(s, 0);
///     output piston: Point = vec2(s, 0);
/// }
///
/// let engine = Engine { r: 0.05, l: 0.15 };
/// let linkage = AnyLinkage::of(&engine);
/// let loads = NamedLoads::new(linkage.description())
///     .gravity(Plane::new(0.0, -9.81))
///     .mass(0.8, "piston")?
///     .inertia(0.01, "phi")?;
/// let turn = linkage.sweep(AssemblyChoice::Index(0)).between(&[0.0], &[TAU], 361).speed(rpm(900.0));
/// let [torque, rate] = [0, 1].map(|order| turn.of_effort(&loads, 0, order).peak());
/// println!("{} N m, with a rate of {} N m/s", torque?, rate?);
/// assert!(loads.mass(0.1, "pistn").is_err());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct NamedLoads {
    gravity: Space<f64>,
    /// The parameters, inputs, unknowns and outputs.
    names: Vec<String>,
    /// The number of parameters, which do not move.
    still: usize,
    bodies: Vec<NamedBody>,
    loads: Vec<NamedLoad>,
}

/// A body with its frame and its joints.
#[derive(Clone, Debug, PartialEq)]
struct NamedBody {
    name: String,
    frame: Option<BodyFrame>,
    joints: Vec<usize>,
}

/// A load with the indices of its quantities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum NamedLoad {
    /// A mass and a moment of inertia about its centre, and the body. A centre that is no point of the mechanism lies
    /// in the frame of the body.
    Body(f64, f64, PointIndex, usize, BodyFrame),
    /// The mass properties of a body of space, and the body.
    Solid(Solid, usize),
    Mass(f64, PointIndex),
    Inertia(f64, usize),
    Force(Space<f64>, PointIndex),
    Torque(f64, usize),
    Spring(Spring, [PointIndex; 2]),
    Damper(Damper, [PointIndex; 2]),
    TorsionSpring(Spring, usize),
    TorsionDamper(Damper, usize),
}

impl NamedLoad {
    /// The quantities on which it depends.
    pub(crate) fn quantities(&self) -> impl Iterator<Item = usize> {
        let (points, quantity) = match *self {
            Self::Body(_, _, point, ..) | Self::Mass(_, point) | Self::Force(_, point) => ([Some(point), None], None),
            Self::Spring(_, ends) | Self::Damper(_, ends) => (ends.map(Some), None),
            Self::Inertia(_, quantity) | Self::TorsionSpring(_, quantity) | Self::TorsionDamper(_, quantity) => {
                ([None; 2], Some(quantity))
            }
            Self::Solid(..) | Self::Torque(..) => ([None; 2], None),
        };
        points
            .into_iter()
            .flatten()
            .flat_map(PointIndex::quantities)
            .chain(quantity)
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum PointIndex {
    /// The indices of the coordinates.
    Moving([Option<usize>; 3]),
    Fixed(Space<f64>),
}

impl PointIndex {
    /// The quantities that are its coordinates.
    pub(crate) fn quantities(self) -> impl Iterator<Item = usize> {
        let coordinates = match self {
            Self::Moving(coordinates) => coordinates,
            Self::Fixed(_) => [None; 3],
        };
        coordinates.into_iter().flatten()
    }
}

/// The kind of the thing on which a load acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LoadedKind {
    /// A point.
    Point,
    /// An angle or a distance.
    Angle,
    /// A body of the picture.
    Body,
}

/// No point, angle or body has this name.
#[derive(Clone, PartialEq, Eq)]
pub struct NoSuchName {
    /// The name.
    pub name: String,
    /// The kind that is wanted.
    pub kind: LoadedKind,
    /// The names that could be given.
    pub names: Vec<String>,
}

impl fmt::Display for NoSuchName {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (kind, advice) = match self.kind {
            LoadedKind::Point => ("point", "; declare one, as in `output tip: Point = ..`"),
            LoadedKind::Angle => ("angle or distance", ""),
            LoadedKind::Body => ("body", "; state the bodies, as in `body crank: 0, pin;`"),
        };
        write!(formatter, "there is no {kind} `{}`", self.name)?;
        for (index, name) in self.names.iter().enumerate() {
            write!(formatter, "{} `{name}`", if index == 0 { "; there is" } else { "," })?;
        }
        if self.names.is_empty() {
            formatter.write_str(advice)?;
        }
        Ok(())
    }
}

crate::__debug_by_display!(NoSuchName);

impl Error for NoSuchName {}

/// The names of the coordinates of a point.
const AXES: [&str; 3] = ["x", "y", "z"];

impl NamedLoads {
    /// No load on the mechanism of this description.
    #[must_use]
    pub fn new(description: &Description<'_>) -> Self {
        let moving = [description.inputs, description.unknowns, description.outputs];
        let all = description.parameters.iter().chain(moving.into_iter().flatten());
        Self {
            gravity: Space::zero(),
            names: all.map(|quantity| quantity.name.to_string()).collect(),
            still: description.parameters.len(),
            bodies: Vec::new(),
            loads: Vec::new(),
        }
    }

    /// The same with the bodies of a picture, whose masses [`mass_of`](Self::mass_of) gives.
    #[must_use]
    pub fn with_bodies(mut self, outline: &Outline<'_>) -> Self {
        let bodies = outline.bodies.iter().enumerate();
        self.bodies = bodies
            .map(|(index, body)| NamedBody {
                name: body.name.to_string(),
                frame: BodyFrame::of(outline, index),
                joints: body.joints.to_vec(),
            })
            .collect();
        self
    }

    /// Whether there is no load.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.loads.is_empty()
    }

    /// The names of points on which loads can act.
    #[must_use]
    pub fn points(&self) -> Vec<&str> {
        self.names.iter().filter_map(|name| name.strip_suffix(".x")).collect()
    }

    /// The names of angles and distances on which loads can act.
    #[must_use]
    pub fn angles(&self) -> Vec<&str> {
        let moving = self.names[self.still..].iter().map(String::as_str);
        moving.filter(|name| !name.contains('.')).collect()
    }

    /// The names of the bodies that can have a mass.
    #[must_use]
    pub fn bodies(&self) -> Vec<&str> {
        let known = self.bodies.iter().filter(|body| body.frame.is_some());
        known.map(|body| body.name.as_str()).collect()
    }

    /// The acceleration of gravity: see [`gravity`](crate::load::Loads::gravity).
    #[must_use]
    pub fn gravity(mut self, acceleration: impl VaryingVector<f64>) -> Self {
        self.gravity = acceleration.entry(0);
        self
    }

    /// A mass at a point: see [`mass`](crate::load::Loads::mass).
    ///
    /// # Errors
    /// [`NoSuchName`] if no point has the name, as for all loads at points.
    pub fn mass(self, mass: f64, point: &str) -> Result<Self, NoSuchName> {
        let point = self.point(point)?;
        Ok(self.and(NamedLoad::Mass(mass, point)))
    }

    /// The mass of a body of the plane or of a rod of space, its centre, and its moment of inertia about this centre.
    ///
    /// The centre is a point of the mechanism that moves with the body, or a [`Plane`] in the frame of the body: the
    /// first axis leads from its first joint to its second one, and the second lies to the left of it. The frame of a
    /// body with one joint lies along the slide that it carries, or along which it moves.
    ///
    /// In space, the body is a rod: its centre lies on the line from its first joint to its second one, at
    /// `Plane::new(distance, 0.0)`, and it has the moment of inertia about all axes at right angles to this line, but
    /// none about the line. Others are given by [`solid_of`](Self::solid_of).
    ///
    /// ```
    /// use kin_core::any::{Of, Pictured};
    /// use kin_core::library::FourBar;
    /// use kin_core::load::NamedLoads;
    /// use kin_core::prelude::*;
    ///
    /// let bodies = Of::<FourBar>::FUNCTIONS.outline();
    /// let loads = NamedLoads::new(&FourBar::<f64>::DESCRIPTION).with_bodies(&bodies);
    /// let loads = loads.mass_of("r3", 1.4, Plane::new(0.18, 0.02), 0.016)?;
    /// assert_eq!(loads.bodies(), ["r2", "r3", "r4"]);
    /// # Ok::<(), kin_core::load::NoSuchName>(())
    /// ```
    ///
    /// # Errors
    /// [`NoSuchName`] if no body, or no point, has the name.
    pub fn mass_of<'n>(
        self,
        body: &str,
        mass: f64,
        centre: impl Into<LoadPoint<'n>>,
        inertia: f64,
    ) -> Result<Self, NoSuchName> {
        let index = self.body(body)?;
        let frame = self.bodies[index].frame;
        let frame = frame.ok_or_else(|| self.no_such_name(body, LoadedKind::Body))?;
        let centre = self.load_point(centre.into())?;
        Ok(self.and(NamedLoad::Body(mass, inertia, centre, index, frame)))
    }

    /// The mass of a body of space with its centre and its tensor of inertia.
    ///
    /// The frame of the [`Solid`] is fixed to three joints of the body: the first two, and the first one behind them
    /// that does not lie on their line.
    ///
    /// ```
    /// use std::f64::consts::TAU;
    /// use kin_core::any::{AssemblyChoice, PositionChoice};
    /// use kin_core::linkage::AnyLinkage;
    /// use kin_core::load::Solid;
    /// use kin_core::prelude::*;
    /// use kin_core::reaction::ReactionPart;
    ///
    /// mechanism! {
    ///     /// Two skew shafts, and a rod between two ball joints, in metres.
    ///     struct Shafts { crank: Length, pivot: Point3, axis: Vector3, arm: Vector3, rod: Length }
    ///     input theta: Angle;
    ///     unknown phi: Angle;
    ///     let rocker = pivot + rot(axis, phi) * arm;
    ///     let knob = rot_z(theta) * vec3(crank, 0, 0);
    ///     dot(rocker - knob, rocker - knob) == rod.powi(2);
    ///     output pin: Point3 = knob;
    ///     output ball: Point3 = rocker;
    ///
    ///     let up = vec3(0, 0, crank);
    ///     ground 0, up, pivot;
    ///     body crank: 0, up, pin;
    ///     body rod: pin, ball;
    ///     body rocker: pivot, ball;
    /// }
    ///
    /// let shafts = Shafts {
    ///     crank: 0.04,
    ///     pivot: Space::new(0.12, 0.02, 0.03),
    ///     axis: Space::new(0.0, 1.0, 0.1),
    ///     arm: Space::new(0.016, -0.012, 0.076),
    ///     rod: 0.13,
    /// };
    /// let linkage = AnyLinkage::of(&shafts);
    /// let inertia = [[4e-4, 0.0, 0.0], [0.0, 5e-4, 0.0], [0.0, 0.0, 3e-4]];
    /// let loads = linkage
    ///     .loads()
    ///     .gravity(Space::new(0.0, 0.0, -9.81))
    ///     .solid_of("crank", Solid { mass: 0.4, centre: Space::zero(), inertia })?
    ///     .mass_of("rod", 0.2, Plane::new(0.065, 0.0), 3e-4)?
    ///     .torque(-2.0, "phi")?;
    /// let reactions = linkage.reactions(&loads)?.hinge("ground_rocker", "axis")?;
    /// let crank = Motion::at_constant_speed(1.0, rpm(500.0));
    /// let found = reactions.at(&[crank], PositionChoice::Assembly(0))?;
    /// println!("{:?} N", found.of("ball")?.magnitude());
    /// let [_, y, _] = found.of("ground_crank")?.moments;
    /// println!("{:.2} N m about y in the bearing of the crank", y[0]);
    ///
    /// let turn = linkage.sweep(AssemblyChoice::Index(0)).between(&[0.0], &[TAU], 361).speed(rpm(500.0));
    /// println!("{} N m", turn.of_reaction(&reactions, "ground_crank", ReactionPart::Moment, 0).peak()?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`NoSuchName`] if no body has the name.
    pub fn solid_of(self, body: &str, solid: Solid) -> Result<Self, NoSuchName> {
        let index = self.body(body)?;
        Ok(self.and(NamedLoad::Solid(solid, index)))
    }

    /// The moment of inertia of a link about its centre of mass, in the plane: see
    /// [`inertia`](crate::load::Loads::inertia).
    ///
    /// # Errors
    /// [`NoSuchName`] if no angle has the name, as for all loads on angles.
    pub fn inertia(self, inertia: f64, angle: &str) -> Result<Self, NoSuchName> {
        let angle = self.number(angle)?;
        Ok(self.and(NamedLoad::Inertia(inertia, angle)))
    }

    /// A constant force at a point.
    ///
    /// # Errors
    /// As for [`mass`](Self::mass).
    pub fn force(self, force: impl VaryingVector<f64>, point: &str) -> Result<Self, NoSuchName> {
        let point = self.point(point)?;
        Ok(self.and(NamedLoad::Force(force.entry(0), point)))
    }

    /// A constant torque on an angle, or a constant force along a distance.
    ///
    /// # Errors
    /// As for [`inertia`](Self::inertia).
    pub fn torque(self, torque: f64, angle: &str) -> Result<Self, NoSuchName> {
        let angle = self.number(angle)?;
        Ok(self.and(NamedLoad::Torque(torque, angle)))
    }

    /// A spring between two points, with its stiffness and its length at rest.
    ///
    /// # Errors
    /// As for [`mass`](Self::mass).
    pub fn spring<'n>(
        self,
        stiffness: f64,
        rest: f64,
        from: impl Into<LoadPoint<'n>>,
        to: impl Into<LoadPoint<'n>>,
    ) -> Result<Self, NoSuchName> {
        let ends = [self.load_point(from.into())?, self.load_point(to.into())?];
        Ok(self.and(NamedLoad::Spring(Spring { stiffness, rest }, ends)))
    }

    /// A damper between two points.
    ///
    /// # Errors
    /// As for [`mass`](Self::mass).
    pub fn damper<'n>(
        self,
        damping: f64,
        from: impl Into<LoadPoint<'n>>,
        to: impl Into<LoadPoint<'n>>,
    ) -> Result<Self, NoSuchName> {
        let ends = [self.load_point(from.into())?, self.load_point(to.into())?];
        Ok(self.and(NamedLoad::Damper(Damper { damping }, ends)))
    }

    /// A spring that acts on an angle or a distance, with its value at rest.
    ///
    /// # Errors
    /// As for [`inertia`](Self::inertia).
    pub fn torsion_spring(self, stiffness: f64, rest: f64, angle: &str) -> Result<Self, NoSuchName> {
        let angle = self.number(angle)?;
        Ok(self.and(NamedLoad::TorsionSpring(Spring { stiffness, rest }, angle)))
    }

    /// A damper that acts on an angle or a distance.
    ///
    /// # Errors
    /// As for [`inertia`](Self::inertia).
    pub fn torsion_damper(self, damping: f64, angle: &str) -> Result<Self, NoSuchName> {
        let angle = self.number(angle)?;
        Ok(self.and(NamedLoad::TorsionDamper(Damper { damping }, angle)))
    }

    fn body(&self, name: &str) -> Result<usize, NoSuchName> {
        let index = self.bodies.iter().position(|body| body.name == name);
        index.ok_or_else(|| self.no_such_name(name, LoadedKind::Body))
    }

    fn and(mut self, load: NamedLoad) -> Self {
        self.loads.push(load);
        self
    }

    fn number(&self, name: &str) -> Result<usize, NoSuchName> {
        let index = self.names[self.still..].iter().position(|own| own == name);
        index
            .map(|index| self.still + index)
            .ok_or_else(|| self.no_such_name(name, LoadedKind::Angle))
    }

    fn point(&self, name: &str) -> Result<PointIndex, NoSuchName> {
        let coordinate = |axis| {
            let is_own = |own: &String| own.rsplit_once('.') == Some((name, axis));
            self.names.iter().position(is_own)
        };
        let coordinates = AXES.map(coordinate);
        match coordinates {
            [Some(_), Some(_), _] => Ok(PointIndex::Moving(coordinates)),
            _ => Err(self.no_such_name(name, LoadedKind::Point)),
        }
    }

    /// The indices of a point by its name, or a fixed one.
    pub(crate) fn load_point(&self, point: LoadPoint<'_>) -> Result<PointIndex, NoSuchName> {
        match point {
            LoadPoint::Named(name) => self.point(name),
            LoadPoint::Fixed(point) => Ok(PointIndex::Fixed(point)),
        }
    }

    fn no_such_name(&self, name: &str, kind: LoadedKind) -> NoSuchName {
        let names = match kind {
            LoadedKind::Point => self.points(),
            LoadedKind::Angle => self.angles(),
            LoadedKind::Body => self.bodies(),
        };
        NoSuchName {
            name: name.to_string(),
            kind,
            names: names.into_iter().map(ToString::to_string).collect(),
        }
    }

    /// The loads in their order.
    pub(crate) fn all(&self) -> &[NamedLoad] {
        &self.loads
    }

    pub(crate) fn acceleration_of_gravity(&self) -> Space<f64> {
        self.gravity
    }

    /// The name of a point with these coordinates, none if it does not move.
    pub(crate) fn point_name(&self, point: PointIndex) -> Option<&str> {
        match point {
            PointIndex::Moving([Some(x), ..]) if x >= self.still => self.names[x].strip_suffix(".x"),
            _ => None,
        }
    }

    /// The name of an angle or distance.
    pub(crate) fn name(&self, quantity: usize) -> &str {
        &self.names[quantity]
    }

    /// Whether a load acts on a body by its name.
    pub(crate) fn has_bodies(&self) -> bool {
        self.loads
            .iter()
            .any(|load| matches!(load, NamedLoad::Body(..) | NamedLoad::Solid(..)))
    }

    /// The effort of the drive of one input with its rates, from the motions of parameters, inputs, unknowns and
    /// outputs, and of the places of a picture, with their changes along this input. The directions of
    /// slides are unit vectors. Nothing needs the places if no [body](Self::has_bodies) has a mass.
    pub(crate) fn effort<T: Scalar>(
        &self,
        quantities: &[NamedMotion<T>],
        places: &[[NamedMotion<T>; 3]],
        is_space: bool,
    ) -> Result<[T; EFFORT_ENTRIES], LoadError> {
        let mut totals = Totals::<ByNames<'_, T>>::new([NamedPose { quantities, places }], self.gravity);
        for (index, load) in self.loads.iter().enumerate() {
            totals.load = index + 1;
            load.add(&self.bodies, is_space, &mut totals)?;
        }
        if !totals.are_finite() {
            return Err(LoadError::NotFinite);
        }
        let [effort] = totals.effort;
        Ok(core::array::from_fn(|order| effort[order]))
    }
}

impl NamedLoad {
    fn add<T: Scalar>(
        self,
        bodies: &[NamedBody],
        is_space: bool,
        totals: &mut Totals<ByNames<'_, T>>,
    ) -> Result<(), LoadError> {
        match self {
            Self::Body(mass, inertia, centre, _, frame) => {
                let frame = |pose: NamedPose<'_, T>| pose.frame(frame);
                let (mass, centre) = match centre {
                    PointIndex::Fixed(centre) if is_space => (mass, [centre_on_line(centre, totals.load)?, 0.0]),
                    PointIndex::Fixed(centre) => (mass, [centre.x, centre.y]),
                    PointIndex::Moving(_) => {
                        let point = |pose: NamedPose<'_, T>| pose.point(centre);
                        Mass { mass, point }.add(totals)?;
                        (0.0, [0.0; 2])
                    }
                };
                PlaneBody {
                    mass,
                    centre,
                    inertia,
                    frame,
                }
                .add(totals)
            }
            Self::Solid(solid, body) => {
                let load = totals.load;
                if !is_space {
                    return Err(LoadError::SolidInPlane { load });
                }
                let joints = &bodies[body].joints;
                let corners = totals.poses[0].corners(joints).ok_or(LoadError::Collinear { load })?;
                let points = |pose: NamedPose<'_, T>| corners.map(|joint| PointMotion(pose.places[joint]));
                SpaceBody { solid, points }.add(totals)
            }
            Self::Mass(mass, point) => {
                let point = |pose: NamedPose<'_, T>| pose.point(point);
                Mass { mass, point }.add(totals)
            }
            Self::Inertia(moment, angle) => {
                let (angle, axis) = (|pose: NamedPose<'_, T>| pose.number(angle), Space::new(0.0, 0.0, 1.0));
                Inertia { moment, axis, angle }.add(totals)
            }
            Self::Force(force, point) => {
                let point = |pose: NamedPose<'_, T>| pose.point(point);
                Force { force, point }.add(totals)
            }
            Self::Torque(torque, angle) => {
                let angle = |pose: NamedPose<'_, T>| pose.number(angle);
                Torque { torque, angle }.add(totals)
            }
            Self::Spring(kind, [from, to]) => {
                let [from, to] = [from, to].map(|end| move |pose: NamedPose<'_, T>| pose.point(end));
                BetweenPoints { kind, from, to }.add(totals)
            }
            Self::Damper(kind, [from, to]) => {
                let [from, to] = [from, to].map(|end| move |pose: NamedPose<'_, T>| pose.point(end));
                BetweenPoints { kind, from, to }.add(totals)
            }
            Self::TorsionSpring(kind, angle) => {
                let angle = |pose: NamedPose<'_, T>| pose.number(angle);
                OnAngle { kind, angle }.add(totals)
            }
            Self::TorsionDamper(kind, angle) => {
                let angle = |pose: NamedPose<'_, T>| pose.number(angle);
                OnAngle { kind, angle }.add(totals)
            }
        }
    }
}

/// The quantities of a mechanism, of which one input moves.
#[derive(Clone, Copy)]
struct ByNames<'p, T>(PhantomData<&'p T>);

impl<'p, T: Scalar> LoadedSystem for ByNames<'p, T> {
    type Scalar = T;
    type Motion<V: Copy> = [V; ENTRIES];
    type Inputs<V: Copy> = [V; 1];
    type Moving = NamedPose<'p, T>;
}

#[derive(Clone, Copy)]
struct NamedPose<'p, T> {
    quantities: &'p [NamedMotion<T>],
    /// The joints and the directions of the picture.
    places: &'p [[NamedMotion<T>; 3]],
}

impl<T: Scalar> NamedPose<'_, T> {
    fn number(self, index: usize) -> NumberMotion<T> {
        NumberMotion(self.quantities[index])
    }

    /// The origin of the frame of a body, and a vector along it.
    fn frame(self, frame: BodyFrame) -> [PointMotion<T>; 2] {
        let minus = |end: [NamedMotion<T>; 3], start: [NamedMotion<T>; 3]| {
            core::array::from_fn(|axis| core::array::from_fn(|order| end[axis][order] - start[axis][order]))
        };
        frame.origin_and_axis(self.places, minus).map(PointMotion)
    }

    /// Three joints that do not lie on a line.
    fn corners(self, joints: &[usize]) -> Option<[usize; 3]> {
        let [a, b, others @ ..] = joints else { return None };
        let from = |joint: usize| {
            let [x, y, z] = [0, 1, 2].map(|axis| {
                let [end, start] = [joint, *a].map(|joint| self.places[joint][axis][0].real());
                end - start
            });
            Space::new(x, y, z)
        };
        let along = from(*b);
        let third = third_point(along.scale(1.0 / along.norm()), others.iter().map(|joint| from(*joint)))?;
        Some([*a, *b, others[third]])
    }

    fn point(self, point: PointIndex) -> PointMotion<T> {
        let still = |value: f64| core::array::from_fn(|order| value.entry(order));
        PointMotion(match point {
            PointIndex::Moving(coordinates) => {
                coordinates.map(|index| index.map_or_else(|| still(0.0), |index| self.quantities[index]))
            }
            PointIndex::Fixed(Space { x, y, z }) => [x, y, z].map(still),
        })
    }
}

#[derive(Clone, Copy)]
struct NumberMotion<T>(NamedMotion<T>);

impl<T: Number> VaryingNumber<Change<T>> for NumberMotion<T> {
    const ENTRIES: usize = ENTRIES;

    fn entry(&self, order: usize) -> Change<T> {
        self.0[order]
    }
}

#[derive(Clone, Copy)]
struct PointMotion<T>([NamedMotion<T>; 3]);

impl<T: Number> VaryingVector<Change<T>> for PointMotion<T> {
    const ENTRIES: usize = ENTRIES;

    fn entry(&self, order: usize) -> Space<Change<T>> {
        let [x, y, z] = self.0;
        Space::new(x[order], y[order], z[order])
    }
}
