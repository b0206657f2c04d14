//! Least squares with exact derivatives: a bounded Levenberg-Marquardt method, then a reflective trust region.

use std::convert::Infallible;

use basin::{
    BoundedLevenbergMarquardt, BoxBounds, ConstraintDescription, ConstraintSet, Constraints, DenseMatrix, Executor,
    Jacobian, PointState, Residual, Solver, TrustRegionReflective,
};

use super::Cube;

/// The relative change of the sum of squares below which the second method takes over from the first.
const NEARLY_SETTLED: f64 = 1e-9;
/// The relative change of the sum of squares, and of the point, below which a step is the last one: a few roundings.
const SETTLED: f64 = 4.0 * f64::EPSILON;

/// A sum of squares between bounds.
pub(crate) trait Squares {
    /// The bounds of each number.
    fn bounds(&self) -> &[[f64; 2]];

    /// The rows, which are finite.
    fn rows(&self, numbers: &[f64]) -> Vec<f64>;

    /// The derivatives of the rows by the numbers, row by row.
    fn derivatives(&self, numbers: &[f64]) -> Vec<f64>;

    /// Half of the sum of squares.
    fn cost(&self, numbers: &[f64]) -> f64 {
        0.5 * self.rows(numbers).iter().map(|row| row * row).sum::<f64>()
    }
}

/// When a method ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ending {
    /// The largest number of steps.
    pub(crate) steps: u64,
    /// The relative change of the sum of squares of a last step.
    pub(crate) change: f64,
    /// Half of a sum of squares that needs no step.
    pub(crate) cost: f64,
}

/// The sum of squares over the cube.
struct Scaled<'s, S> {
    squares: &'s S,
    cube: Cube<'s>,
}

impl<S: Squares> Constraints for Scaled<'_, S> {
    type Set = ConstraintSet<BoxBounds<Vec<f64>>>;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        self.cube.constraints()
    }
}

impl<S: Squares> Residual for Scaled<'_, S> {
    type Param = Vec<f64>;
    type Output = Vec<f64>;
    type Error = Infallible;

    fn residual(&self, point: &Vec<f64>) -> Result<Vec<f64>, Infallible> {
        Ok(self.squares.rows(&self.cube.numbers(point)))
    }
}

impl<S: Squares> Jacobian for Scaled<'_, S> {
    type Jacobian = DenseMatrix<f64>;

    fn jacobian(&self, point: &Vec<f64>) -> Result<DenseMatrix<f64>, Infallible> {
        let columns = point.len();
        let mut derivatives = self.squares.derivatives(&self.cube.numbers(point));
        for row in derivatives.chunks_exact_mut(columns.max(1)) {
            for (derivative, [low, high]) in row.iter_mut().zip(self.cube.bounds) {
                *derivative *= high - low;
            }
        }
        let rows = derivatives.len() / columns.max(1);
        Ok(DenseMatrix::from_row_slice(rows, columns, &derivatives))
    }
}

/// The better of the start and of the result of a method from there, and the number of its steps.
fn searched<'s, S: Squares, M>(squares: &'s S, method: M, start: &[f64], ending: Ending) -> (Vec<f64>, u64)
where
    M: Solver<Scaled<'s, S>, PointState<Vec<f64>>>,
{
    let cube = Cube::new(squares.bounds());
    let point = cube.shares(start);
    let problem = Scaled { squares, cube };
    let run = Executor::new(problem, method, PointState::new(point))
        .max_iter(ending.steps)
        .target_objective(ending.cost)
        .run();
    let Ok(found) = run else {
        return (start.to_vec(), 0);
    };
    let numbers = Cube::new(squares.bounds()).numbers(found.best_param());
    if squares.cost(&numbers) < squares.cost(start) {
        (numbers, found.iter())
    } else {
        (start.to_vec(), found.iter())
    }
}

/// The method of normal equations, which is fast. It cuts a whole step where one number meets its bound, so that all
/// numbers may stand still there.
pub(crate) fn levenberg_marquardt(squares: &impl Squares, start: &[f64], ending: Ending) -> (Vec<f64>, u64) {
    let method = BoundedLevenbergMarquardt::new()
        .with_absolute_scaled_gradient_tolerance(None)
        .with_relative_cost_change_tolerance(ending.change);
    searched(squares, method, start, ending)
}

/// The method of singular values, which loses no digits to squares and goes on along bounds. Its steps take long for
/// many rows.
pub(crate) fn trust_region(squares: &impl Squares, start: &[f64], ending: Ending) -> (Vec<f64>, u64) {
    // the slopes have no scale, so that only the sum of squares decides when to end
    let method = TrustRegionReflective::new()
        .with_absolute_scaled_gradient_tolerance(None)
        .with_relative_cost_change_tolerance(ending.change)
        .with_relative_step_tolerance(SETTLED);
    searched(squares, method, start, ending)
}

/// The numbers with the least sum of squares near others, and the steps of both methods. The second finds the last
/// digits.
pub(crate) fn polish(squares: &impl Squares, start: &[f64], [first, last]: [u64; 2]) -> (Vec<f64>, u64) {
    let ending = |steps: u64, change: f64| Ending {
        steps,
        change,
        cost: 0.0,
    };
    let (mut found, mut taken) = (start.to_vec(), 0);
    if first > 0 && !start.is_empty() {
        (found, taken) = levenberg_marquardt(squares, start, ending(first, NEARLY_SETTLED));
    }
    if last > 0 && !start.is_empty() {
        let (polished, more) = trust_region(squares, &found, ending(last, SETTLED));
        return (polished, taken + more);
    }
    (found, taken)
}
