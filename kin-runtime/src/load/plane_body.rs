//! A rigid body of the plane in the frame of its joints, and a rod of space.

use crate::geometry::Space;
use crate::load::coordinate::{Coordinate, dot};
use crate::load::kinds::{Load, add_mass, not_negative, rigid};
use crate::load::totals::Totals;
use crate::load::{Change, LoadError, LoadedSystem, VaryingVector};
use crate::number::Number;
use crate::picture::Outline;

/// Where the frame of a body lies, by the places of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum BodyFrame {
    /// From its first joint to its second one.
    Joints([usize; 2]),
    /// From its only joint along a slide, which stands so far before the end of the places.
    Slide { joint: usize, before_end: usize },
}

impl BodyFrame {
    /// The frame of a body of an outline, unless nothing tells how it turns.
    pub(crate) fn of(outline: &Outline<'_>, body: usize) -> Option<Self> {
        match *outline.bodies.get(body)?.joints {
            [one, other, ..] => Some(Self::Joints([one, other])),
            [joint] => {
                let slides = || outline.slides.iter();
                let carried = slides().position(|slide| slide.guide == Some(body));
                let slide = carried.or_else(|| slides().position(|slide| slide.joint == joint))?;
                let before_end = slides().count() - slide;
                Some(Self::Slide { joint, before_end })
            }
            [] => None,
        }
    }

    /// Its origin, and a vector along it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn origin_and_axis<V: Copy>(self, places: &[V], minus: impl FnOnce(V, V) -> V) -> [V; 2] {
        match self {
            Self::Joints([one, other]) => [places[one], minus(places[other], places[one])],
            Self::Slide { joint, before_end } => [places[joint], places[places.len() - before_end]],
        }
    }
}

/// The first vector that does not lie along a unit vector, up to half of the digits: the third point of a frame of
/// space lies there.
pub(crate) fn third_point(axis: Space<f64>, mut vectors: impl Iterator<Item = Space<f64>>) -> Option<usize> {
    vectors.position(|vector| axis.cross(vector).norm() > ALONG * vector.norm())
}

/// A vector lies along a unit vector if their product is at most this part of it, half of the digits: √ε.
pub(crate) const ALONG: f64 = 1.0 / (1_u32 << 26) as f64;

/// The centre of a rod of space, from its first joint on. It lies on the line of its joints.
pub(crate) fn centre_on_line(centre: Space<f64>, load: usize) -> Result<f64, LoadError> {
    if centre.y == 0.0 && centre.z == 0.0 {
        Ok(centre.x)
    } else {
        Err(LoadError::BodyInSpace { load })
    }
}

/// A mass with its centre and its moment of inertia about it.
#[derive(Clone, Copy)]
pub(super) struct PlaneBody<F> {
    pub(super) mass: f64,
    /// The centre, in the frame of the body.
    pub(super) centre: [f64; 2],
    /// About all axes at right angles to the axis of the frame.
    pub(super) inertia: f64,
    /// The origin of the frame, and a vector along it.
    pub(super) frame: F,
}

impl<M, P, F> Load<M> for PlaneBody<F>
where
    M: LoadedSystem,
    P: VaryingVector<Change<M::Scalar>>,
    F: Fn(M::Moving) -> [P; 2] + Copy,
{
    const COUNT: usize = 1;

    // The axis is a unit vector e that turns at the rate ω: the energy of rotation is I ω² / 2 = I e' · e' / 2.
    fn add(&self, totals: &mut Totals<M>) -> Result<(), LoadError> {
        let load = totals.load;
        let [origin, along] = [0, 1].map(|part| Coordinate::of_point(&totals.poses, |pose| (self.frame)(pose)[part]));
        rigid(&along, &along).map_err(|rate| LoadError::NotRigid { load, rate })?;
        let square = dot::<M>(&along, &along).motion[0];
        let length = square.sqrt();
        if length.real() <= M::Scalar::SMALLEST_DIVISOR {
            return Err(LoadError::NoDirection { load });
        }
        let [x, y, z] = along.map(|coordinate| coordinate.scale(M::Scalar::constant(1.0) / length));
        let [right, up] = self.centre.map(M::Scalar::constant);
        let centre = [
            origin[0] + x.scale(right) - y.scale(up),
            origin[1] + y.scale(right) + x.scale(up),
            origin[2] + z.scale(right),
        ];
        add_mass(totals, self.mass, &centre)?;
        not_negative(load, "moment of inertia", self.inertia)?;
        let axis = [x, y, z];
        for coordinate in &axis {
            totals.inertia(self.inertia, coordinate, coordinate);
        }
        totals.spin(self.inertia, &axis, &axis);
        Ok(())
    }
}
