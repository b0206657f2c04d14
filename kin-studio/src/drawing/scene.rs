//! The content of a drawing: a position, and the traces of a sweep through others.

use std::f64::consts::TAU;

use kin_core::prelude::*;
use kin_core::{Dimension, Outline, PlaneOrSpace, PointArray, Skeleton};

use super::drive::{self, Drive};
use super::sweep::{self, extent};

/// A mechanism as it is drawn.
#[derive(Clone, Debug)]
pub struct Scene {
    /// The joints of the ground, of bodies and of slides.
    pub outline: Outline,
    /// The joints.
    pub joints: Vec<Space>,
    /// A direction for each slide.
    pub directions: Vec<Space>,
    /// Whether it lies in the plane.
    pub is_plane: bool,
    /// The joints and behind them the directions at other positions, in the order of the sweep.
    pub sweep: Vec<Vec<Space>>,
    /// The parts that the inputs drive.
    pub drives: Vec<Drive>,
    /// Further labels and marks.
    pub notes: Vec<Note>,
}

/// A mark that a figure asks for.
#[derive(Clone, Debug, PartialEq)]
pub enum Note {
    /// A text beside a point.
    Text {
        /// The point.
        at: Space,
        /// The text.
        text: String,
    },
    /// An angle in the plane, from the x axis.
    Angle {
        /// Its vertex.
        at: Space,
        /// In radians.
        angle: f64,
        /// Its name.
        text: String,
    },
    /// A dashed line.
    Dashes {
        /// Its first point.
        from: Space,
        /// Its last point.
        to: Space,
    },
}

impl Scene {
    /// A skeleton by itself.
    pub fn of<P>(skeleton: &Skeleton<P>) -> Self
    where
        P: PointArray<Point: PlaneOrSpace<Scalar = f64>>,
    {
        Self {
            outline: *skeleton.outline(),
            joints: skeleton.joints().iter().map(|joint| joint.in_space()).collect(),
            directions: skeleton
                .slides()
                .map(|(_, [_, direction])| direction.in_space())
                .collect(),
            is_plane: skeleton.is_plane(),
            sweep: Vec::new(),
            drives: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// A mechanism at given inputs, with a sweep of the first input by a revolution, or as far as it goes, and with the
    /// parts that the inputs drive.
    ///
    /// # Errors
    /// [`SolveError`], if the mechanism does not close.
    pub fn of_mechanism<M: Mechanism<Scalar = f64>>(
        mechanism: &M,
        inputs: M::Inputs<f64>,
        assembly: M::Assembly,
    ) -> Result<Self, SolveError> {
        let unknowns = mechanism.position(inputs, assembly)?;
        let points = sweep::points_of(mechanism, inputs, unknowns);
        let count = points.len().saturating_sub(M::OUTLINE.slides.len());
        let (joints, directions) = points.split_at(count);
        let range = match M::DESCRIPTION.inputs.first().map(|input| input.dimension) {
            Some(Dimension::Length) => 0.25 * extent(joints),
            _ => TAU,
        };
        Ok(Self {
            outline: M::OUTLINE,
            joints: joints.to_vec(),
            directions: directions.to_vec(),
            is_plane: <M::SkeletonPoints as PointArray>::Point::IS_PLANE,
            sweep: sweep::sweep(mechanism, inputs, unknowns, range),
            drives: drive::drives(mechanism, inputs, unknowns),
            notes: Vec::new(),
        })
    }

    /// The same with a further note.
    #[must_use]
    pub fn with(mut self, note: Note) -> Self {
        self.notes.push(note);
        self
    }

    /// The path of a joint through the sweep.
    pub(super) fn path(&self, joint: usize) -> Vec<Space> {
        self.sweep
            .iter()
            .filter_map(|points| points.get(joint).copied())
            .collect()
    }

    /// The joints that are marked points and move, unless their paths are circles about a fixed pivot or the lines of
    /// slides.
    pub(super) fn traced(&self) -> Vec<usize> {
        let is_on_a_circle = |joint: usize| {
            let bodies = self.outline.bodies.iter().filter(|body| body.joints.contains(&joint));
            let mut fixed = bodies
                .flat_map(|body| body.joints)
                .filter(|other| self.outline.ground.contains(other));
            fixed.next().is_some()
        };
        let is_on_a_guide = |joint: usize| {
            let mut slides = self.outline.slides.iter();
            slides.any(|slide| slide.joint == joint && slide.guide.is_none())
        };
        let points = self.outline.points.iter().map(|&(_, joint)| joint);
        points
            .filter(|&joint| !self.outline.ground.contains(&joint) && !is_on_a_circle(joint) && !is_on_a_guide(joint))
            .collect()
    }

    /// The travel of a slide's joint along its line: the least and the largest shift, from the first joint of the body
    /// that guides it, or else from the joint itself.
    pub(super) fn travel(&self, slide: usize) -> [f64; 2] {
        let Some((slide_of, &direction)) = self.outline.slides.get(slide).zip(self.directions.get(slide)) else {
            return [0.0; 2];
        };
        let origin = |points: &[Space]| match slide_of
            .guide
            .and_then(|body| self.outline.bodies.get(body)?.joints.first())
        {
            Some(&first) => points[first],
            None => self.joints[slide_of.joint],
        };
        let along = |points: &[Space], direction: Space| {
            (points[slide_of.joint] - origin(points)).dot(direction.scale(1.0 / direction.norm()))
        };
        let mut travel = [along(&self.joints, direction); 2];
        for points in &self.sweep {
            let here = along(points, points[self.joints.len() + slide]);
            travel = [travel[0].min(here), travel[1].max(here)];
        }
        travel
    }

    /// Whether a slide's line keeps its direction through the sweep.
    pub(super) fn keeps_direction(&self, slide: usize) -> bool {
        self.sweep.iter().all(|points| {
            let (here, there) = (self.directions[slide], points[self.joints.len() + slide]);
            here.cross(there).norm() <= 1e-9 * here.norm() * there.norm()
        })
    }
}
