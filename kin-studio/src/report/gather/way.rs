//! The motion of a report: the moving input over its range, in one assembly.

use kin_core::cycle::Cycle;
use kin_core::sweep::Sweep as _;
use kin_core::sweep::{Course, StraightLine};
use kin_core::{Mechanism, Pose as _, Row as _, SolveError};

use super::place::{self, Own};
use crate::report::{Draft, ReportError};

/// The rows of a sweep over the range.
const ROWS: usize = 181;

/// A value of the moving input, and the pose there.
pub(super) type At<M> = (f64, Result<<M as Mechanism>::Pose, SolveError>);

/// The sweeps over the range. Closed forms need one. Coupled blocks are followed from a position to both ends.
pub(super) struct Way<M: Mechanism<Scalar = f64>> {
    pub(super) mechanism: M,
    inputs: M::Inputs<f64>,
    moving: usize,
    /// The sweep downwards comes first, if there are two.
    pub(super) courses: Vec<Course<M, StraightLine>>,
    /// The places on the range where the assembly closes, as the branches tell.
    closes: Vec<[f64; 2]>,
}

impl<M: Mechanism<Scalar = f64>> Way<M> {
    pub(super) fn new(
        draft: &Draft<M>,
        moving: usize,
        range: [f64; 2],
        cycle: &Cycle<M>,
        own: &Own<M>,
    ) -> Result<Self, ReportError> {
        let inputs = |place: f64| M::Inputs::from_fn(|input| if input == moving { place } else { draft.inputs[input] });
        let course = |assembly: M::Assembly, from: f64, to: f64| {
            draft
                .mechanism
                .sweep(assembly)
                .between(inputs(from), inputs(to), ROWS)
                // a sweep downwards has a positive speed downwards
                .speed(if to < from { -draft.speed } else { draft.speed })
        };
        let [low, high] = range;
        let branch = own.branches.first().map(|index| &cycle.branches()[*index]);
        let is_turning = branch.is_some_and(kin_core::cycle::Branch::is_full_turn);
        let inside = |[from, to]: [f64; 2]| [from.max(low), to.min(high)];
        let closes = match branch {
            Some(_) if is_turning => vec![range],
            Some(branch) if M::ASSEMBLY_COUNT == 0 => vec![inside(branch.ends().map(|end| end.input))],
            _ => Vec::new(),
        };
        if M::ASSEMBLY_COUNT > 0 {
            return Ok(Self {
                mechanism: draft.mechanism,
                inputs: draft.inputs,
                moving,
                courses: vec![course(own.assembly, low, high)],
                closes,
            });
        }
        let (place, near) = own.start;
        let start = match (own.branches.first(), branch) {
            (Some(&index), Some(branch)) => {
                let ends = branch.ends().map(|end| end.input);
                let start = if is_turning {
                    low
                } else {
                    let [from, to] = inside(ends);
                    place::between_places(from, to)
                };
                let found = cycle.position_on(index, start);
                Some((start, found.map_err(|error| ReportError::ClosesNowhere { error })?))
            }
            _ => None,
        };
        let (start, near) = start.unwrap_or((place, near));
        let assembly = draft.mechanism.assembly_near(inputs(start), near);
        let mut courses = Vec::new();
        if start > low {
            courses.push(course(assembly, start, low));
        }
        if start < high {
            courses.push(course(assembly, start, high));
        }
        Ok(Self {
            mechanism: draft.mechanism,
            inputs: draft.inputs,
            moving,
            courses,
            closes,
        })
    }

    /// The values of inputs and unknowns in a pose.
    pub(super) fn values(&self, place: f64, pose: &M::Pose) -> (M::Inputs<f64>, M::Unknowns<f64>) {
        let motions = pose.unknown_motions();
        (
            M::Inputs::from_fn(|input| {
                if input == self.moving {
                    place
                } else {
                    self.inputs[input]
                }
            }),
            M::Unknowns::from_fn(|unknown| motions[unknown][0]),
        )
    }

    /// The place where two sweeps begin, if there are two.
    pub(super) fn start(&self) -> Option<f64> {
        match self.courses.as_slice() {
            [down, _] => Some(down.at(0)),
            _ => None,
        }
    }

    /// The way of the moving input on which each sweep closes, if it is known.
    pub(super) fn lengths(&self) -> Option<Vec<f64>> {
        let [from, to] = *self.closes.first()?;
        let start = self.start()?;
        Some(vec![start - from, to - start])
    }

    /// The poses of the range in ascending order.
    pub(super) fn poses(&self) -> Vec<At<M>> {
        let mut all = Vec::new();
        for (number, course) in self.courses.iter().enumerate() {
            let rows = course.rows().enumerate();
            let mut poses: Vec<At<M>> = rows.map(|(row, pose)| (course.at(row), pose)).collect();
            if course.at(0) > course.at(course.count() - 1) {
                poses.reverse();
            } else if number > 0 {
                // the place where both begin is there already
                poses.drain(..1);
            }
            all.append(&mut poses);
        }
        all
    }
}
