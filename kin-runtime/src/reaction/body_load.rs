//! What acts on a body beside the reactions of its joints.

use alloc::string::String;
use alloc::vec::Vec;

use super::action::{Exertion, Wrench};
use super::connection::Connection;
use super::frames::{MovedFrame, MovingNumber, along_axis};
use super::{NamedReactions, Solved};
use crate::geometry::Space;
use crate::number::Number;
use crate::number::series::Series;

/// What exerts a force on a body beside its joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyLoadKind {
    /// A mass: its weight and its resistance to acceleration, m (g - a), at its centre; or the couple -I α.
    Mass,
    /// A force, a torque, a spring or a damper.
    Applied,
    /// The drive of an input, by the index of the input.
    Drive(usize),
    /// The friction in a pin.
    Friction,
    /// A guide, which keeps the body from turning.
    Guide,
}

/// A force at a place of a body, or a couple. All of a body and the forces in its joints are in equilibrium, with the
/// moments of hinges in space.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyLoad {
    /// What exerts it.
    pub kind: BodyLoadKind,
    /// The body.
    pub body: String,
    /// Where the force acts; for a couple alone, the origin of the body's frame.
    pub at: [f64; 3],
    /// The force.
    pub force: [f64; 3],
    /// The couple: in the plane, its third coordinate alone.
    pub moment: [f64; 3],
}

/// A force or a couple on a body, by its index.
pub(super) type Acting<T> = (BodyLoadKind, usize, Wrench<T>);

/// What it is on the bodies that move.
pub(super) fn of_exertion<'e, T: MovingNumber>(
    kind: BodyLoadKind,
    exertion: &'e Exertion<T>,
    frames: &'e [MovedFrame<T>],
) -> impl Iterator<Item = Acting<T>> + 'e {
    exertion
        .wrenches(frames)
        .map(move |(body, wrench)| (kind, body, wrench))
}

impl BodyLoad {
    pub(super) fn new<T: MovingNumber>((kind, _, wrench): &Acting<T>, frame: &MovedFrame<T>, body: &str) -> Self {
        let reals = |vector: Space<T>| [vector.x, vector.y, vector.z].map(Number::real);
        Self {
            kind: *kind,
            body: body.into(),
            at: reals(wrench.at.unwrap_or(frame.origin)),
            force: reals(wrench.force),
            moment: if wrench.at.is_some() {
                [0.0; 3]
            } else {
                reals(wrench.moment)
            },
        }
    }
}

impl NamedReactions<'_> {
    /// What acts on all bodies beside the reactions.
    pub(super) fn body_loads(&self, solved: &Solved) -> Vec<BodyLoad> {
        let Solved {
            solution,
            loads,
            drives,
            moved,
            frames,
        } = solved;
        let mut acting = loads.clone();
        for (input, (drive, effort)) in drives.iter().zip(&solution.efforts).enumerate() {
            let exertion = drive.exertion(moved, effort.unwrap_or(Series::ZERO));
            acting.extend(of_exertion(BodyLoadKind::Drive(input), &exertion, frames));
        }
        // the friction of a slide is a part of its force
        for (index, _) in &self.frictions {
            let Connection { on, by, slide, .. } = self.connections[*index];
            if slide.is_none() {
                let exertion = Exertion::of_couple([on, by], along_axis(2).scale(solution.frictions[*index]));
                acting.extend(of_exertion(BodyLoadKind::Friction, &exertion, frames));
            }
        }
        let turned = solution.turned.iter();
        acting.extend(turned.map(|(body, wrench)| (BodyLoadKind::Guide, *body, *wrench)));
        let bodies = self.functions.outline().bodies;
        let load = |acting: &Acting<_>| BodyLoad::new(acting, &frames[acting.1], bodies[acting.1].name);
        acting.iter().map(load).collect()
    }
}
