//! What the loads and the inertia of bodies ask of the joints and drives.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::ReactionError;
use super::action::{Action, Exertion, Influences};
use super::body_load::BodyLoadKind;
use super::connection::{Member, loaded, member_name};
use super::frames::{MovedFrame, MovedMechanism, MovingNumber, Shortened, slope_of, still, times, unit};
use super::pose_number::PoseNumber as _;
use crate::geometry::Space;
use crate::load::{BodyFrame, LoadError, NamedLoad, NamedLoads, PointIndex, centre_on_line, not_negative};
use crate::mechanism::Description;
use crate::number::Number as _;
use crate::quantity::Dimension;

/// Where a load acts. It is the same in all poses.
#[derive(Clone, Copy, Debug)]
pub(super) enum LoadPlace {
    /// On the body of the load itself.
    Own,
    /// At one or two points, which these hold.
    Points([Member; 2]),
    /// On an angle or along a distance.
    Quantity(Action),
}

impl LoadPlace {
    /// The places of all loads.
    pub(super) fn all<const N: usize>(
        loads: &NamedLoads,
        description: &Description<'_>,
        influences: &Influences<'_, '_, N>,
    ) -> Result<Vec<Self>, ReactionError> {
        let loads = loads.all().iter().enumerate().map(|(index, load)| {
            let search = PlaceSearch {
                loads,
                load: index + 1,
                description,
                influences,
            };
            search.place(*load)
        });
        loads.collect()
    }
}

/// A search for the place of a load, by its number from 1 on.
struct PlaceSearch<'s, const N: usize> {
    loads: &'s NamedLoads,
    load: usize,
    description: &'s Description<'s>,
    influences: &'s Influences<'s, 's, N>,
}

impl<const N: usize> PlaceSearch<'_, N> {
    fn place(&self, load: NamedLoad) -> Result<LoadPlace, ReactionError> {
        Ok(match load {
            NamedLoad::Body(..) | NamedLoad::Solid(..) => LoadPlace::Own,
            NamedLoad::Mass(_, point) | NamedLoad::Force(_, point) => LoadPlace::Points([self.holder(point)?, None]),
            NamedLoad::Spring(_, ends) | NamedLoad::Damper(_, ends) => {
                LoadPlace::Points([self.holder(ends[0])?, self.holder(ends[1])?])
            }
            NamedLoad::Inertia(_, angle) => {
                let what = self.what(&format!("the inertia of `{}`", self.loads.name(angle)));
                let found = |influences: &Influences<'_, '_, N>| influences.against_ground(angle);
                LoadPlace::Quantity(self.influences.action(what, found, |_| true)?)
            }
            NamedLoad::Torque(_, quantity)
            | NamedLoad::TorsionSpring(_, quantity)
            | NamedLoad::TorsionDamper(_, quantity) => {
                let what = self.what(&format!("the torque or force on `{}`", self.loads.name(quantity)));
                let dimension = self.dimension(quantity);
                let found = |influences: &Influences<'_, '_, N>| influences.actions(quantity, dimension);
                LoadPlace::Quantity(self.influences.action(what, found, |_| true)?)
            }
        })
    }

    fn dimension(&self, quantity: usize) -> Dimension {
        let Description {
            parameters,
            inputs,
            unknowns,
            outputs,
            ..
        } = self.description;
        let mut all = [parameters, inputs, unknowns, outputs].into_iter().copied().flatten();
        all.nth(quantity)
            .map_or(Dimension::Scalar, |quantity| quantity.dimension)
    }

    fn what(&self, load: &str) -> String {
        format!("load {}, {load},", self.load)
    }

    /// The body that holds a point. What stands still is held by the ground.
    fn holder(&self, point: PointIndex) -> Result<Member, ReactionError> {
        let Some(name) = self.loads.point_name(point) else {
            return Ok(None);
        };
        let outline = self.influences.outline;
        let joint = outline.points.iter().find(|(own, _)| *own == name);
        let holders = joint.map_or_else(Vec::new, |(_, joint)| loaded(outline, *joint));
        match holders[..] {
            [by] => Ok(by),
            _ => Err(ReactionError::Place {
                what: self.what(&format!("at `{name}`")),
                places: holders.iter().map(|member| member_name(outline, *member)).collect(),
            }),
        }
    }
}

/// The parts of which a load may consist.
pub(super) const PARTS: usize = 2;

/// What the loads exert on the bodies.
pub(super) struct Demand<'d, T> {
    pub(super) loads: &'d NamedLoads,
    /// The places of the loads.
    pub(super) places: &'d [LoadPlace],
    pub(super) moved: &'d MovedMechanism<T>,
    pub(super) frames: &'d [MovedFrame<T>],
    /// The change of the variable of the numbers for each unit of time.
    pub(super) rate: f64,
}

/// A point on which a load acts, and the body that holds it.
#[derive(Clone, Copy)]
struct Held<T> {
    at: Space<T>,
    by: Member,
}

impl<T: MovingNumber> Demand<'_, T> {
    /// Passes on all that acts on the bodies.
    pub(super) fn each(&self, found: &mut impl FnMut(BodyLoadKind, &Exertion<T>)) -> Result<(), ReactionError>
    where
        T: Shortened<T>,
    {
        for load in 0..self.places.len() {
            for part in 0..PARTS {
                if let Some((kind, exertion)) = self.exertion(load, part)? {
                    found(kind, &exertion);
                }
            }
        }
        Ok(())
    }

    /// The derivative by time.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn by_time(&self, series: T) -> T {
        series.slope().times(self.rate)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn acceleration(&self, point: Space<T>) -> Space<T> {
        times(slope_of(slope_of(point)), self.rate * self.rate)
    }

    /// A part of what a load exerts, by the index of the load: a mass and its moment of inertia are two.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn exertion<F: MovingNumber>(
        &self,
        load: usize,
        part: usize,
    ) -> Result<Option<(BodyLoadKind, Exertion<F>)>, ReactionError>
    where
        T: Shortened<F>,
    {
        let (number, place, load) = (load + 1, self.places[load], &self.loads.all()[load]);
        if part == 1 && !matches!(load, NamedLoad::Body(..) | NamedLoad::Solid(..)) {
            return Ok(None);
        }
        let held = |point: PointIndex, end: usize| {
            let at = self.moved.point(point);
            let by = if let LoadPlace::Points(members) = place {
                members[end]
            } else {
                None
            };
            Held { at, by }
        };
        let of = |kind: BodyLoadKind, exertion: Exertion<T>| Ok(Some((kind, Exertion::shortened(&exertion))));
        let applied = |exertion: Exertion<T>| of(BodyLoadKind::Applied, exertion);
        let (kind, size) = match *load {
            NamedLoad::Body(_, inertia, _, body, frame) if part == 1 => {
                not_negative(number, "moment of inertia", inertia)?;
                return of(BodyLoadKind::Mass, self.rod(inertia, frame, body));
            }
            NamedLoad::Body(mass, _, centre, body, frame) => {
                let at = match centre {
                    PointIndex::Fixed(centre) if self.moved.is_space => {
                        let centre = centre_on_line(centre, number)?;
                        let [origin, along] = frame.origin_and_axis(&self.moved.places, |end, start| end - start);
                        origin + along.scale(T::constant(centre) / along.norm())
                    }
                    PointIndex::Fixed(centre) => self.frames[body].place(centre),
                    PointIndex::Moving(_) => self.moved.point(centre),
                };
                not_negative(number, "mass", mass)?;
                return of(BodyLoadKind::Mass, self.inertial(mass, Held { at, by: Some(body) }));
            }
            NamedLoad::Solid(..) if !self.moved.is_space => {
                return Err(LoadError::SolidInPlane { load: number }.into());
            }
            NamedLoad::Solid(solid, body) => {
                solid.check(number)?;
                not_negative(number, "mass", solid.mass)?;
                if part == 1 {
                    return of(BodyLoadKind::Mass, self.tensor(solid.inertia, body));
                }
                let at = self.frames[body].place(solid.centre);
                let held = Held { at, by: Some(body) };
                return of(BodyLoadKind::Mass, self.inertial(solid.mass, held));
            }
            NamedLoad::Mass(mass, point) => {
                not_negative(number, "mass", mass)?;
                return of(BodyLoadKind::Mass, self.inertial(mass, held(point, 0)));
            }
            NamedLoad::Force(force, point) => {
                let (held, force) = (held(point, 0), still(self.shown(force)));
                return applied(Exertion::of_force([held.by, None], force, [held.at; 2]));
            }
            NamedLoad::Spring(spring, [from, to]) => {
                let ends = [held(from, 0), held(to, 1)];
                let line = ends[1].at - ends[0].at;
                let force = if spring.rest == 0.0 {
                    times(line, spring.stiffness)
                } else {
                    let length = length(number, line)?;
                    let stretch = T::constant(1.0) - T::constant(spring.rest) / length;
                    line.scale(stretch.times(spring.stiffness))
                };
                return applied(pull(ends, force));
            }
            NamedLoad::Damper(damper, [from, to]) => {
                let ends = [held(from, 0), held(to, 1)];
                let line = ends[1].at - ends[0].at;
                let length = length(number, line)?;
                let force = line.scale((self.by_time(length) / length).times(damper.damping));
                return applied(pull(ends, force));
            }
            NamedLoad::Inertia(inertia, angle) => {
                not_negative(number, "moment of inertia", inertia)?;
                let acceleration = self.by_time(self.by_time(self.moved.quantities[angle]));
                (BodyLoadKind::Mass, acceleration.times(-inertia))
            }
            NamedLoad::Torque(torque, _) => (BodyLoadKind::Applied, T::constant(torque)),
            NamedLoad::TorsionSpring(spring, quantity) => {
                let twist = self.moved.quantities[quantity] - T::constant(spring.rest);
                (BodyLoadKind::Applied, twist.times(-spring.stiffness))
            }
            NamedLoad::TorsionDamper(damper, quantity) => {
                let speed = self.by_time(self.moved.quantities[quantity]);
                (BodyLoadKind::Applied, speed.times(-damper.damping))
            }
        };
        let LoadPlace::Quantity(action) = place else {
            return Ok(None);
        };
        of(kind, action.exertion(self.moved, size))
    }

    /// The weight of a mass, and its resistance to acceleration.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn inertial(&self, mass: f64, held: Held<T>) -> Exertion<T> {
        let gravity = still(self.shown(self.loads.acceleration_of_gravity()));
        let lacking = times(gravity - self.acceleration(held.at), mass);
        Exertion::of_force([held.by, None], lacking, [held.at; 2])
    }

    /// The couple of a moment of inertia about the axes at right angles to the axis of the frame of a body.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rod(&self, inertia: f64, frame: BodyFrame, body: usize) -> Exertion<T> {
        // the arms ξ e have the angular momentum ξ² e × e', and its rate is ξ² e × e''
        let momentum = if self.frames[body].is_plane() {
            self.frames[body].turn
        } else {
            let [_, along] = frame.origin_and_axis(&self.moved.places, |end, start| end - start);
            let axis = unit(along);
            axis.cross(slope_of(axis))
        };
        let lacking = times(slope_of(momentum), -self.rate * self.rate * inertia);
        Exertion::of_couple([Some(body), None], lacking)
    }

    /// The couple of a tensor of inertia along the axes of the frame of a body, about its centre.
    #[inline(never)]
    fn tensor(&self, inertia: [[f64; 3]; 3], body: usize) -> Exertion<T> {
        let MovedFrame { axes, turn, .. } = self.frames[body];
        let rates = axes.map(|axis| axis.dot(turn));
        let mut momentum = Space::zero();
        for (row, axis) in axes.into_iter().enumerate() {
            for (column, rate) in rates.into_iter().enumerate() {
                let mean = 0.5 * (inertia[row][column] + inertia[column][row]);
                momentum = momentum + axis.scale(rate.times(mean));
            }
        }
        Exertion::of_couple([Some(body), None], times(slope_of(momentum), -self.rate * self.rate))
    }

    /// A vector as the mechanism shows it: one of the plane has no third coordinate.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shown(&self, vector: Space<f64>) -> Space<f64> {
        let z = if self.moved.is_space { vector.z } else { 0.0 };
        Space { z, ..vector }
    }
}

/// A force on the first end towards the second one, and the opposite one there.
#[cfg_attr(not(debug_assertions), inline(always))]
fn pull<T: MovingNumber>([from, to]: [Held<T>; 2], force: Space<T>) -> Exertion<T> {
    Exertion::of_force([from.by, to.by], force, [from.at, to.at])
}

/// The length of the line along which a load acts, by the number of the load.
#[cfg_attr(not(debug_assertions), inline(always))]
fn length<T: MovingNumber>(load: usize, line: Space<T>) -> Result<T, LoadError> {
    let square = line.norm_squared();
    if square.now().exceeds(f64::MIN_POSITIVE, T::Still::constant(1.0)) {
        Ok(square.sqrt())
    } else {
        Err(LoadError::NoDirection { load })
    }
}
