//! The motion of a report: the moving input over its range, in one assembly.

use kin_core::SolveError;
use kin_core::any::AssemblyChoice;
use kin_core::linkage::{AnyCycle, AnyPose, AnySweep};
use kin_core::sweep::StraightLine;

use super::place::{self, Own};
use crate::report::ReportError;
use crate::report::draft::Wishes;

/// The rows of a sweep over the range.
const ROWS: usize = 181;

/// A value of the moving input, and the pose there.
pub(super) type At = (f64, Result<AnyPose, SolveError>);

/// The sweeps over the range. Closed forms need one. Coupled blocks are followed from a position to both ends.
pub(super) struct Way {
    /// The sweep downwards comes first, if there are two.
    pub(super) courses: Vec<AnySweep<StraightLine>>,
    /// The places on the range where the assembly closes, as the branches tell.
    closes: Vec<[f64; 2]>,
}

impl Way {
    pub(super) fn new(
        wishes: &Wishes,
        moving: usize,
        range: [f64; 2],
        cycle: &AnyCycle,
        own: &Own,
    ) -> Result<Self, ReportError> {
        let linkage = &wishes.linkage;
        let inputs = |place: f64| wishes.inputs_at(moving, place);
        let course = |assembly: &AssemblyChoice, from: f64, to: f64| {
            linkage
                .sweep(assembly.clone())
                .between(&inputs(from), &inputs(to), ROWS)
                // a sweep downwards has a positive speed downwards
                .speed(if to < from { -wishes.speed } else { wishes.speed })
        };
        let [low, high] = range;
        let branch = own.branches.first().map(|index| &cycle.branches()[*index]);
        let is_turning = branch.is_some_and(kin_core::cycle::Branch::is_full_turn);
        let inside = |[from, to]: [f64; 2]| [from.max(low), to.min(high)];
        let closes = match branch {
            Some(_) if is_turning => vec![range],
            Some(branch) if own.assembly.index().is_none() => vec![inside(branch.ends().map(|end| end.input))],
            _ => Vec::new(),
        };
        if own.assembly.index().is_some() {
            return Ok(Self {
                courses: vec![course(&own.assembly, low, high)],
                closes,
            });
        }
        let (place, near) = own.start.clone();
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
        let assembly = linkage.assembly_near(&inputs(start), &near);
        let mut courses = Vec::new();
        if start > low {
            courses.push(course(&assembly, start, low));
        }
        if start < high {
            courses.push(course(&assembly, start, high));
        }
        Ok(Self { courses, closes })
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
    pub(super) fn poses(&self) -> Vec<At> {
        let mut all = Vec::new();
        for (number, course) in self.courses.iter().enumerate() {
            let mut poses = course.rows();
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
