//! Where a torque on an angle, or a force along a distance, acts on the bodies.

use alloc::string::String;
use alloc::vec::Vec;

use super::ReactionError;
use super::connection::{Connection, Member, balls, hub, loaded, member_name};
use super::frames::{JointAxis, MovedFrame, MovedMechanism, MovingNumber, Shortened, along_axis, shortened, slope_of};
use crate::geometry::Space;
use crate::number::series::Series;
use crate::picture::Outline;
use crate::quantity::Dimension;

/// The mechanism while one input alone moves at unit speed.
#[derive(Clone, Debug)]
pub(crate) struct Influence<const N: usize> {
    pub(super) moved: MovedMechanism<Series<N>>,
    pub(super) frames: Vec<MovedFrame<Series<N>>>,
}

/// Two bodies between which a torque or a force acts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Action {
    pub(super) on: Member,
    pub(super) by: Member,
    kind: ActionKind,
    /// -1 where the quantity falls as the body moves forwards.
    sign: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum ActionKind {
    Couple(JointAxis),
    /// Along a slide, at its joint.
    Slide {
        joint: usize,
        slide: usize,
    },
    /// Along the line between two joints, on the second one.
    Line([usize; 2]),
    /// Along an axis of coordinates.
    Axis {
        joint: usize,
        axis: usize,
    },
}

/// The force on a body, and its moment about the origin of the body's frame.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wrench<T> {
    pub(super) force: Space<T>,
    /// Where the force acts; none for a couple and for a sum.
    pub(super) at: Option<Space<T>>,
    pub(super) moment: Space<T>,
}

impl<T: MovingNumber> Wrench<T> {
    /// A force at a place on a body.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn of_force(frame: &MovedFrame<T>, force: Space<T>, at: Space<T>) -> Self {
        let moment = frame.moment(force, at);
        let at = Some(at);
        Self { force, at, moment }
    }

    /// A couple.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn of_moment(moment: Space<T>) -> Self {
        let (force, at) = (Space::zero(), None);
        Self { force, at, moment }
    }
}

/// A force or a couple, and the opposite one, on two bodies of which one may be the ground.
#[derive(Clone, Copy, Debug)]
pub(super) struct Exertion<T> {
    /// The body on which it acts, and the one that exerts it.
    pub(super) pair: [Member; 2],
    what: Exerted<T>,
}

#[derive(Clone, Copy, Debug)]
enum Exerted<T> {
    /// A force, with the place where it acts and the one where it is exerted.
    Force(Space<T>, [Space<T>; 2]),
    Couple(Space<T>),
}

impl<F: MovingNumber> Exertion<F> {
    /// A force of which as many derivatives count as it has here.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn shortened<T: Shortened<F>>(exertion: &Exertion<T>) -> Self {
        let pair = exertion.pair;
        let what = match exertion.what {
            Exerted::Force(force, [at, from]) => Exerted::Force(shortened(force), [shortened(at), shortened(from)]),
            Exerted::Couple(moment) => Exerted::Couple(shortened(moment)),
        };
        Self { pair, what }
    }
}

impl<T: MovingNumber> Exertion<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn of_force(pair: [Member; 2], force: Space<T>, places: [Space<T>; 2]) -> Self {
        let what = Exerted::Force(force, places);
        Self { pair, what }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn of_couple(pair: [Member; 2], moment: Space<T>) -> Self {
        let what = Exerted::Couple(moment);
        Self { pair, what }
    }

    /// What it is on one of the two bodies, with the index of this body.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn wrench(&self, end: usize, frames: &[MovedFrame<T>]) -> Option<(usize, Wrench<T>)> {
        let body = self.pair[end]?;
        let wrench = match self.what {
            Exerted::Force(force, places) => {
                let force = if end == 0 { force } else { -force };
                Wrench::of_force(&frames[body], force, places[end])
            }
            Exerted::Couple(moment) => Wrench::of_moment(if end == 0 { moment } else { -moment }),
        };
        Some((body, wrench))
    }

    /// What it is on the bodies that move.
    pub(super) fn wrenches<'w>(&'w self, frames: &'w [MovedFrame<T>]) -> impl Iterator<Item = (usize, Wrench<T>)> + 'w {
        (0..2).filter_map(move |end| self.wrench(end, frames))
    }
}

impl Action {
    /// The forces of a torque or force of this size.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn exertion<T: MovingNumber>(&self, moved: &MovedMechanism<T>, size: T) -> Exertion<T> {
        let size = size.times(self.sign);
        let pair = [self.on, self.by];
        let (force, places) = match self.kind {
            ActionKind::Couple(axis) => return Exertion::of_couple(pair, moved.axis(axis).scale(size)),
            ActionKind::Slide { joint, slide } => (moved.along(slide).scale(size), [moved.places[joint]; 2]),
            ActionKind::Line([from, to]) => {
                let [from, to] = [from, to].map(|joint| moved.places[joint]);
                let line = to - from;
                (line.scale(size / line.norm()), [to, from])
            }
            ActionKind::Axis { joint, axis } => (along_axis(axis).scale(size), [moved.places[joint]; 2]),
        };
        Exertion::of_force(pair, force, places)
    }

    /// Whether it is the same in all poses as long as its size is.
    pub(super) fn is_still(&self) -> bool {
        matches!(self.kind, ActionKind::Couple(JointAxis::Normal))
    }

    pub(super) fn acts_on(&self, body: usize) -> bool {
        [self.on, self.by].contains(&Some(body))
    }

    /// What the bodies are called in a message.
    pub(super) fn name(&self, outline: &Outline<'_>) -> String {
        match self.by {
            None => member_name(outline, self.on),
            by => member_name(outline, self.on) + " against " + &member_name(outline, by),
        }
    }
}

/// So many terms of two rates must agree, and to this part of their sizes: a body that turns at another rate does not
/// agree in all of them.
pub(super) const TERMS: usize = 3;
pub(super) const AGREEMENT: f64 = 1e-7;

/// The sign with which all rates agree with those of a quantity.
fn sign_of<const N: usize>(rates: &[[Series<N>; 2]]) -> Option<f64> {
    [1.0, -1.0].into_iter().find(|sign| {
        rates.iter().all(|[own, wanted]| {
            let (own, wanted) = (own.coefficients(), wanted.coefficients());
            let mut terms = own.iter().zip(&wanted).take(TERMS);
            terms.all(|(own, wanted)| (own - sign * wanted).abs() <= AGREEMENT * (1.0 + own.abs() + wanted.abs()))
        }) && rates.iter().any(|[_, wanted]| {
            // where a link turns back, its rate is zero, and the next term tells
            let mut terms = wanted.coefficients().into_iter().take(TERMS);
            terms.any(|term| term.abs() > AGREEMENT)
        })
    })
}

/// The mechanism while each of its inputs moves alone.
pub(super) struct Influences<'i, 'o, const N: usize> {
    pub(super) outline: &'i Outline<'o>,
    pub(super) connections: &'i [Connection],
    pub(super) all: &'i [Influence<N>],
    /// The same with other dimensions, in which bodies of the same length no longer move alike. It is only asked for if
    /// several bodies do.
    pub(super) otherwise: &'i dyn Fn() -> Vec<Influence<N>>,
}

impl<const N: usize> Influences<'_, '_, N> {
    /// The sign with which something moves like a quantity, by the rates of both in each motion.
    fn sign(&self, quantity: usize, rate: impl Fn(&Influence<N>) -> Series<N>) -> Option<f64> {
        let rates: Vec<[Series<N>; 2]> = self
            .all
            .iter()
            .map(|one| [rate(one), one.moved.quantities[quantity].slope()])
            .collect();
        sign_of(&rates)
    }

    fn is_space(&self) -> bool {
        self.all.iter().any(|one| one.moved.is_space)
    }

    /// Whether a body never turns against another one about an axis.
    pub(super) fn keeps_angle(
        &self,
        pair: [Member; 2],
        axis: impl Fn(&Influence<N>) -> Option<Space<Series<N>>>,
    ) -> bool {
        self.all.iter().all(|one| {
            let Some(axis) = axis(one) else { return false };
            let rates = pair.map(|member| one.turn(member).dot(axis));
            let (rate, sizes) = (rates[0] - rates[1], rates.map(|rate| rate.coefficients()));
            let mut terms = rate.coefficients().into_iter().enumerate().take(TERMS);
            terms.all(|(term, rate)| rate.abs() <= AGREEMENT * (1.0 + sizes[0][term].abs() + sizes[1][term].abs()))
        })
    }

    /// Where the torque on an angle, or the force along a distance, could act.
    pub(super) fn actions(&self, quantity: usize, dimension: Dimension) -> Vec<Action> {
        let or = |found: Vec<Action>, other: fn(&Self, usize) -> Vec<Action>| {
            if found.is_empty() { other(self, quantity) } else { found }
        };
        match dimension {
            Dimension::Length => or(or(self.on_slides(quantity), Self::on_lines), Self::on_axes),
            Dimension::Angle | Dimension::Scalar => or(self.against_ground(quantity), Self::between_bodies),
        }
    }

    /// The only place of something that acts on a quantity, among those that are `wanted`.
    pub(super) fn action(
        &self,
        what: String,
        found: impl Fn(&Influences<'_, '_, N>) -> Vec<Action>,
        wanted: impl Fn(&Action) -> bool,
    ) -> Result<Action, ReactionError> {
        let mut actions = found(self);
        actions.retain(&wanted);
        if actions.len() > 1 {
            let all = (self.otherwise)();
            let other = found(&Influences {
                outline: self.outline,
                connections: self.connections,
                all: &all,
                otherwise: self.otherwise,
            });
            if other.iter().any(|action| actions.contains(action)) {
                actions.retain(|action| other.contains(action));
            }
        }
        match actions[..] {
            [only] => Ok(only),
            [] if self.is_space() => Err(ReactionError::NoHinge {
                what,
                balls: balls(self.connections),
            }),
            _ => Err(ReactionError::Place {
                what,
                places: actions.iter().map(|action| action.name(self.outline)).collect(),
            }),
        }
    }

    /// The bodies that turn like an angle.
    pub(super) fn against_ground(&self, quantity: usize) -> Vec<Action> {
        if self.is_space() {
            return self.on_hinges(quantity, |connection| connection.by.is_none());
        }
        let bodies = 0..self.outline.bodies.len();
        let pairs = bodies.map(|body| ([Some(body), None], JointAxis::Normal));
        self.turning(quantity, pairs)
    }

    fn between_bodies(&self, quantity: usize) -> Vec<Action> {
        if self.is_space() {
            return self.on_hinges(quantity, |connection| connection.by.is_some());
        }
        let bodies = self.outline.bodies;
        let pairs = bodies.iter().enumerate().flat_map(|(by, first)| {
            let others = bodies.iter().enumerate().skip(by + 1);
            let joined = others.filter(|(_, second)| first.joints.iter().any(|joint| second.joints.contains(joint)));
            joined.map(move |(on, _)| ([Some(on), Some(by)], JointAxis::Normal))
        });
        self.turning(quantity, pairs)
    }

    /// The hinges and slides about which bodies turn like an angle.
    fn on_hinges(&self, quantity: usize, is_wanted: impl Fn(&Connection) -> bool) -> Vec<Action> {
        let connections = self.connections.iter().filter(|connection| is_wanted(connection));
        let axes = connections.filter_map(|own| Some(([own.on, own.by], own.axis()?)));
        self.turning(quantity, axes)
    }

    /// The pairs of bodies that turn like an angle about an axis.
    fn turning(&self, quantity: usize, pairs: impl Iterator<Item = ([Member; 2], JointAxis)>) -> Vec<Action> {
        let found = pairs.filter_map(|(pair, axis)| {
            let sign = self.sign(quantity, |one| {
                let [on, by] = pair.map(|member| one.turn(member));
                match axis {
                    JointAxis::Normal => on.z - by.z,
                    axis => (on - by).dot(one.moved.axis(axis)),
                }
            })?;
            let ([on, by], kind) = (pair, ActionKind::Couple(axis));
            Some(Action { on, by, kind, sign })
        });
        found.collect()
    }

    fn on_slides(&self, quantity: usize) -> Vec<Action> {
        let slides = self.outline.slides.iter().enumerate();
        let found = slides.filter_map(|(index, slide)| {
            let (joint, by) = (slide.joint, slide.guide);
            let sign = self.sign(quantity, |one| {
                let place = one.moved.places[joint];
                one.moved.along(index).dot(slope_of(place) - one.velocity(by, place))
            })?;
            let on = hub(self.outline, joint)?;
            let kind = ActionKind::Slide { joint, slide: index };
            Some(Action { on, by, kind, sign })
        });
        found.collect()
    }

    fn on_lines(&self, quantity: usize) -> Vec<Action> {
        let count = self.all.first().map_or(0, |one| one.moved.joints);
        let mut found = Vec::new();
        for from in 0..count {
            for to in from + 1..count {
                let sign = self.sign(quantity, |one| {
                    let line = one.moved.places[to] - one.moved.places[from];
                    line.dot(slope_of(line)) / line.norm()
                });
                let Some(sign) = sign else { continue };
                for by in loaded(self.outline, from) {
                    for on in loaded(self.outline, to) {
                        let kind = ActionKind::Line([from, to]);
                        found.push(Action { on, by, kind, sign });
                    }
                }
            }
        }
        found
    }

    fn on_axes(&self, quantity: usize) -> Vec<Action> {
        let mut joints: Vec<usize> = self
            .outline
            .bodies
            .iter()
            .flat_map(|body| body.joints)
            .copied()
            .collect();
        joints.sort_unstable();
        joints.dedup();
        let mut found = Vec::new();
        for joint in joints {
            for axis in 0..if self.is_space() { 3 } else { 2 } {
                let sign = self.sign(quantity, |one| {
                    let Space { x, y, z } = slope_of(one.moved.places[joint]);
                    [x, y, z][axis]
                });
                let Some(sign) = sign else { continue };
                for on in loaded(self.outline, joint) {
                    let kind = ActionKind::Axis { joint, axis };
                    found.push(Action {
                        on,
                        by: None,
                        kind,
                        sign,
                    });
                }
            }
        }
        found
    }
}

impl<const N: usize> Influence<N> {
    fn turn(&self, member: Member) -> Space<Series<N>> {
        member.map_or_else(Space::zero, |body| self.frames[body].turn)
    }

    /// The velocity of a place that a body carries.
    fn velocity(&self, member: Member, place: Space<Series<N>>) -> Space<Series<N>> {
        member.map_or_else(Space::zero, |body| self.frames[body].velocity(place))
    }
}
