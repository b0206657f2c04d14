//! The evolution strategy.

use std::convert::Infallible;

use basin::{
    BoundedCmaEs, BoxBounds, ConstraintDescription, ConstraintSet, Constraints, CostFunction, DenseMatrix, Executor,
};

use super::Cube;

/// The evolution strategy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evolution {
    /// The largest number of designs that are evaluated for each candidate.
    pub evaluations: u64,
    /// The standard deviation at the beginning, as a share of the distance between the bounds.
    pub spread: f64,
    /// The designs of a generation; `None` stands for 4 + 3 ln n of n numbers that are sought.
    pub population: Option<usize>,
}

impl Default for Evolution {
    fn default() -> Self {
        Self {
            evaluations: 4000,
            spread: 0.05,
            population: None,
        }
    }
}

/// A cost over the cube.
struct Scaled<'c, C> {
    cost: &'c C,
    cube: Cube<'c>,
}

impl<C> Constraints for Scaled<'_, C> {
    type Set = ConstraintSet<BoxBounds<Vec<f64>>>;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        self.cube.constraints()
    }
}

impl<C: Fn(&[f64]) -> f64> CostFunction for Scaled<'_, C> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Infallible;

    fn cost(&self, point: &Vec<f64>) -> Result<f64, Infallible> {
        Ok((self.cost)(&self.cube.numbers(point)))
    }
}

/// The best numbers between bounds that the covariance matrix adaptation evolution strategy finds (N. Hansen, "The CMA
/// evolution strategy: a tutorial", arXiv 1604.00772), and their cost. It ends where its distribution is narrower than
/// a share of the bounds. `None` if it fails.
pub(crate) fn evolve<C: Fn(&[f64]) -> f64>(
    bounds: &[[f64; 2]],
    start: &[f64],
    cost: &C,
    evolution: Evolution,
    narrow: f64,
    seed: u64,
) -> Option<(Vec<f64>, f64)> {
    let cube = Cube::new(bounds);
    let point = cube.shares(start);
    let mut strategy = BoundedCmaEs::<Vec<f64>, DenseMatrix<f64>>::new(seed, evolution.spread)
        .with_absolute_distribution_size_tolerance(narrow);
    if let Some(population) = evolution.population {
        strategy = strategy.with_lambda(population.max(4));
    }
    let run = Executor::from_start(Scaled { cost, cube }, strategy, point)
        .max_cost_evals(evolution.evaluations)
        .run();
    let found = run.ok()?;
    Some((Cube::new(bounds).numbers(found.best_param()), found.best_cost()))
}
