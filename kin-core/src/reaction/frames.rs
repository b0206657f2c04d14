//! Bodies in motion.

use alloc::string::ToString;
use alloc::vec;
use alloc::vec::Vec;

use super::ReactionError;
use crate::any::{AnyMechanism, OutputsOver, Pictured, SkeletonOver};
use crate::geometry::Plane;
use crate::load::BodyFrame;
use crate::number::Number;
use crate::number::series::Series;
use crate::picture::Outline;
use crate::quantity::Dimension;
use crate::solve::{Scalar, unwrap_near};

/// A number with some of its derivatives by a variable.
pub(crate) trait MovingNumber: Number {
    /// The derivative. Its own highest derivative is not known, and is zero.
    #[must_use]
    fn slope(self) -> Self;
}

impl<const N: usize> MovingNumber for Series<N> {
    fn slope(self) -> Self {
        let derivatives = self.derivatives();
        Series::from_derivatives(core::array::from_fn(|order| {
            derivatives.get(order + 1).copied().unwrap_or(0.0)
        }))
    }
}

/// A mechanism in motion: its quantities and the places of its picture, as numbers that move.
#[derive(Clone, Debug)]
pub(crate) struct MovedMechanism<T> {
    /// The parameters, inputs, unknowns and outputs.
    pub(crate) quantities: Vec<T>,
    /// The joints, and the directions of the slides as unit vectors.
    pub(crate) places: Vec<Plane<T>>,
    /// The number of joints.
    pub(crate) joints: usize,
}

pub(super) fn slope_of<T: MovingNumber>(point: Plane<T>) -> Plane<T> {
    Plane::new(point.x.slope(), point.y.slope())
}

/// The vector a quarter turn to the left.
pub(super) fn left<T: Number>(vector: Plane<T>) -> Plane<T> {
    Plane::new(-vector.y, vector.x)
}

/// The frame of a body in motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct MovedFrame<T> {
    pub(super) origin: Plane<T>,
    /// The unit vector along its axis.
    pub(super) axis: Plane<T>,
    /// The rate at which it turns.
    pub(super) turn: T,
}

impl<T: MovingNumber> MovedFrame<T> {
    /// The velocity of what is fixed to the body at a place.
    pub(super) fn velocity(&self, place: Plane<T>) -> Plane<T> {
        slope_of(self.origin) + left(place - self.origin).scale(self.turn)
    }
}

/// Distances may change by this part of the largest speed, by the rounding of a position that is known to half of its
/// digits.
const RIGID: f64 = 1e-7;

impl<T: MovingNumber + Scalar> MovedMechanism<T> {
    /// The mechanism in a pose. Angles of outputs are unwrapped to those that are given.
    pub(super) fn of<F: ?Sized + AnyMechanism + Pictured + OutputsOver<T> + SkeletonOver<T>>(
        functions: &F,
        parameters: &[T],
        inputs: &[T],
        unknowns: &[T],
        near: &[f64],
    ) -> Self {
        let description = functions.description();
        let mut outputs = vec![T::constant(0.0); description.outputs.len()];
        OutputsOver::<T>::outputs(functions, parameters, inputs, unknowns, &mut outputs);
        for ((output, quantity), near) in outputs.iter_mut().zip(description.outputs).zip(near) {
            if quantity.dimension == Dimension::Angle {
                *output = unwrap_near(*output, T::constant(*near));
            }
        }
        let mut places: Vec<Plane<T>> = Vec::new();
        let mut add = |coordinates: &[T]| places.push(Plane::new(coordinates[0], coordinates[1]));
        SkeletonOver::<T>::skeleton_points(functions, parameters, inputs, unknowns, &mut add);
        let joints = places.len() - functions.outline().slides.len();
        for direction in &mut places[joints..] {
            *direction = direction.scale(T::constant(1.0) / direction.norm());
        }
        Self {
            quantities: [parameters, inputs, unknowns, &outputs].concat(),
            places,
            joints,
        }
    }
}

impl<T: MovingNumber> MovedMechanism<T> {
    /// The unit vector along a slide.
    pub(super) fn direction(&self, slide: usize) -> Plane<T> {
        self.places[self.joints + slide]
    }

    /// The frames of all bodies.
    pub(super) fn frames(&self, outline: &Outline<'_>) -> Result<Vec<MovedFrame<T>>, ReactionError> {
        let bodies = outline.bodies.iter().enumerate();
        let frames = bodies.map(|(index, body)| {
            let frame = BodyFrame::of(outline, index)
                .map(|frame| frame.origin_and_axis(&self.places, |end, start| end - start));
            let frame = frame.filter(|[_, along]| along.norm_squared().real() > f64::MIN_POSITIVE);
            let [origin, along] = frame.ok_or_else(|| ReactionError::NoFrame {
                body: body.name.to_string(),
            })?;
            let axis = along.scale(T::constant(1.0) / along.norm());
            let turn = axis.cross(slope_of(axis));
            Ok(MovedFrame { origin, axis, turn })
        });
        frames.collect()
    }

    /// Whether the joints of each body move with its frame.
    pub(super) fn check(&self, outline: &Outline<'_>, frames: &[MovedFrame<T>]) -> Result<(), ReactionError> {
        let size = |vector: Plane<T>| vector.x.real().abs() + vector.y.real().abs();
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
