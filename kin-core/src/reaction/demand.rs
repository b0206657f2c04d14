//! What the loads and the inertia of bodies ask of the joints and drives.

use alloc::format;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

use super::action::{Action, Influences, Wrench, both};
use super::body_load::{Acting, BodyLoadKind};
use super::connection::{Member, loaded, member_name};
use super::frames::{MovedFrame, MovedMechanism, MovingNumber, left, slope_of};
use super::{REACH, ReactionError};
use crate::geometry::{Plane, Space};
use crate::load::{LoadError, NamedLoad, NamedLoads, PointIndex, not_negative};
use crate::mechanism::Description;
use crate::quantity::Dimension;

/// The sums of the forces that each body lacks, and of their moments about the origin of its frame.
pub(super) struct Demand<'d, T> {
    pub(super) loads: &'d NamedLoads,
    pub(super) description: &'d Description<'d>,
    pub(super) influences: &'d Influences<'d, 'd, REACH>,
    pub(super) moved: &'d MovedMechanism<T>,
    pub(super) frames: &'d [MovedFrame<T>],
    /// The change of the variable of the numbers for each unit of time.
    pub(super) rate: f64,
    pub(super) bodies: Vec<Wrench<T>>,
    /// All that acts on the bodies, one after the other.
    pub(super) acting: Vec<Acting<T>>,
    /// The place of the load that is being added, from 1 on.
    pub(super) load: usize,
}

/// A point on which a load acts, and the body that holds it.
#[derive(Clone, Copy)]
struct Held<T> {
    at: Plane<T>,
    by: Member,
}

impl<'d, T: MovingNumber> Demand<'d, T> {
    /// What all loads ask.
    pub(super) fn of(
        loads: &'d NamedLoads,
        description: &'d Description<'d>,
        influences: &'d Influences<'d, 'd, REACH>,
        moved: &'d MovedMechanism<T>,
        frames: &'d [MovedFrame<T>],
        rate: f64,
    ) -> Result<Self, ReactionError> {
        let mut demand = Self {
            loads,
            description,
            influences,
            moved,
            frames,
            rate,
            bodies: vec![Wrench::of_moment(T::constant(0.0)); frames.len()],
            acting: Vec::new(),
            load: 0,
        };
        for (place, load) in loads.all().iter().enumerate() {
            demand.load = place + 1;
            demand.add(*load)?;
        }
        Ok(demand)
    }

    /// The derivative by time.
    fn by_time(&self, series: T) -> T {
        series.slope() * T::constant(self.rate)
    }

    fn acceleration(&self, point: Plane<T>) -> Plane<T> {
        slope_of(slope_of(point)).scale(T::constant(self.rate * self.rate))
    }

    fn subtract(&mut self, kind: BodyLoadKind, wrenches: Vec<(usize, Wrench<T>)>) {
        for (body, wrench) in wrenches {
            self.acting.push((kind, body, wrench));
            let sum = &mut self.bodies[body];
            sum.force = sum.force - wrench.force;
            sum.moment = sum.moment - wrench.moment;
        }
    }

    fn add(&mut self, load: NamedLoad) -> Result<(), ReactionError> {
        match load {
            NamedLoad::Body(mass, inertia, centre, body, _) => {
                let at = match centre {
                    PointIndex::Fixed(Space { x, y, .. }) => {
                        let MovedFrame { origin, axis, .. } = self.frames[body];
                        origin + axis.scale(T::constant(x)) + left(axis).scale(T::constant(y))
                    }
                    PointIndex::Moving(_) => self.point(centre),
                };
                self.add_mass(mass, Held { at, by: Some(body) })?;
                self.add_inertia(inertia, body)?;
            }
            NamedLoad::Mass(mass, point) => {
                let held = self.held(point)?;
                self.add_mass(mass, held)?;
            }
            NamedLoad::Inertia(inertia, angle) => {
                let what = self.what(&format!("the inertia of `{}`", self.loads.name(angle)));
                let found = |influences: &Influences<'_, '_, REACH>| influences.against_ground(angle);
                let Action { on, .. } = self.influences.action(what, found, |_| true)?;
                if let Some(body) = on {
                    self.add_inertia(inertia, body)?;
                }
            }
            NamedLoad::Force(force, point) => {
                let held = self.held(point)?;
                let force = Plane::new(T::constant(force.x), T::constant(force.y));
                let wrenches = both([held.by, None], self.frames, force, [held.at; 2]);
                self.subtract(BodyLoadKind::Applied, wrenches);
            }
            NamedLoad::Torque(torque, quantity) => self.act(quantity, T::constant(torque))?,
            NamedLoad::TorsionSpring(spring, quantity) => {
                let twist = self.moved.quantities[quantity] - T::constant(spring.rest);
                self.act(quantity, -twist * T::constant(spring.stiffness))?;
            }
            NamedLoad::TorsionDamper(damper, quantity) => {
                let speed = self.by_time(self.moved.quantities[quantity]);
                self.act(quantity, -speed * T::constant(damper.damping))?;
            }
            NamedLoad::Spring(spring, ends) => {
                let ends = self.ends(ends)?;
                let line = ends[1].at - ends[0].at;
                let force = if spring.rest == 0.0 {
                    line.scale(T::constant(spring.stiffness))
                } else {
                    let length = self.length(line)?;
                    let stretch = T::constant(1.0) - T::constant(spring.rest) / length;
                    line.scale(stretch * T::constant(spring.stiffness))
                };
                self.pull(ends, force);
            }
            NamedLoad::Damper(damper, ends) => {
                let ends = self.ends(ends)?;
                let line = ends[1].at - ends[0].at;
                let length = self.length(line)?;
                let force = line.scale(self.by_time(length) / length * T::constant(damper.damping));
                self.pull(ends, force);
            }
        }
        Ok(())
    }

    /// A force on the first end towards the second one, and the opposite one there.
    fn pull(&mut self, [from, to]: [Held<T>; 2], force: Plane<T>) {
        let wrenches = both([from.by, to.by], self.frames, force, [from.at, to.at]);
        self.subtract(BodyLoadKind::Applied, wrenches);
    }

    fn length(&self, line: Plane<T>) -> Result<T, LoadError> {
        let square = line.norm_squared();
        if square.real() > f64::MIN_POSITIVE {
            Ok(square.sqrt())
        } else {
            Err(LoadError::NoDirection { load: self.load })
        }
    }

    fn add_mass(&mut self, mass: f64, held: Held<T>) -> Result<(), LoadError> {
        not_negative(self.load, "mass", mass)?;
        let gravity = self.loads.gravity_in_plane();
        let gravity = Plane::new(T::constant(gravity.x), T::constant(gravity.y));
        let lacking = (gravity - self.acceleration(held.at)).scale(T::constant(mass));
        let wrenches = both([held.by, None], self.frames, lacking, [held.at; 2]);
        self.subtract(BodyLoadKind::Mass, wrenches);
        Ok(())
    }

    fn add_inertia(&mut self, inertia: f64, body: usize) -> Result<(), LoadError> {
        not_negative(self.load, "moment of inertia", inertia)?;
        let acceleration = self.frames[body].turn.slope() * T::constant(self.rate * self.rate);
        let lacking = -acceleration * T::constant(inertia);
        self.subtract(BodyLoadKind::Mass, [(body, Wrench::of_moment(lacking))].into());
        Ok(())
    }

    /// A torque on an angle, or a force along a distance.
    fn act(&mut self, quantity: usize, size: T) -> Result<(), ReactionError> {
        let what = self.what(&format!("the torque or force on `{}`", self.loads.name(quantity)));
        let dimension = self.dimension(quantity);
        let found = |influences: &Influences<'_, '_, REACH>| influences.actions(quantity, dimension);
        let action = self.influences.action(what, found, |_| true)?;
        self.subtract(BodyLoadKind::Applied, action.wrenches(self.moved, self.frames, size));
        Ok(())
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

    fn ends(&self, [from, to]: [PointIndex; 2]) -> Result<[Held<T>; 2], ReactionError> {
        Ok([self.held(from)?, self.held(to)?])
    }

    /// The place of a point.
    fn point(&self, point: PointIndex) -> Plane<T> {
        match point {
            PointIndex::Fixed(Space { x, y, .. }) => Plane::new(T::constant(x), T::constant(y)),
            PointIndex::Moving([x, y, _]) => {
                let part = |index: Option<usize>| index.map_or(T::constant(0.0), |index| self.moved.quantities[index]);
                Plane::new(part(x), part(y))
            }
        }
    }

    /// A point, and the body that holds it. What stands still is held by the ground.
    fn held(&self, point: PointIndex) -> Result<Held<T>, ReactionError> {
        let at = self.point(point);
        let Some(name) = self.loads.point_name(point) else {
            return Ok(Held { at, by: None });
        };
        let outline = self.influences.outline;
        let joint = outline.points.iter().find(|(own, _)| *own == name);
        let holders = joint.map_or_else(Vec::new, |(_, joint)| loaded(outline, *joint));
        match holders[..] {
            [by] => Ok(Held { at, by }),
            _ => Err(ReactionError::Place {
                what: self.what(&format!("at `{name}`")),
                places: holders.iter().map(|member| member_name(outline, *member)).collect(),
            }),
        }
    }
}
