//! Bodies in motion.

use alloc::string::ToString;
use alloc::vec::Vec;

use super::ReactionError;
use crate::geometry::Plane;
use crate::load::BodyFrame;
use crate::number::Number;
use crate::number::series::Series;
use crate::picture::Outline;

/// A mechanism in motion: its quantities and the places of its picture, as series.
#[derive(Clone, Debug)]
pub(crate) struct MovedMechanism<const N: usize> {
    /// The parameters, inputs, unknowns and outputs.
    pub(crate) quantities: Vec<Series<N>>,
    /// The joints, and the directions of the slides as unit vectors.
    pub(crate) places: Vec<Plane<Series<N>>>,
    /// The number of joints.
    pub(crate) joints: usize,
}

/// The derivative of a series. Its last term is not known, and is zero.
pub(super) fn slope<const N: usize>(series: Series<N>) -> Series<N> {
    let derivatives = series.derivatives();
    Series::from_derivatives(core::array::from_fn(|order| {
        derivatives.get(order + 1).copied().unwrap_or(0.0)
    }))
}

pub(super) fn slope_of<const N: usize>(point: Plane<Series<N>>) -> Plane<Series<N>> {
    Plane::new(slope(point.x), slope(point.y))
}

/// The vector a quarter turn to the left.
pub(super) fn left<T: Number>(vector: Plane<T>) -> Plane<T> {
    Plane::new(-vector.y, vector.x)
}

/// The frame of a body in motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct MovedFrame<const N: usize> {
    pub(super) origin: Plane<Series<N>>,
    /// The unit vector along its axis.
    pub(super) axis: Plane<Series<N>>,
    /// The rate at which it turns.
    pub(super) turn: Series<N>,
}

impl<const N: usize> MovedFrame<N> {
    /// The velocity of what is fixed to the body at a place.
    pub(super) fn velocity(&self, place: Plane<Series<N>>) -> Plane<Series<N>> {
        slope_of(self.origin) + left(place - self.origin).scale(self.turn)
    }
}

/// Distances may change by this part of their terms, by the rounding of a position that is known to half of its digits.
const RIGID: f64 = 1e-7;

impl<const N: usize> MovedMechanism<N> {
    /// The unit vector along a slide.
    pub(super) fn direction(&self, slide: usize) -> Plane<Series<N>> {
        self.places[self.joints + slide]
    }

    /// The frames of all bodies, which keep the distances of their joints.
    pub(super) fn frames(&self, outline: &Outline<'_>) -> Result<Vec<MovedFrame<N>>, ReactionError> {
        let bodies = outline.bodies.iter().enumerate();
        bodies
            .map(|(index, body)| {
                let name = || body.name.to_string();
                let frame = BodyFrame::of(outline, index).ok_or_else(|| ReactionError::NoFrame { body: name() })?;
                let [origin, along] = frame.origin_and_axis(&self.places);
                let length = along.norm();
                if length.real() <= f64::MIN_POSITIVE {
                    return Err(ReactionError::NoFrame { body: name() });
                }
                let axis = along.scale(Series::constant(1.0) / length);
                let turn = axis.cross(slope_of(axis));
                let moved = MovedFrame { origin, axis, turn };
                for &joint in body.joints {
                    let arm = self.places[joint] - origin;
                    let velocity = slope_of(arm);
                    let free = velocity - left(arm).scale(turn);
                    let size = |vector: Plane<Series<N>>| vector.x.real().abs() + vector.y.real().abs();
                    if size(free) > RIGID * (size(velocity) + size(left(arm).scale(turn))) {
                        let rate = size(free);
                        return Err(ReactionError::NotRigid { body: name(), rate });
                    }
                }
                Ok(moved)
            })
            .collect()
    }
}
