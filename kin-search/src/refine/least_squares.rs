//! Least squares with exact derivatives: a bounded Levenberg-Marquardt method, then a reflective trust region.

use std::convert::Infallible;

use basin::{BoundedLevenbergMarquardt, DenseMatrix, Executor, Jacobian, PointState, Residual, TrustRegionReflective};
use kin_core::Mechanism;

use super::scaled::Scaled;
use crate::objective::{Design, Objective};

/// A row where the mechanism does not close: larger than any error, so that the step is refused, with a square that is
/// finite.
const OPEN: f64 = 1e100;
/// The relative change of the sum of squares below which the second method takes over from the first.
const NEARLY_SETTLED: f64 = 1e-9;
/// The largest number of steps of the second method, each of which takes as long as thirty of the first.
const LAST_STEPS: u64 = 50;
/// The relative change of the sum of squares, and of the point, below which a step is the last one: a few roundings.
const SETTLED: f64 = 4.0 * f64::EPSILON;

impl<M: Mechanism<Scalar = f64>> Residual for Scaled<'_, M> {
    type Param = Vec<f64>;
    type Output = Vec<f64>;
    type Error = Infallible;

    /// The rows. Where the mechanism does not close they are too large for a step to there.
    fn residual(&self, point: &Vec<f64>) -> Result<Vec<f64>, Infallible> {
        let rows = self.objective.residuals(&self.at(point));
        Ok(rows.unwrap_or_else(|| vec![OPEN; self.objective.row_count()]))
    }
}

impl<M: Mechanism<Scalar = f64>> Jacobian for Scaled<'_, M> {
    type Jacobian = DenseMatrix<f64>;

    fn jacobian(&self, point: &Vec<f64>) -> Result<DenseMatrix<f64>, Infallible> {
        let design = self.at(point);
        let columns = self.sought.len();
        let rows = self.objective.row_count();
        let places: Vec<usize> = self.sought.iter().map(|(place, _)| *place).collect();
        let found = self.objective.derivatives(&design.values, design.assembly, &places);
        let mut derivatives = found.unwrap_or_else(|| vec![f64::NAN; rows * columns]);
        for row in derivatives.chunks_exact_mut(columns.max(1)) {
            for (derivative, (_, [low, high])) in row.iter_mut().zip(&self.sought) {
                *derivative *= high - low;
            }
        }
        Ok(DenseMatrix::from_row_slice(rows, columns, &derivatives))
    }
}

/// Half of the sum of squares; infinite if the mechanism does not close.
pub(crate) fn cost<M: Mechanism<Scalar = f64>>(objective: &Objective<M>, design: &Design<M>) -> f64 {
    let rows = objective.residuals(design);
    rows.map_or(f64::INFINITY, |rows| {
        0.5 * rows.iter().map(|row| row * row).sum::<f64>()
    })
}

/// The design with the least sum of squares near another one, and the number of steps.
pub(crate) fn polish<M: Mechanism<Scalar = f64>>(
    objective: &Objective<M>,
    start: &Design<M>,
    steps: u64,
) -> (Design<M>, u64) {
    let before = cost(objective, start);
    if steps == 0 || !before.is_finite() {
        return (start.clone(), 0);
    }
    let problem = Scaled::new(objective, start, objective.sought_with_inputs(&start.values));
    // Normal equations come first, which are fast. The singular values of the second method then lose no digits to
    // their squares.
    let first = BoundedLevenbergMarquardt::new()
        .with_absolute_scaled_gradient_tolerance(None)
        .with_relative_cost_change_tolerance(NEARLY_SETTLED);
    let second = TrustRegionReflective::new()
        .with_absolute_scaled_gradient_tolerance(None)
        .with_relative_cost_change_tolerance(SETTLED)
        .with_relative_step_tolerance(SETTLED);
    let mut best = (problem.point(), before);
    let mut taken = 0;
    let mut keep = |point: &Vec<f64>, best: &mut (Vec<f64>, f64), own: u64| {
        taken += own;
        let found = cost(objective, &problem.at(point));
        if found < best.1 {
            *best = (point.clone(), found);
        }
    };
    let run = Executor::new(problem.clone(), first, PointState::new(best.0.clone()));
    if let Ok(found) = run.max_iter(steps).run() {
        keep(found.best_param(), &mut best, found.iter());
    }
    let run = Executor::new(problem.clone(), second, PointState::new(best.0.clone()));
    if let Ok(found) = run.max_iter(steps.min(LAST_STEPS)).run() {
        keep(found.best_param(), &mut best, found.iter());
    }
    let design = if best.1 < before {
        problem.at(&best.0)
    } else {
        start.clone()
    };
    (design, taken)
}
