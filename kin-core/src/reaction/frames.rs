//! Bodies in motion, in the plane or in space. The plane is that of x and y in space.

use alloc::string::ToString;
use alloc::vec::Vec;

use super::ReactionError;
use super::connection::{Connection, member_name};
use crate::geometry::Space;
use crate::load::{BodyFrame, PointIndex, third_point};
use crate::number::Number;
use crate::number::series::Series;
use crate::picture::{Outline, Slide};

/// A mechanism in motion: its quantities and the places of its picture, as series.
#[derive(Clone, Debug)]
pub(crate) struct MovedMechanism<const N: usize> {
    /// The parameters, inputs, unknowns and outputs.
    pub(crate) quantities: Vec<Series<N>>,
    /// The joints, and the directions of the slides as unit vectors.
    pub(crate) places: Vec<Space<Series<N>>>,
    /// The number of joints.
    pub(crate) joints: usize,
    pub(crate) is_space: bool,
}

/// The derivative of a series. Its last term is not known, and is zero.
pub(super) fn slope<const N: usize>(series: Series<N>) -> Series<N> {
    let derivatives = series.derivatives();
    Series::from_derivatives(core::array::from_fn(|order| {
        derivatives.get(order + 1).copied().unwrap_or(0.0)
    }))
}

pub(super) fn slope_of<const N: usize>(point: Space<Series<N>>) -> Space<Series<N>> {
    Space::new(slope(point.x), slope(point.y), slope(point.z))
}

/// A vector that does not move.
pub(super) fn still<const N: usize>(vector: Space<f64>) -> Space<Series<N>> {
    Space::new(
        Series::constant(vector.x),
        Series::constant(vector.y),
        Series::constant(vector.z),
    )
}

/// The unit vector along an axis of coordinates.
pub(super) fn along_axis<const N: usize>(axis: usize) -> Space<Series<N>> {
    let part = |own: usize| f64::from(u8::from(own == axis));
    still(Space::new(part(0), part(1), part(2)))
}

pub(super) fn unit<const N: usize>(vector: Space<Series<N>>) -> Space<Series<N>> {
    vector.scale(Series::constant(1.0) / vector.norm())
}

/// Where a vector is now.
pub(super) fn real<const N: usize>(vector: Space<Series<N>>) -> Space<f64> {
    Space::new(vector.x.real(), vector.y.real(), vector.z.real())
}

/// The sum of the sizes of the coordinates.
fn size<const N: usize>(vector: Space<Series<N>>) -> f64 {
    vector.x.real().abs() + vector.y.real().abs() + vector.z.real().abs()
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
pub(super) struct MovedFrame<const N: usize> {
    pub(super) origin: Space<Series<N>>,
    /// Unit vectors at right angles to each other. Those of a body in the plane are its own axis, the one to the left
    /// of it, and the normal of the plane.
    pub(super) axes: [Space<Series<N>>; 3],
    /// The vector of the rate at which it turns.
    pub(super) turn: Space<Series<N>>,
    /// The first of the axes about which the body has an equation of moments. A rod of space whose points lie on a line
    /// has none about this line, about which nothing tells how it turns.
    pub(super) first_turn: usize,
}

impl<const N: usize> MovedFrame<N> {
    /// A frame of which the first axis alone is known. It does not turn about it.
    fn of_line(origin: Space<Series<N>>, axis: Space<Series<N>>, is_space: bool) -> Self {
        let [left, normal] = across(axis, is_space);
        Self {
            origin,
            axes: [axis, left, normal],
            turn: product(axis, slope_of(axis), is_space),
            first_turn: if is_space { 1 } else { 2 },
        }
    }

    /// A frame by its first axis, and a vector on the side of its second one.
    fn of_plane(origin: Space<Series<N>>, axis: Space<Series<N>>, beside: Space<Series<N>>) -> Self {
        let normal = unit(axis.cross(beside));
        let axes = [axis, normal.cross(axis), normal];
        // with unit vectors e at right angles, the rate is half the sum of e × e'
        let turn = axes.into_iter().fold(Space::zero(), |sum: Space<Series<N>>, axis| {
            sum + axis.cross(slope_of(axis))
        });
        Self {
            origin,
            axes,
            turn: turn.scale(Series::constant(0.5)),
            first_turn: 0,
        }
    }

    /// The axes about which the body has an equation of moments.
    pub(super) fn turns(&self) -> &[Space<Series<N>>] {
        &self.axes[self.first_turn..]
    }

    /// The line of a rod of space.
    pub(super) fn line(&self) -> Option<Space<Series<N>>> {
        (self.first_turn == 1).then_some(self.axes[0])
    }

    /// The place of a point of the frame.
    pub(super) fn place(&self, point: Space<f64>) -> Space<Series<N>> {
        let parts = self.axes.into_iter().zip([point.x, point.y, point.z]);
        let mut place = self.origin;
        for (axis, part) in parts.filter(|(_, part)| *part != 0.0) {
            place = place + axis.scale(Series::constant(part));
        }
        place
    }

    /// Whether the body is one of the plane.
    fn is_plane(&self) -> bool {
        self.first_turn == 2
    }

    /// The moment of a force at a place about the origin.
    pub(super) fn moment(&self, force: Space<Series<N>>, at: Space<Series<N>>) -> Space<Series<N>> {
        product(at - self.origin, force, !self.is_plane())
    }

    /// The parts of a moment for which the body has equations.
    pub(super) fn parts(&self, moment: Space<Series<N>>) -> Vec<Series<N>> {
        if self.is_plane() {
            return [moment.z].into();
        }
        self.turns().iter().map(|axis| axis.dot(moment)).collect()
    }

    /// The velocity of what is fixed to the body at a place.
    pub(super) fn velocity(&self, place: Space<Series<N>>) -> Space<Series<N>> {
        let arm = place - self.origin;
        let across = if self.is_plane() {
            Space::new(-arm.y, arm.x, Series::ZERO).scale(self.turn.z)
        } else {
            self.turn.cross(arm)
        };
        slope_of(self.origin) + across
    }
}

/// The vector product. That of vectors in the plane has one coordinate.
pub(super) fn product<const N: usize>(
    one: Space<Series<N>>,
    other: Space<Series<N>>,
    is_space: bool,
) -> Space<Series<N>> {
    if is_space {
        return one.cross(other);
    }
    Space::new(Series::ZERO, Series::ZERO, one.x * other.y - one.y * other.x)
}

/// Two unit vectors at right angles to a unit vector; in the plane, the one to its left and the normal.
pub(super) fn across<const N: usize>(axis: Space<Series<N>>, is_space: bool) -> [Space<Series<N>>; 2] {
    if !is_space {
        return [Space::new(-axis.y, axis.x, Series::ZERO), along_axis(2)];
    }
    let parts = [axis.x, axis.y, axis.z].map(|part| part.real().abs());
    let smallest = (0..3).min_by(|one, other| parts[*one].total_cmp(&parts[*other]));
    let first = unit(along_axis(smallest.unwrap_or(0)).cross(axis));
    [first, axis.cross(first)]
}

/// The unit vector at right angles to two others, none if they lie on a line up to half of the digits.
pub(super) fn between<const N: usize>(one: Space<Series<N>>, other: Space<Series<N>>) -> Option<Space<Series<N>>> {
    third_point(real(one), [real(other)].into_iter()).map(|_| unit(one.cross(other)))
}

/// Distances may change by this part of the largest speed, by the rounding of a position that is known to half of its
/// digits.
const RIGID: f64 = 1e-7;

impl<const N: usize> MovedMechanism<N> {
    /// The number of coordinates.
    pub(super) fn dimensions(&self) -> usize {
        if self.is_space { 3 } else { 2 }
    }

    /// The place of a point, or a vector.
    pub(super) fn point(&self, point: PointIndex) -> Space<Series<N>> {
        match point {
            PointIndex::Fixed(point) => still(point),
            PointIndex::Moving(coordinates) => {
                let [x, y, z] = coordinates.map(|index| index.map_or(Series::ZERO, |index| self.quantities[index]));
                Space::new(x, y, z)
            }
        }
    }

    /// The unit vector along a slide.
    pub(super) fn along(&self, slide: usize) -> Space<Series<N>> {
        self.places[self.joints + slide]
    }

    /// An axis as a unit vector. It is not finite if it has no length.
    pub(super) fn axis(&self, axis: JointAxis) -> Space<Series<N>> {
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
    ) -> Result<Vec<MovedFrame<N>>, ReactionError> {
        let mut frames = Vec::with_capacity(outline.bodies.len());
        for body in 0..outline.bodies.len() {
            frames.push(self.frame(outline, connections, body)?);
        }
        Ok(frames)
    }

    fn frame(
        &self,
        outline: &Outline<'_>,
        connections: &[Connection],
        index: usize,
    ) -> Result<MovedFrame<N>, ReactionError> {
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
        if along.norm_squared().real() <= f64::MIN_POSITIVE {
            return Err(no_frame());
        }
        let axis = unit(along);
        if !self.is_space {
            return Ok(MovedFrame::of_line(origin, axis, false));
        }
        let joints = body.joints.iter().skip(2).map(|joint| self.places[*joint] - origin);
        let axes = connections.iter().filter(|connection| connection.holds(index));
        let axes = axes
            .filter_map(|connection| connection.hinge)
            .map(|hinge| self.axis(hinge));
        let beside: Vec<Space<Series<N>>> = joints.chain(axes).collect();
        let third = third_point(real(axis), beside.iter().copied().map(real));
        Ok(match third {
            Some(third) => MovedFrame::of_plane(origin, axis, beside[third]),
            None => MovedFrame::of_line(origin, axis, true),
        })
    }

    /// Whether the joints of each body, and the axes of its hinges, move with its frame.
    pub(super) fn check(
        &self,
        outline: &Outline<'_>,
        connections: &[Connection],
        frames: &[MovedFrame<N>],
    ) -> Result<(), ReactionError> {
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
        let turns = frames.iter().map(|frame| size(frame.turn)).fold(0.0, f64::max);
        for connection in connections {
            let Some(JointAxis::Vector(vector)) = connection.hinge else {
                continue;
            };
            let axis = self.axis(JointAxis::Vector(vector));
            for member in [connection.on, connection.by] {
                let turn = member.map_or_else(Space::zero, |body| frames[body].turn);
                let rate = size(slope_of(axis) - turn.cross(axis));
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
