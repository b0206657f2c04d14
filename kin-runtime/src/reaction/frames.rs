//! Bodies in motion, in the plane or in space. The plane is that of x and y in space.

use alloc::string::ToString;
use alloc::vec;
use alloc::vec::Vec;

use super::connection::{Connection, member_name};
use super::pose_number::{PoseNumber, unchanging, values};
use super::{MovedNumber, ReactionError};
use crate::any::{AnyMechanism, NearOver, OutputsOver, Pictured, SkeletonOver};
use crate::failure::SolveError;
use crate::geometry::Space;
use crate::load::{ALONG, BodyFrame, PointIndex};
use crate::number::Number;
use crate::number::series::{Series, SeriesOf};
use crate::picture::{Outline, Slide};
use crate::quantity::Dimension;
use crate::solve::{Scalar, unwrap_near};

/// A number with some of its derivatives by a variable.
pub(crate) trait MovingNumber: Number {
    /// A number without derivatives.
    type Still: PoseNumber;

    /// The number without its derivatives.
    fn now(self) -> Self::Still;

    /// The derivative. Its own highest derivative is not known, and is zero.
    #[must_use]
    fn slope(self) -> Self;

    /// The product with a factor that does not move.
    #[must_use]
    fn times(self, factor: f64) -> Self {
        self * Self::constant(factor)
    }

    /// The unit vector along a vector whose length does not change, by the square of this length.
    #[must_use]
    fn unit_of_rigid(vector: Space<Self>, square: Self::Still) -> Space<Self> {
        let _ = square;
        unit(vector)
    }
}

impl<S: PoseNumber, const N: usize> MovingNumber for SeriesOf<S, N> {
    type Still = S;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn now(self) -> S {
        self.coefficients()[0]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn slope(self) -> Self {
        self.differentiate()
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn times(self, factor: f64) -> Self {
        self.scaled(S::constant(factor))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn unit_of_rigid(vector: Space<Self>, square: S) -> Space<Self> {
        let Space { x, y, z } = vector;
        let factor = S::constant(1.0) / square.sqrt();
        Space::new(x.scaled(factor), y.scaled(factor), z.scaled(factor))
    }
}

/// A number of which others, with fewer derivatives, are made.
pub(super) trait Shortened<F>: MovingNumber {
    /// The number with the derivatives that the others have.
    fn shortened(self) -> F;
}

impl<S: PoseNumber, const N: usize, const M: usize> Shortened<SeriesOf<S, M>> for SeriesOf<S, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shortened(self) -> SeriesOf<S, M> {
        self.resized()
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

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn slope_of<T: MovingNumber>(point: Space<T>) -> Space<T> {
    Space::new(point.x.slope(), point.y.slope(), point.z.slope())
}

/// A vector that does not move.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn still<T: MovingNumber>(vector: Space<f64>) -> Space<T> {
    Space::new(T::constant(vector.x), T::constant(vector.y), T::constant(vector.z))
}

/// The unit vector along an axis of coordinates.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn along_axis<T: MovingNumber>(axis: usize) -> Space<T> {
    let part = |own: usize| f64::from(u8::from(own == axis));
    still(Space::new(part(0), part(1), part(2)))
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn unit<T: MovingNumber>(vector: Space<T>) -> Space<T> {
    vector.scale(T::constant(1.0) / vector.norm())
}

/// The product of a vector with a factor that does not move.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn times<T: MovingNumber>(vector: Space<T>, factor: f64) -> Space<T> {
    Space::new(vector.x.times(factor), vector.y.times(factor), vector.z.times(factor))
}

/// Where a vector is now.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn real<T: MovingNumber>(vector: Space<T>) -> Space<f64> {
    Space::new(vector.x.real(), vector.y.real(), vector.z.real())
}

/// The same in each pose.
#[cfg_attr(not(debug_assertions), inline(always))]
fn now<T: MovingNumber>(vector: Space<T>) -> Space<T::Still> {
    Space::new(vector.x.now(), vector.y.now(), vector.z.now())
}

/// A vector with the derivatives that others have.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn shortened<T: Shortened<F>, F>(Space { x, y, z }: Space<T>) -> Space<F> {
    Space::new(x.shortened(), y.shortened(), z.shortened())
}

/// The sum of the sizes of the coordinates.
#[cfg_attr(not(debug_assertions), inline(always))]
fn size<S: PoseNumber>(vector: Space<S>) -> S {
    vector.x.size() + vector.y.size() + vector.z.size()
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

/// The origin of a frame, and its first axis.
struct Line<T> {
    origin: Space<T>,
    axis: Space<T>,
}

fn no_frame(outline: &Outline<'_>, body: usize) -> ReactionError {
    let body = outline.bodies[body].name.to_string();
    ReactionError::NoFrame { body }
}

impl<T: MovingNumber> MovedFrame<T> {
    /// A frame of which the first axis alone is known. It does not turn about it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of_line(origin: Space<T>, axis: Space<T>, is_space: bool) -> Self {
        let mut frame = Self {
            origin,
            axes: [0, 1, 2].map(along_axis),
            turn: Space::zero(),
            first_turn: if is_space { 1 } else { 2 },
        };
        if is_space {
            let [left, normal] = across(axis, true);
            frame.axes = [axis, left, normal];
            frame.turn = axis.cross(slope_of(axis));
        } else {
            frame.move_in_plane(origin, axis);
        }
        frame
    }

    /// Moves a frame of the plane. What is the same for all of them stays where it is.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn move_in_plane(&mut self, origin: Space<T>, axis: Space<T>) {
        (self.origin.x, self.origin.y) = (origin.x, origin.y);
        (self.axes[0].x, self.axes[0].y) = (axis.x, axis.y);
        (self.axes[1].x, self.axes[1].y) = (-axis.y, axis.x);
        self.turn.z = product(axis, slope_of(axis), false).z;
    }

    /// A frame by its first axis, and a vector on the side of its second one.
    #[cfg_attr(not(debug_assertions), inline(always))]
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
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn turns(&self) -> &[Space<T>] {
        &self.axes[self.first_turn..]
    }

    /// The line of a rod of space.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn line(&self) -> Option<Space<T>> {
        (self.first_turn == 1).then_some(self.axes[0])
    }

    /// The place of a point of the frame.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn place(&self, point: Space<f64>) -> Space<T> {
        let parts = self.axes.into_iter().zip([point.x, point.y, point.z]);
        let mut place = self.origin;
        for (axis, part) in parts.filter(|(_, part)| *part != 0.0) {
            place = place + times(axis, part);
        }
        place
    }

    /// Whether the body is one of the plane.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn is_plane(&self) -> bool {
        self.first_turn == 2
    }

    /// The moment of a force at a place about the origin.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn moment(&self, force: Space<T>, at: Space<T>) -> Space<T> {
        product(at - self.origin, force, !self.is_plane())
    }

    /// The moment of a unit force along an axis of coordinates at a place about the origin.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn moment_along(&self, axis: usize, at: Space<T>) -> Space<T> {
        let Space { x, y, z } = at - self.origin;
        let nothing = T::constant(0.0);
        match axis {
            0 => Space::new(nothing, z, -y),
            1 => Space::new(-z, nothing, x),
            _ => Space::new(y, -x, nothing),
        }
    }

    /// The velocity of what is fixed to the body at a place.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn velocity(&self, place: Space<T>) -> Space<T> {
        let velocity = slope_of(self.origin);
        velocity + carried(self.turn, place - self.origin, !self.is_plane())
    }

    /// Its value.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn velocity_now(&self, place: Space<T>) -> Space<T::Still> {
        let (turn, arm) = (now(self.turn), now(place) - now(self.origin));
        now(slope_of(self.origin)) + carried(turn, arm, !self.is_plane())
    }
}

impl<F: MovingNumber> MovedFrame<F> {
    /// Takes over what the equations ask for, which is not the rate at which it turns.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn shorten<T: Shortened<F>>(&mut self, frame: &MovedFrame<T>) {
        if self.is_plane() {
            (self.origin.x, self.origin.y) = (frame.origin.x.shortened(), frame.origin.y.shortened());
        } else {
            self.origin = shortened(frame.origin);
            self.axes = [
                shortened(frame.axes[0]),
                shortened(frame.axes[1]),
                shortened(frame.axes[2]),
            ];
            self.first_turn = frame.first_turn;
        }
    }
}

impl<S: PoseNumber, const N: usize> MovedFrame<SeriesOf<S, N>> {
    /// The same without changes.
    pub(super) fn values(&self) -> MovedFrame<Series<N>> {
        let vector = |Space { x, y, z }| Space::new(values(x), values(y), values(z));
        MovedFrame {
            origin: vector(self.origin),
            axes: self.axes.map(vector),
            turn: vector(self.turn),
            first_turn: self.first_turn,
        }
    }
}

impl MovedFrame<MovedNumber> {
    /// The same in other numbers, with as many terms as they have.
    pub(super) fn in_numbers<S: PoseNumber, const N: usize>(&self) -> MovedFrame<SeriesOf<S, N>> {
        let vector = |vector: Space<MovedNumber>| {
            let [x, y, z] = [vector.x, vector.y, vector.z].map(|part| unchanging(part.resized::<N>()));
            Space::new(x, y, z)
        };
        MovedFrame {
            origin: vector(self.origin),
            axes: self.axes.map(vector),
            turn: vector(self.turn),
            first_turn: self.first_turn,
        }
    }
}

/// The velocity of the end of an arm that turns.
#[cfg_attr(not(debug_assertions), inline(always))]
fn carried<T: Number>(turn: Space<T>, arm: Space<T>, is_space: bool) -> Space<T> {
    if is_space {
        turn.cross(arm)
    } else {
        Space::new(-arm.y, arm.x, T::constant(0.0)).scale(turn.z)
    }
}

/// The vector product. That of vectors in the plane has one coordinate.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn product<T: MovingNumber>(one: Space<T>, other: Space<T>, is_space: bool) -> Space<T> {
    if is_space {
        return one.cross(other);
    }
    Space::new(T::constant(0.0), T::constant(0.0), one.x * other.y - one.y * other.x)
}

/// Two unit vectors at right angles to a unit vector; in the plane, the one to its left and the normal.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn across<T: MovingNumber>(axis: Space<T>, is_space: bool) -> [Space<T>; 2] {
    if !is_space {
        return [Space::new(-axis.y, axis.x, T::constant(0.0)), along_axis(2)];
    }
    let Space { x, y, z } = now(axis);
    let parts = [x, y, z];
    let mut smallest = 0;
    for axis in 1..3 {
        if parts[smallest].exceeds(1.0, parts[axis]) {
            smallest = axis;
        }
    }
    let first = unit(along_axis(smallest).cross(axis));
    [first, axis.cross(first)]
}

/// Whether a vector lies beside a unit vector and not along it, up to half of the digits.
fn lies_beside<S: PoseNumber>(axis: Space<S>, vector: Space<S>) -> bool {
    axis.cross(vector).norm().exceeds(ALONG, vector.norm())
}

/// The unit vector at right angles to a unit vector and to another vector, none if they lie on a line up to half of the
/// digits.
#[inline(never)]
pub(super) fn between<T: MovingNumber>(one: Space<T>, other: Space<T>) -> Option<Space<T>> {
    lies_beside(now(one), now(other)).then(|| unit(one.cross(other)))
}

/// Distances may change by this part of the largest speed, by the rounding of a position that is known to half of its
/// digits.
const RIGID: f64 = 1e-7;

impl<T: Scalar> MovedMechanism<T> {
    /// The mechanism near a position. Angles of outputs are unwrapped to those that are given.
    pub(super) fn near<F>(
        functions: &F,
        parameters: &[T],
        inputs: &[T],
        unknowns: &[f64],
        outputs: &[f64],
    ) -> Result<Self, SolveError>
    where
        F: ?Sized + AnyMechanism + Pictured + NearOver<T> + OutputsOver<T> + SkeletonOver<T>,
    {
        let near: Vec<T> = unknowns.iter().copied().map(T::constant).collect();
        let mut unknowns = near.clone();
        NearOver::<T>::position_near(functions, parameters, inputs, &near, &mut unknowns)?;
        Ok(Self::of(functions, parameters, inputs, &unknowns, outputs))
    }

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

impl<T> MovedMechanism<T> {
    /// The same in other numbers.
    pub(super) fn map<F>(self, change: impl Fn(T) -> F) -> MovedMechanism<F> {
        let places = self.places.into_iter();
        MovedMechanism {
            quantities: self.quantities.into_iter().map(&change).collect(),
            places: places
                .map(|Space { x, y, z }| Space::new(change(x), change(y), change(z)))
                .collect(),
            joints: self.joints,
            is_space: self.is_space,
        }
    }
}

impl<T: MovingNumber> MovedMechanism<T> {
    /// The number of coordinates.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn dimensions(&self) -> usize {
        if self.is_space { 3 } else { 2 }
    }

    /// The place of a point, or a vector.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn point(&self, point: PointIndex) -> Space<T> {
        match point {
            PointIndex::Fixed(point) => still(point),
            PointIndex::Moving(coordinates) => {
                let [x, y, z] = coordinates;
                Space::new(self.coordinate(x), self.coordinate(y), self.coordinate(z))
            }
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn coordinate(&self, index: Option<usize>) -> T {
        match index {
            Some(index) => self.quantities[index],
            None => T::constant(0.0),
        }
    }

    /// Moves a place to where its coordinates are.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn move_place(&mut self, index: usize, point: PointIndex) {
        let Space { x, y, z } = self.point(point);
        let place = &mut self.places[index];
        (place.x, place.y) = (x, y);
        if self.is_space {
            place.z = z;
        }
    }

    /// The unit vector along a slide.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn along(&self, slide: usize) -> Space<T> {
        self.places[self.joints + slide]
    }

    /// An axis as a unit vector. It is not finite if it has no length.
    #[cfg_attr(not(debug_assertions), inline(always))]
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
        let bodies = 0..outline.bodies.len();
        bodies.map(|body| self.frame(outline, connections, body)).collect()
    }

    /// Moves the frames of all bodies to another pose.
    #[inline(never)]
    pub(super) fn move_frames(
        &self,
        outline: &Outline<'_>,
        connections: &[Connection],
        frames: &mut [MovedFrame<T>],
    ) -> Result<(), ReactionError> {
        for (body, frame) in frames.iter_mut().enumerate() {
            if self.is_space {
                *frame = self.frame(outline, connections, body)?;
            } else {
                let own = BodyFrame::of(outline, body).ok_or_else(|| no_frame(outline, body))?;
                let Line { origin, axis } = self.line(outline, body, own)?;
                frame.move_in_plane(origin, axis);
            }
        }
        Ok(())
    }

    /// The line on which the frame of a body lies.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn line(&self, outline: &Outline<'_>, index: usize, own: BodyFrame) -> Result<Line<T>, ReactionError> {
        let [origin, along] = own.origin_and_axis(&self.places, |end, start| end - start);
        let square = now(along).norm_squared();
        if !square.exceeds(f64::MIN_POSITIVE, T::Still::constant(1.0)) && !square.real().is_nan() {
            return Err(no_frame(outline, index));
        }
        let axis = T::unit_of_rigid(along, square);
        Ok(Line { origin, axis })
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn frame(
        &self,
        outline: &Outline<'_>,
        connections: &[Connection],
        index: usize,
    ) -> Result<MovedFrame<T>, ReactionError> {
        let body = &outline.bodies[index];
        let no_frame = || no_frame(outline, index);
        let own = BodyFrame::of(outline, index).ok_or_else(no_frame)?;
        let line = self.line(outline, index, own);
        if let (BodyFrame::Slide { .. }, true) = (own, self.is_space) {
            let carries = |slide: &Slide| slide.guide == Some(index);
            if !outline.slides.iter().any(carries) {
                let mut slides = outline.slides.iter();
                let slide = slides
                    .find(|slide| slide.joint == body.joints[0])
                    .ok_or_else(no_frame)?;
                let origin = self.places[body.joints[0]];
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
        let Line { origin, axis } = line?;
        if !self.is_space {
            return Ok(MovedFrame::of_line(origin, axis, false));
        }
        let others = || {
            let joints = body.joints.iter().skip(2).map(|joint| self.places[*joint] - origin);
            let held = connections.iter().filter(|connection| connection.holds(index));
            joints.chain(held.filter_map(|own| own.hinge).map(|hinge| self.axis(hinge)))
        };
        let third = others().find(|vector| lies_beside(now(axis), now(*vector)));
        Ok(match third {
            Some(third) => MovedFrame::of_plane(origin, axis, third),
            None => MovedFrame::of_line(origin, axis, true),
        })
    }

    /// Whether the joints of each body, and the axes of its hinges, move with its frame.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn check(
        &self,
        outline: &Outline<'_>,
        connections: &[Connection],
        frames: &[MovedFrame<T>],
    ) -> Result<(), ReactionError> {
        let mut largest = T::Still::constant(0.0);
        for joint in &self.places[..self.joints] {
            largest = largest.or_larger(size(now(slope_of(*joint))));
        }
        for (body, frame) in outline.bodies.iter().zip(frames) {
            for &joint in body.joints {
                let place = self.places[joint];
                let rate = size(now(slope_of(place)) - frame.velocity_now(place));
                if rate.exceeds(RIGID, largest) {
                    let (body, rate) = (body.name.to_string(), rate.real());
                    return Err(ReactionError::NotRigid { body, rate });
                }
            }
        }
        let mut turns = T::Still::constant(0.0);
        for frame in frames {
            turns = turns.or_larger(size(now(frame.turn)));
        }
        for connection in connections {
            let Some(JointAxis::Vector(vector)) = connection.hinge else {
                continue;
            };
            let axis = self.axis(JointAxis::Vector(vector));
            for member in [connection.on, connection.by] {
                let turn = member.map_or_else(Space::zero, |body| frames[body].turn);
                let rate = size(now(slope_of(axis) - turn.cross(axis)));
                // an axis of no length has no rate
                if rate.real().is_nan() || rate.exceeds(RIGID, turns) {
                    return Err(ReactionError::HingeTurns {
                        reaction: connection.name.clone(),
                        body: member_name(outline, member),
                        rate: rate.real(),
                    });
                }
            }
        }
        Ok(())
    }
}
