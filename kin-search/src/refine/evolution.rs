//! The evolution strategy.

use std::convert::Infallible;

use basin::{
    BoundedCmaEs, BoxBounds, ConstraintDescription, ConstraintSet, Constraints, CostFunction, DenseMatrix, Executor,
};
use kin_core::Mechanism;

use super::Evolution;
use super::scaled::Scaled;
use crate::objective::{Design, Objective};

impl<M: Mechanism<Scalar = f64>> Constraints for Scaled<'_, M> {
    type Set = ConstraintSet<BoxBounds<Vec<f64>>>;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        self.bounds()
    }
}

impl<M: Mechanism<Scalar = f64>> CostFunction for Scaled<'_, M> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Infallible;

    fn cost(&self, point: &Vec<f64>) -> Result<f64, Infallible> {
        Ok(self.objective.penalised_cost(&mut self.at(point)))
    }
}

/// The width of the distribution, in shares of the bounds, below which the strategy ends.
const NARROW: f64 = 1e-9;

/// The best design that is found, with its inputs in order.
pub(crate) fn evolve<M: Mechanism<Scalar = f64>>(
    objective: &Objective<M>,
    start: &Design<M>,
    evolution: Evolution,
    seed: u64,
) -> Design<M> {
    let sought = objective.sought();
    if sought.is_empty() || evolution.evaluations == 0 {
        return start.clone();
    }
    let problem = Scaled::new(objective, start, sought);
    let point = problem.point();
    let mut strategy = BoundedCmaEs::<Vec<f64>, DenseMatrix<f64>>::new(seed, evolution.spread)
        .with_absolute_distribution_size_tolerance(NARROW);
    if let Some(population) = evolution.population {
        strategy = strategy.with_lambda(population.max(4));
    }
    let result = Executor::from_start(problem.clone(), strategy, point)
        .max_cost_evals(evolution.evaluations)
        .run();
    let mut found = match result {
        Ok(result) => problem.at(result.best_param()),
        Err(_) => return start.clone(),
    };
    let _ = objective.penalised_cost(&mut found);
    found
}
