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
    series.differentiate()
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

/// Distances may change by this part of the largest speed, by the rounding of a position that is known to half of its
/// digits.
const RIGID: f64 = 1e-7;

impl<const N: usize> MovedMechanism<N> {
    /// The unit vector along a slide.
    pub(super) fn direction(&self, slide: usize) -> Plane<Series<N>> {
        self.places[self.joints + slide]
    }

    /// The frames of all bodies.
    pub(super) fn frames(&self, outline: &Outline<'_>) -> Result<Vec<MovedFrame<N>>, ReactionError> {
        let bodies = outline.bodies.iter().enumerate();
        let frames = bodies.map(|(index, body)| {
            let frame = BodyFrame::of(outline, index)
                .map(|frame| frame.origin_and_axis(&self.places, |end, start| end - start));
            let frame = frame.filter(|[_, along]| along.norm_squared().real() > f64::MIN_POSITIVE);
            let [origin, along] = frame.ok_or_else(|| ReactionError::NoFrame {
                body: body.name.to_string(),
            })?;
            let axis = along.scale(Series::constant(1.0) / along.norm());
            let turn = axis.cross(slope_of(axis));
            Ok(MovedFrame { origin, axis, turn })
        });
        frames.collect()
    }

    /// Whether the joints of each body move with its frame.
    pub(super) fn check(&self, outline: &Outline<'_>, frames: &[MovedFrame<N>]) -> Result<(), ReactionError> {
        let size = |vector: Plane<Series<N>>| vector.x.real().abs() + vector.y.real().abs();
        let joints = self.places[..self.joints].iter();
        let largest = joints.map(|joint| size(slope_of(*joint))).fold(0.0, f64::max);
        for (body, frame) in outline.bodies.iter().zip(frames) {
            for &joint in body.joints {
                let place = self.places[joint];
                let rate = size(slope_of(place) - frame.velocity(place));
                if rate > RIGID * largest {
                    let body = body.name.to_string();
                    return Err(ReactionError::NotRigid { body, rate });
                }
            }
        }
        Ok(())
    }
}
