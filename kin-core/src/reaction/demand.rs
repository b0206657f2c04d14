//! What the loads and the inertia of bodies ask of the joints and drives.

use alloc::format;
use alloc::string::String;
use alloc::vec;
use alloc::vec::Vec;

use super::action::{Influences, Wrench, both};
use super::body_load::{Acting, BodyLoadKind};
use super::connection::{Member, loaded, member_name};
use super::frames::{MovedFrame, MovedMechanism, MovingNumber, product, slope_of, still};
use super::{REACH, ReactionError};
use crate::geometry::Space;
use crate::load::{LoadError, NamedLoad, NamedLoads, PointIndex, centre_on_line, not_negative};
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
    at: Space<T>,
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
            bodies: vec![Wrench::of_moment(Space::zero()); frames.len()],
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

    fn acceleration(&self, point: Space<T>) -> Space<T> {
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
            NamedLoad::Body(mass, inertia, centre, body, frame) => {
                let at = match centre {
                    PointIndex::Fixed(centre) if self.moved.is_space => {
                        let centre = centre_on_line(centre, self.load)?;
                        let [origin, along] = frame.origin_and_axis(&self.moved.places, |end, start| end - start);
                        origin + along.scale(T::constant(centre) / along.norm())
                    }
                    PointIndex::Fixed(centre) => self.frames[body].place(centre),
                    PointIndex::Moving(_) => self.moved.point(centre),
                };
                self.add_mass(mass, Held { at, by: Some(body) })?;
                not_negative(self.load, "moment of inertia", inertia)?;
                let [_, along] = frame.origin_and_axis(&self.moved.places, |end, start| end - start);
                self.add_rod(inertia, along.scale(T::constant(1.0) / along.norm()), body);
            }
            NamedLoad::Solid(..) if !self.moved.is_space => {
                return Err(LoadError::SolidInPlane { load: self.load }.into());
            }
            NamedLoad::Solid(solid, body) => {
                solid.check(self.load)?;
                let frame = self.frames[body];
                let at = frame.place(solid.centre);
                self.add_mass(solid.mass, Held { at, by: Some(body) })?;
                self.add_tensor(solid.inertia, body);
            }
            NamedLoad::Mass(mass, point) => {
                let held = self.held(point)?;
                self.add_mass(mass, held)?;
            }
            NamedLoad::Inertia(inertia, angle) => {
                let what = self.what(&format!("the inertia of `{}`", self.loads.name(angle)));
                let found = |influences: &Influences<'_, '_, REACH>| influences.against_ground(angle);
                let action = self.influences.action(what, found, |_| true)?;
                not_negative(self.load, "moment of inertia", inertia)?;
                let acceleration = self.by_time(self.by_time(self.moved.quantities[angle]));
                let lacking = -acceleration * T::constant(inertia);
                self.subtract(BodyLoadKind::Mass, action.wrenches(self.moved, self.frames, lacking));
            }
            NamedLoad::Force(force, point) => {
                let held = self.held(point)?;
                let force = still(self.shown(force));
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
    fn pull(&mut self, [from, to]: [Held<T>; 2], force: Space<T>) {
        let wrenches = both([from.by, to.by], self.frames, force, [from.at, to.at]);
        self.subtract(BodyLoadKind::Applied, wrenches);
    }

    fn length(&self, line: Space<T>) -> Result<T, LoadError> {
        let square = line.norm_squared();
        if square.real() > f64::MIN_POSITIVE {
            Ok(square.sqrt())
        } else {
            Err(LoadError::NoDirection { load: self.load })
        }
    }

    fn add_mass(&mut self, mass: f64, held: Held<T>) -> Result<(), LoadError> {
        not_negative(self.load, "mass", mass)?;
        let gravity = still(self.shown(self.loads.acceleration_of_gravity()));
        let lacking = (gravity - self.acceleration(held.at)).scale(T::constant(mass));
        let wrenches = both([held.by, None], self.frames, lacking, [held.at; 2]);
        self.subtract(BodyLoadKind::Mass, wrenches);
        Ok(())
    }

    /// The couple of a moment of inertia about the axes at right angles to a unit vector that is fixed to a body.
    fn add_rod(&mut self, inertia: f64, axis: Space<T>, body: usize) {
        // the arms ξ e have the angular momentum ξ² e × e', and its rate is ξ² e × e''
        let momentum = product(axis, slope_of(axis), self.moved.is_space);
        let by_time = T::constant(self.rate * self.rate);
        let lacking = -slope_of(momentum).scale(by_time).scale(T::constant(inertia));
        self.subtract(BodyLoadKind::Mass, [(body, Wrench::of_moment(lacking))].into());
    }

    /// The couple of a tensor of inertia along the axes of the frame of a body, about its centre.
    fn add_tensor(&mut self, inertia: [[f64; 3]; 3], body: usize) {
        let MovedFrame { axes, turn, .. } = self.frames[body];
        let rates = axes.map(|axis| axis.dot(turn));
        let mut momentum = Space::zero();
        for (row, axis) in axes.into_iter().enumerate() {
            for (column, rate) in rates.into_iter().enumerate() {
                let mean = 0.5 * (inertia[row][column] + inertia[column][row]);
                momentum = momentum + axis.scale(rate * T::constant(mean));
            }
        }
        let by_time = T::constant(-self.rate * self.rate);
        let lacking = slope_of(momentum).scale(by_time);
        self.subtract(BodyLoadKind::Mass, [(body, Wrench::of_moment(lacking))].into());
    }

    /// A vector as the mechanism shows it: one of the plane has no third coordinate.
    fn shown(&self, vector: Space<f64>) -> Space<f64> {
        let z = if self.moved.is_space { vector.z } else { 0.0 };
        Space { z, ..vector }
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

    /// A point, and the body that holds it. What stands still is held by the ground.
    fn held(&self, point: PointIndex) -> Result<Held<T>, ReactionError> {
        let at = self.moved.point(point);
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
