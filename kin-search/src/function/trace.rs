//! The path of a mechanism's point over the poses of a candidate.

use datafusion::common::{Result, exec_datafusion_err};
use kin_core::any::Description;
use kin_core::batch::{Column, Outcome, Slot, Vectors, WantedColumns};

use super::arguments::FEWEST_ROWS;
use super::search::Candidate;
use super::solver::Solver;

/// The index of the first output of a mechanism that is a point of the plane: that of its x.
pub(crate) fn point_of(description: &Description<'_>) -> Option<usize> {
    let outputs = description.outputs;
    (0..outputs.len()).find(|index| {
        let part = |offset: usize, end: &str| {
            let base = outputs[*index].name.strip_suffix(".x");
            let name = outputs
                .get(index + offset)
                .and_then(|output| output.name.strip_suffix(end));
            base.is_some() && name == base
        };
        part(1, ".y") && !part(2, ".z")
    })
}

/// Room for the path of a candidate.
#[derive(Debug, Default)]
pub(crate) struct Trace {
    inputs: Vec<f64>,
    x: Vec<f64>,
    y: Vec<f64>,
    x_velocity: Vec<f64>,
    y_velocity: Vec<f64>,
    outcomes: Vec<Outcome>,
    poses: usize,
}

impl Trace {
    /// Solves for the path at these values of the input.
    pub(crate) fn solve(
        &mut self,
        solver: &dyn Solver,
        candidate: &Candidate<'_>,
        inputs: impl ExactSizeIterator<Item = f64>,
        point: usize,
        vectors: Vectors,
    ) -> Result<()> {
        self.poses = inputs.len();
        self.inputs.clear();
        self.inputs.extend(inputs);
        // Fewer would be solved one by one, and round differently.
        let last = self.inputs.last().copied().unwrap_or(0.0);
        let count = self.poses.max(FEWEST_ROWS);
        self.inputs.resize(count, last);
        let Self {
            x,
            y,
            x_velocity,
            y_velocity,
            ..
        } = self;
        for column in [&mut *x, &mut *y, &mut *x_velocity, &mut *y_velocity] {
            column.resize(count, 0.0);
        }
        self.outcomes.resize(count, Outcome::Unsolved);
        let mut wanted = WantedColumns::new(vec![
            (Slot::Output(point, 0), x.as_mut_slice()),
            (Slot::Output(point + 1, 0), y.as_mut_slice()),
            (Slot::Output(point, 1), x_velocity.as_mut_slice()),
            (Slot::Output(point + 1, 1), y_velocity.as_mut_slice()),
        ]);
        let solved = candidate.given(Column::Each(&self.inputs), |given| {
            solver.solve_batch(given, &mut wanted, &mut self.outcomes, vectors)
        });
        solved
            .map(|_| ())
            .map_err(|mismatch| exec_datafusion_err!("{mismatch}"))
    }

    /// The number of poses that close.
    pub(crate) fn closed(&self) -> usize {
        self.outcomes[..self.poses]
            .iter()
            .filter(|outcome| outcome.is_solved())
            .count()
    }

    /// Whether a pose closes.
    pub(crate) fn is_closed(&self, pose: usize) -> bool {
        self.outcomes[pose].is_solved()
    }

    /// The number of poses.
    pub(crate) fn poses(&self) -> usize {
        self.poses
    }

    /// The point in a pose.
    pub(crate) fn point(&self, pose: usize) -> [f64; 2] {
        [self.x[pose], self.y[pose]]
    }

    /// The velocity in a pose.
    pub(crate) fn velocity(&self, pose: usize) -> [f64; 2] {
        [self.x_velocity[pose], self.y_velocity[pose]]
    }
}

/// A share of some poses.
pub(crate) fn share(part: usize, all: usize) -> f64 {
    let count = |poses: usize| f64::from(u32::try_from(poses).unwrap_or(u32::MAX));
    count(part) / count(all)
}
