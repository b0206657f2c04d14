//! Bodies in motion, in the plane or in space. The plane is that of x and y in space.

use alloc::string::ToString;
use alloc::vec;
use alloc::vec::Vec;

use super::ReactionError;
use super::connection::{Connection, member_name};
use crate::any::{AnyMechanism, OutputsOver, Pictured, SkeletonOver};
use crate::geometry::Space;
use crate::load::{BodyFrame, PointIndex, third_point};
use crate::number::Number;
use crate::number::series::Series;
use crate::picture::{Outline, Slide};
use crate::quantity::Dimension;
use crate::solve::{Scalar, unwrap_near};

/// A number with some of its derivatives by a variable.
pub(crate) trait MovingNumber: Number {
    /// The derivative. Its own highest derivative is not known, and is zero.
    #[must_use]
    fn slope(self) -> Self;

    /// The product with a factor that does not move.
    #[must_use]
    fn times(self, factor: f64) -> Self {
        self * Self::constant(factor)
    }

    /// The unit vector along a vector whose length does not change.
    #[must_use]
    fn unit_of_rigid(vector: Space<Self>) -> Space<Self> {
        unit(vector)
    }
}

impl<const N: usize> MovingNumber for Series<N> {
    fn slope(self) -> Self {
        self.differentiate()
    }

    fn times(self, factor: f64) -> Self {
        Self::from_coefficients(self.coefficients().map(|term| term * factor))
    }

    fn unit_of_rigid(vector: Space<Self>) -> Space<Self> {
        times(vector, 1.0 / real(vector).norm())
    }
}

/// A mechanism in motion: its quantities and the places of its picture, as numbers that move.
#[derive(Clone, Debug)]
pub(crate) struct MovedMechanism<T> {
    /// The parameters, inputs, unknowns and outputs.
    pub(crate) quantities: Vec<T>,
    /// The joints, and the directions of the slides as unit vectors.
    pub(crate) places: Vec<Space<T>>,
    /// The number of joints.
    pub(crate) joints: usize,
    pub(crate) is_space: bool,
}

#[inline]
pub(super) fn slope_of<T: MovingNumber>(point: Space<T>) -> Space<T> {
    Space::new(point.x.slope(), point.y.slope(), point.z.slope())
}

/// A vector that does not move.
#[inline]
pub(super) fn still<T: MovingNumber>(vector: Space<f64>) -> Space<T> {
    Space::new(T::constant(vector.x), T::constant(vector.y), T::constant(vector.z))
}

/// The unit vector along an axis of coordinates.
#[inline]
pub(super) fn along_axis<T: MovingNumber>(axis: usize) -> Space<T> {
    let part = |own: usize| f64::from(u8::from(own == axis));
    still(Space::new(part(0), part(1), part(2)))
}

pub(super) fn unit<T: MovingNumber>(vector: Space<T>) -> Space<T> {
    vector.scale(T::constant(1.0) / vector.norm())
}

/// The product of a vector with a factor that does not move.
#[inline]
pub(super) fn times<T: MovingNumber>(vector: Space<T>, factor: f64) -> Space<T> {
    Space::new(vector.x.times(factor), vector.y.times(factor), vector.z.times(factor))
}

/// Where a vector is now.
#[inline]
pub(super) fn real<T: MovingNumber>(vector: Space<T>) -> Space<f64> {
    Space::new(vector.x.real(), vector.y.real(), vector.z.real())
}

/// The sum of the sizes of the coordinates.
fn size(vector: Space<f64>) -> f64 {
    vector.x.abs() + vector.y.abs() + vector.z.abs()
}

/// An axis about which a joint turns, or along which it slides. It moves with the mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum JointAxis {
    /// At right angles to the plane.
    Normal,
    /// From one joint to another one.
    Joints([usize; 2]),
    /// Along a slide.
    Slide(usize),
    /// Of a vector.
    Vector(PointIndex),
}

/// The frame of a body in motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct MovedFrame<T> {
    pub(super) origin: Space<T>,
    /// Unit vectors at right angles to each other. Those of a body in the plane are its own axis, the one to the left
    /// of it, and the normal of the plane.
    pub(super) axes: [Space<T>; 3],
    /// The vector of the rate at which it turns.
    pub(super) turn: Space<T>,
    /// The first of the axes about which the body has an equation of moments. A rod of space whose points lie on a line
    /// has none about this line, about which nothing tells how it turns.
    pub(super) first_turn: usize,
}

impl<T: MovingNumber> MovedFrame<T> {
    /// A frame of which the first axis alone is known. It does not turn about it.
    #[inline]
    fn of_line(origin: Space<T>, axis: Space<T>, is_space: bool) -> Self {
        let [left, normal] = across(axis, is_space);
        Self {
            origin,
            axes: [axis, left, normal],
            turn: product(axis, slope_of(axis), is_space),
            first_turn: if is_space { 1 } else { 2 },
        }
    }

    /// A frame by its first axis, and a vector on the side of its second one.
    fn of_plane(origin: Space<T>, axis: Space<T>, beside: Space<T>) -> Self {
        let normal = unit(axis.cross(beside));
        let axes = [axis, normal.cross(axis), normal];
        // with unit vectors e at right angles, the rate is half the sum of e × e'
        let turn = axes
            .into_iter()
            .fold(Space::zero(), |sum: Space<T>, axis| sum + axis.cross(slope_of(axis)));
        Self {
            origin,
            axes,
            turn: times(turn, 0.5),
            first_turn: 0,
        }
    }

    /// The axes about which the body has an equation of moments.
    #[inline]
    pub(super) fn turns(&self) -> &[Space<T>] {
        &self.axes[self.first_turn..]
    }

    /// The line of a rod of space.
    pub(super) fn line(&self) -> Option<Space<T>> {
        (self.first_turn == 1).then_some(self.axes[0])
    }

    /// The place of a point of the frame.
    #[inline]
    pub(super) fn place(&self, point: Space<f64>) -> Space<T> {
        let parts = self.axes.into_iter().zip([point.x, point.y, point.z]);
        let mut place = self.origin;
        for (axis, part) in parts.filter(|(_, part)| *part != 0.0) {
            place = place + times(axis, part);
        }
        place
    }

    /// Whether the body is one of the plane.
    #[inline]
    pub(super) fn is_plane(&self) -> bool {
        self.first_turn == 2
    }

    /// The moment of a force at a place about the origin.
    #[inline]
    pub(super) fn moment(&self, force: Space<T>, at: Space<T>) -> Space<T> {
        product(at - self.origin, force, !self.is_plane())
    }

    /// The moment of a unit force along an axis of coordinates at a place about the origin.
    #[inline]
    pub(super) fn moment_along(&self, axis: usize, at: Space<T>) -> Space<T> {
        let Space { x, y, z } = at - self.origin;
        let nothing = T::constant(0.0);
        match axis {
            0 => Space::new(nothing, z, -y),
            1 => Space::new(-z, nothing, x),
            _ => Space::new(y, -x, nothing),
        }
    }

    /// The parts of a moment for which the body has equations.
    #[inline]
    pub(super) fn parts(&self, moment: Space<T>) -> impl Iterator<Item = T> {
        let is_plane = self.is_plane();
        let part = move |axis: &Space<T>| if is_plane { moment.z } else { axis.dot(moment) };
        self.turns().iter().map(part)
    }

    /// The velocity of what is fixed to the body at a place.
    pub(super) fn velocity(&self, place: Space<T>) -> Space<T> {
        let velocity = slope_of(self.origin);
        velocity + carried(self.turn, place - self.origin, !self.is_plane())
    }

    /// Its value.
    #[inline]
    fn velocity_now(&self, place: Space<T>) -> Space<f64> {
        let (turn, arm) = (real(self.turn), real(place) - real(self.origin));
        real(slope_of(self.origin)) + carried(turn, arm, !self.is_plane())
    }
}

/// The velocity of the end of an arm that turns.
#[inline]
fn carried<T: Number>(turn: Space<T>, arm: Space<T>, is_space: bool) -> Space<T> {
    if is_space {
        turn.cross(arm)
    } else {
        Space::new(-arm.y, arm.x, T::constant(0.0)).scale(turn.z)
    }
}

/// The vector product. That of vectors in the plane has one coordinate.
#[inline]
pub(super) fn product<T: MovingNumber>(one: Space<T>, other: Space<T>, is_space: bool) -> Space<T> {
    if is_space {
        return one.cross(other);
    }
    Space::new(T::constant(0.0), T::constant(0.0), one.x * other.y - one.y * other.x)
}

/// Two unit vectors at right angles to a unit vector; in the plane, the one to its left and the normal.
#[inline]
pub(super) fn across<T: MovingNumber>(axis: Space<T>, is_space: bool) -> [Space<T>; 2] {
    if !is_space {
        return [Space::new(-axis.y, axis.x, T::constant(0.0)), along_axis(2)];
    }
    let parts = [axis.x, axis.y, axis.z].map(|part| part.real().abs());
    let smallest = (0..3).min_by(|one, other| parts[*one].total_cmp(&parts[*other]));
    let first = unit(along_axis(smallest.unwrap_or(0)).cross(axis));
    [first, axis.cross(first)]
}

/// The unit vector at right angles to two others, none if they lie on a line up to half of the digits.
pub(super) fn between<T: MovingNumber>(one: Space<T>, other: Space<T>) -> Option<Space<T>> {
    third_point(real(one), [real(other)].into_iter()).map(|_| unit(one.cross(other)))
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
        let mut places: Vec<Space<T>> = Vec::new();
        let mut add = |coordinates: &[T]| {
            let coordinate = |axis: usize| coordinates.get(axis).copied().unwrap_or(T::constant(0.0));
            places.push(Space::new(coordinate(0), coordinate(1), coordinate(2)));
        };
        SkeletonOver::<T>::skeleton_points(functions, parameters, inputs, unknowns, &mut add);
        let joints = places.len() - functions.outline().slides.len();
        for direction in &mut places[joints..] {
            *direction = direction.scale(T::constant(1.0) / direction.norm());
        }
        Self {
            quantities: [parameters, inputs, unknowns, &outputs].concat(),
            places,
            joints,
            is_space: functions.is_space(),
        }
    }
}

impl<T: MovingNumber> MovedMechanism<T> {
    /// The number of coordinates.
    pub(super) fn dimensions(&self) -> usize {
        if self.is_space { 3 } else { 2 }
    }

    /// The place of a point, or a vector.
    #[inline]
    pub(super) fn point(&self, point: PointIndex) -> Space<T> {
        match point {
            PointIndex::Fixed(point) => still(point),
            PointIndex::Moving(coordinates) => {
                let [x, y, z] = coordinates.map(|index| index.map_or(T::constant(0.0), |index| self.quantities[index]));
                Space::new(x, y, z)
            }
        }
    }

    /// The unit vector along a slide.
    pub(super) fn along(&self, slide: usize) -> Space<T> {
        self.places[self.joints + slide]
    }

    /// An axis as a unit vector. It is not finite if it has no length.
    pub(super) fn axis(&self, axis: JointAxis) -> Space<T> {
        match axis {
            JointAxis::Normal => along_axis(2),
            JointAxis::Joints([from, to]) => unit(self.places[to] - self.places[from]),
            JointAxis::Slide(slide) => self.along(slide),
            JointAxis::Vector(vector) => unit(self.point(vector)),
        }
    }

    /// The frames of all bodies.
    pub(super) fn frames(
        &self,
        outline: &Outline<'_>,
        connections: &[Connection],
    ) -> Result<Vec<MovedFrame<T>>, ReactionError> {
        let mut frames = Vec::with_capacity(outline.bodies.len());
        self.frames_into(outline, connections, &mut frames)?;
        Ok(frames)
    }

    /// The same in memory that is there.
    pub(super) fn frames_into(
        &self,
        outline: &Outline<'_>,
        connections: &[Connection],
        frames: &mut Vec<MovedFrame<T>>,
    ) -> Result<(), ReactionError> {
        frames.clear();
        for body in 0..outline.bodies.len() {
            frames.push(self.frame(outline, connections, body)?);
        }
        Ok(())
    }

    fn frame(
        &self,
        outline: &Outline<'_>,
        connections: &[Connection],
        index: usize,
    ) -> Result<MovedFrame<T>, ReactionError> {
        let body = &outline.bodies[index];
        let no_frame = || ReactionError::NoFrame {
            body: body.name.to_string(),
        };
        let own = BodyFrame::of(outline, index).ok_or_else(no_frame)?;
        let [origin, along] = own.origin_and_axis(&self.places, |end, start| end - start);
        if let (BodyFrame::Slide { .. }, true) = (own, self.is_space) {
            let carries = |slide: &Slide| slide.guide == Some(index);
            if !outline.slides.iter().any(carries) {
                let mut slides = outline.slides.iter();
                let slide = slides
                    .find(|slide| slide.joint == body.joints[0])
                    .ok_or_else(no_frame)?;
                // it turns with its guide
                let guide = slide.guide.map(|guide| self.frame(outline, connections, guide));
                return Ok(match guide.transpose()? {
                    Some(guide) => MovedFrame { origin, ..guide },
                    None => MovedFrame {
                        origin,
                        axes: [0, 1, 2].map(along_axis),
                        turn: Space::zero(),
                        first_turn: 0,
                    },
                });
            }
        }
        if real(along).norm_squared() <= f64::MIN_POSITIVE {
            return Err(no_frame());
        }
        let axis = T::unit_of_rigid(along);
        if !self.is_space {
            return Ok(MovedFrame::of_line(origin, axis, false));
        }
        let beside = || {
            let joints = body.joints.iter().skip(2).map(|joint| self.places[*joint] - origin);
            let held = connections.iter().filter(|connection| connection.holds(index));
            joints.chain(held.filter_map(|own| own.hinge).map(|hinge| self.axis(hinge)))
        };
        let third = third_point(real(axis), beside().map(real)).and_then(|third| beside().nth(third));
        Ok(match third {
            Some(third) => MovedFrame::of_plane(origin, axis, third),
            None => MovedFrame::of_line(origin, axis, true),
        })
    }

    /// Whether the joints of each body, and the axes of its hinges, move with its frame.
    pub(super) fn check(
        &self,
        outline: &Outline<'_>,
        connections: &[Connection],
        frames: &[MovedFrame<T>],
    ) -> Result<(), ReactionError> {
        let joints = self.places[..self.joints].iter();
        let largest = joints.map(|joint| size(real(slope_of(*joint)))).fold(0.0, f64::max);
        for (body, frame) in outline.bodies.iter().zip(frames) {
            for &joint in body.joints {
                let place = self.places[joint];
                let rate = size(real(slope_of(place)) - frame.velocity_now(place));
                if rate > RIGID * largest {
                    let body = body.name.to_string();
                    return Err(ReactionError::NotRigid { body, rate });
                }
            }
        }
        let turns = frames.iter().map(|frame| size(real(frame.turn))).fold(0.0, f64::max);
        for connection in connections {
            let Some(JointAxis::Vector(vector)) = connection.hinge else {
                continue;
            };
            let axis = self.axis(JointAxis::Vector(vector));
            for member in [connection.on, connection.by] {
                let turn = member.map_or_else(Space::zero, |body| frames[body].turn);
                let rate = size(real(slope_of(axis) - turn.cross(axis)));
                // an axis of no length has no rate
                if rate.is_nan() || rate > RIGID * turns {
                    return Err(ReactionError::HingeTurns {
                        reaction: connection.name.clone(),
                        body: member_name(outline, member),
                        rate,
                    });
                }
            }
        }
        Ok(())
    }
}
