//! Contacts that roll: gears in mesh, a gear on a rack, a wheel on its track.

use alloc::string::ToString;
use alloc::vec::Vec;
use core::fmt;

use super::action::Influence;
use super::connection::{Connection, Member};
use super::frames::{MovedFrame, MovedMechanism, MovingNumber, across, real, slope_of, unit};
use super::{MovedNumber, NamedReactions, ReactionError, ReactionPlace};
use crate::any::PositionChoice;
use crate::geometry::Space;
use crate::load::{LoadPoint, LoadedKind, NoSuchName, PointIndex};
use crate::motion::Motion;
use crate::number::Number;
use crate::quantity::Digits;

/// Two bodies of the plane that roll on each other without slip, along their pitch curves.
///
/// The centres are points that the bodies hold, and the radii those of the pitch circles. The pitch point follows from
/// both, and the motion must agree with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rolling<'n> {
    pitch: Pitch<LoadPoint<'n>>,
    pressure_angle: f64,
}

impl<'n> Rolling<'n> {
    /// Two gears with these centres and radii, in mesh on the outside or on the inside of one of them.
    #[must_use]
    pub fn gears(first: impl Into<LoadPoint<'n>>, second: impl Into<LoadPoint<'n>>, radii: [f64; 2]) -> Self {
        let centres = [first.into(), second.into()];
        Self {
            pitch: Pitch::Gears { centres, radii },
            pressure_angle: 0.0,
        }
    }

    /// A gear or a wheel with this centre and radius, on a rack or a track in a direction, which may be a vector of the
    /// mechanism or one of the ground, of any length.
    #[must_use]
    pub fn rack(centre: impl Into<LoadPoint<'n>>, radius: f64, along: impl Into<LoadPoint<'n>>) -> Self {
        let (centre, along) = (centre.into(), along.into());
        Self {
            pitch: Pitch::Rack { centre, radius, along },
            pressure_angle: 0.0,
        }
    }

    /// The same with a pressure angle: teeth push the bodies apart, too, by the tangent of this angle times the
    /// tangential force. Without it, the force is tangential.
    #[must_use]
    pub fn at_pressure_angle(mut self, angle: f64) -> Self {
        self.pressure_angle = angle;
        self
    }
}

/// Where two bodies touch.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Pitch<P> {
    Gears { centres: [P; 2], radii: [f64; 2] },
    Rack { centre: P, radius: f64, along: P },
}

/// A contact as a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Mesh {
    pitch: Pitch<PointIndex>,
    /// The tangent of the pressure angle.
    slope: f64,
}

/// Where the force of a contact acts, and its direction for a unit of the tangential force.
#[derive(Clone, Copy, Debug)]
pub(super) struct PitchPoint<T> {
    pub(super) at: Space<T>,
    tangent: Space<T>,
    /// The direction in which the body that is declared later is pushed away.
    apart: Space<T>,
}

/// How a contact bears.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Flank {
    /// The side of the first centre on which its pitch point lies.
    pub(super) side: f64,
    /// The sign of the tangential force, by which one flank of the teeth bears.
    pub(super) sign: f64,
}

impl<T: MovingNumber> PitchPoint<T> {
    /// The tangential part of a force, by whose sign a flank bears; none if the contact has no pressure angle.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn tangential(&self, mesh: &Mesh, force: Space<T>) -> Option<T> {
        (mesh.slope != 0.0).then(|| self.tangent.dot(force))
    }

    /// The force for a unit of the tangential one, where this has a sign.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn force(&self, mesh: &Mesh, sign: f64) -> Space<T> {
        self.tangent + self.apart.scale(T::constant(sign * mesh.slope))
    }
}

/// What is wrong in the statement of a contact that rolls.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum RollingMistake {
    /// The mechanism is one of space.
    InSpace,
    /// A radius is not above zero, or not finite.
    Radius(f64),
    /// The pressure angle is not one of 0 .. π/2.
    PressureAngle(f64),
    /// A reaction has this name already.
    Twice,
    /// The distance of the centres is neither the sum nor the difference of the radii.
    Distance(f64),
    /// Neither flank of the teeth bears the force.
    NoFlank,
    /// It is no joint of the picture.
    NoJoint,
    /// The bodies slip on each other at this speed, per unit of an input.
    Slips(f64),
}

impl fmt::Display for RollingMistake {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::InSpace => {
                formatter.write_str("gears and racks are those of the plane, and the mechanism is one of space")
            }
            Self::Radius(value) => write!(formatter, "the radius is {value}: give one above zero"),
            Self::PressureAngle(value) => {
                write!(
                    formatter,
                    "the pressure angle is {value}: give one from zero on, below a right angle"
                )
            }
            Self::Twice => formatter.write_str("a reaction has this name already: give another one"),
            Self::Distance(distance) => write!(
                formatter,
                "the distance of the centres is {}, which is neither the sum of the radii nor their difference",
                Digits(*distance)
            ),
            Self::NoFlank => {
                formatter.write_str("neither flank of its teeth bears the force: leave out the pressure angle")
            }
            Self::NoJoint => formatter.write_str("it is a contact, which is no joint of the picture"),
            Self::Slips(rate) => write!(
                formatter,
                "its bodies slip on each other by {} per unit of an input: the radii, the centres or the direction do \
                 not agree with the equation by which they move",
                Digits(*rate)
            ),
        }
    }
}

/// Speeds and distances agree up to this part of the largest: half of the digits.
const AGREEMENT: f64 = 1e-7;

impl NamedReactions<'_> {
    /// The same with a contact in which two bodies roll on each other, as gears do. Its force acts on the second body.
    /// The ground is called `ground`.
    ///
    /// ```
    /// use kin_core::any::PositionChoice;
    /// use kin_core::linkage::AnyLinkage;
    /// use kin_core::prelude::*;
    /// use kin_core::reaction::Rolling;
    ///
    /// mechanism! {
    ///     /// Two gears, in metres.
    ///     struct Pair { pinion: Length, wheel: Length }
    ///     input theta: Angle;
    ///     unknown phi: Angle;
    ///     wheel * phi == -pinion * theta;
    ///     output pivot: Point = vec2(pinion + wheel, 0);
    ///     ground 0, pivot;
    ///     body pinion: 0, polar(pinion, theta);
    ///     body wheel: pivot, vec2(pinion + wheel, 0) + polar(wheel, phi);
    /// }
    ///
    /// let linkage = AnyLinkage::of(&Pair { pinion: 0.02, wheel: 0.06 });
    /// let loads = linkage.loads().torque(-30.0, "phi")?;
    /// let gears = Rolling::gears(Plane::zero(), "pivot", [0.02, 0.06]).at_pressure_angle(20_f64.to_radians());
    /// let reactions = linkage.reactions(&loads)?.rolling("mesh", ["pinion", "wheel"], gears)?;
    /// reactions.check_contacts(&[0.3], PositionChoice::Assembly(0))?;
    /// let found = reactions.at(&[Motion::at_constant_speed(0.3, 5.0)], PositionChoice::Assembly(0))?;
    /// let [force, ..] = found.of("mesh")?.magnitude();
    /// assert!((force - 500.0 / 20_f64.to_radians().cos()).abs() < 1e-10);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ReactionError::Rolling`] for what no contact has, and [`ReactionError::NoSuchName`] if no body or point has a
    /// name.
    pub fn rolling(mut self, name: &str, bodies: [&str; 2], rolling: Rolling<'_>) -> Result<Self, ReactionError> {
        let Rolling { pitch, pressure_angle } = rolling;
        let radii = match pitch {
            Pitch::Gears { radii, .. } => radii,
            Pitch::Rack { radius, .. } => [radius; 2],
        };
        let wrong = radii.into_iter().find(|radius| !(radius.is_finite() && *radius > 0.0));
        let is_angle = (0.0..core::f64::consts::FRAC_PI_2).contains(&pressure_angle);
        let mistake = if self.functions.is_space() {
            Some(RollingMistake::InSpace)
        } else if self.names().any(|own| own == name) {
            Some(RollingMistake::Twice)
        } else if is_angle {
            wrong.map(RollingMistake::Radius)
        } else {
            Some(RollingMistake::PressureAngle(pressure_angle))
        };
        if let Some(mistake) = mistake {
            let reaction = name.to_string();
            return Err(ReactionError::Rolling { reaction, mistake });
        }
        let point = |point: LoadPoint<'_>| self.loads.load_point(point);
        let pitch = match pitch {
            Pitch::Gears {
                centres: [one, other],
                radii,
            } => Pitch::Gears {
                centres: [point(one)?, point(other)?],
                radii,
            },
            Pitch::Rack { centre, radius, along } => Pitch::Rack {
                centre: point(centre)?,
                radius,
                along: point(along)?,
            },
        };
        let [by, on] = [self.member(bodies[0])?, self.member(bodies[1])?];
        self.connections.push(Connection {
            name: name.to_string(),
            on,
            by,
            joint: None,
            slide: None,
            hinge: None,
            mesh: Some(Mesh {
                pitch,
                slope: Number::tan(pressure_angle),
            }),
        });
        self.solutions.forget();
        Ok(self)
    }

    /// Whether the bodies of all contacts roll on each other in a position, as in the example of
    /// [`rolling`](Self::rolling). The forces in joints ask for the same.
    ///
    /// # Errors
    /// [`ReactionError::Rolling`] for a contact that does not roll, and those of a mechanism that has no pose there.
    pub fn check_contacts(&self, inputs: &[f64], choice: PositionChoice<'_, f64>) -> Result<(), ReactionError> {
        let inputs: Vec<Motion> = inputs.iter().copied().map(Motion::constant).collect();
        let unknowns = self.unknowns_at(&inputs, choice)?;
        let place = self.place(&inputs, &unknowns);
        self.touching(&place, place.parameters).map(|_| ())
    }

    /// How contacts touch in a design at a place. Bodies must be rigid, and contacts roll.
    pub(super) fn touching(&self, place: &ReactionPlace<'_>, parameters: &[f64]) -> Result<Vec<Flank>, ReactionError> {
        let outline = place.functions.outline();
        self.flanks(&place.influences(parameters, &outline, &self.connections, None)?)
    }

    /// Where contacts touch at a place, none of what is no contact.
    pub(super) fn pitch_points(
        &self,
        place: &ReactionPlace<'_>,
        moved: &MovedMechanism<MovedNumber>,
    ) -> Result<Vec<Option<Space<f64>>>, ReactionError> {
        if self.connections.iter().all(|own| own.mesh.is_none()) {
            return Ok(Vec::new());
        }
        let flanks = self.touching(place, place.parameters)?;
        let all = self.connections.iter().zip(flanks);
        Ok(all
            .map(|(own, flank)| Some(real(own.mesh?.pitch_point(moved, flank.side).at)))
            .collect())
    }

    /// A body by its name.
    fn member(&self, name: &str) -> Result<Member, NoSuchName> {
        let bodies = self.functions.outline().bodies;
        if name == "ground" {
            return Ok(None);
        }
        let body = bodies.iter().position(|body| body.name == name);
        body.map(Some).ok_or_else(|| NoSuchName {
            name: name.to_string(),
            kind: LoadedKind::Body,
            names: bodies.iter().map(|body| body.name.to_string()).collect(),
        })
    }
}

impl Mesh {
    /// The points on which it depends.
    pub(super) fn points(&self) -> [PointIndex; 2] {
        match self.pitch {
            Pitch::Gears { centres, .. } => centres,
            Pitch::Rack { centre, along, .. } => [centre, along],
        }
    }

    /// Whether teeth push the bodies apart.
    pub(super) fn has_pressure_angle(&self) -> bool {
        self.slope != 0.0
    }

    /// The pitch point on one side of the first centre.
    #[inline(never)]
    pub(super) fn pitch_point<T: MovingNumber>(&self, moved: &MovedMechanism<T>, side: f64) -> PitchPoint<T> {
        match self.pitch {
            Pitch::Gears { centres, radii } => {
                let [first, second] = centres.map(|centre| moved.point(centre));
                let line = unit(second - first);
                let [tangent, _] = across(line, false);
                let out = line.scale(T::constant(side));
                let at = first + out.scale(T::constant(radii[0]));
                // the teeth of the smaller gear are outer ones, and are pushed towards its centre
                let apart = if radii[0] <= radii[1] { out } else { unit(second - at) };
                PitchPoint { at, tangent, apart }
            }
            Pitch::Rack { centre, radius, along } => {
                let tangent = unit(moved.point(along));
                let [left, _] = across(tangent, false);
                let apart = left.scale(T::constant(side));
                let at = moved.point(centre) + apart.scale(T::constant(radius));
                PitchPoint { at, tangent, apart }
            }
        }
    }

    /// The side of the first centre on which the bodies roll on each other, in whichever way the inputs move.
    pub(super) fn side<const N: usize>(
        &self,
        [on, by]: [Member; 2],
        influences: &[Influence<N>],
    ) -> Result<f64, RollingMistake> {
        let sides: &[f64] = match (self.pitch, influences.first()) {
            (Pitch::Gears { centres, radii }, Some(Influence { moved, .. })) => {
                let [first, second] = centres.map(|centre| moved.point(centre));
                let distance = (second - first).norm().real();
                let [one, other] = radii;
                let is = |wanted: f64| (distance - wanted).abs() <= AGREEMENT * (one + other);
                match (is(one + other) || is(one - other), is(other - one)) {
                    (true, _) => &[1.0],
                    (_, true) => &[-1.0],
                    _ => return Err(RollingMistake::Distance(distance)),
                }
            }
            _ => &[1.0, -1.0],
        };
        let slip = |side: f64| {
            let slips = influences.iter().map(|Influence { moved, frames }| {
                let PitchPoint { at, tangent, .. } = self.pitch_point(moved, side);
                let velocity = |member: Member| {
                    member.map_or_else(Space::zero, |body: usize| MovedFrame::velocity(&frames[body], at))
                };
                let joints = moved.places[..moved.joints].iter();
                let largest = joints.map(|joint| slope_of(*joint).norm_squared().real());
                let largest = Number::sqrt(largest.fold(0.0, f64::max));
                let rate = (velocity(on) - velocity(by)).dot(tangent).real().abs();
                (rate, rate <= AGREEMENT * largest)
            });
            slips.fold((0.0, true), |(largest, all): (f64, bool), (rate, rolls)| {
                (largest.max(rate), all && rolls)
            })
        };
        let slips = sides.iter().map(|side| (*side, slip(*side)));
        let best = slips.min_by(|(_, (one, _)), (_, (other, _))| one.total_cmp(other));
        match best {
            Some((side, (_, true))) => Ok(side),
            Some((_, (rate, false))) => Err(RollingMistake::Slips(rate)),
            None => Err(RollingMistake::Slips(f64::NAN)),
        }
    }
}
