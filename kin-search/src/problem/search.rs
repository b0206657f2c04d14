//! The search of a problem: a bounded evolution strategy from many seeded starts, and bounded least squares.

use std::convert::Infallible;

use basin::{
    BoundedCmaEs, BoundedLevenbergMarquardt, BoxBounds, ConstraintDescription, ConstraintSet, Constraints,
    CostFunction, DenseMatrix, Executor, Jacobian, PointState, PopulationProgress, Residual,
};

use super::number;
use crate::threads::each;

/// How much is searched, and with which random numbers. The result depends on nothing else.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// The number of starts; 0 is one start.
    pub starts: u64,
    /// The generations, or the steps of least squares, of each start.
    pub generations: u64,
    /// The seed of the first start; the others follow it.
    pub seed: u64,
}

/// A range for every number that is searched.
#[derive(Clone, Debug, PartialEq)]
pub struct Bounds {
    lower: Vec<f64>,
    upper: Vec<f64>,
}

impl Bounds {
    /// From the lowest and the highest value of each number.
    #[must_use]
    pub fn new(ranges: &[[f64; 2]]) -> Self {
        Self {
            lower: ranges.iter().map(|range| range[0]).collect(),
            upper: ranges.iter().map(|range| range[1]).collect(),
        }
    }

    /// Whether all numbers lie in their ranges.
    #[must_use]
    pub fn contain(&self, numbers: &[f64]) -> bool {
        let ranges = self.lower.iter().zip(&self.upper);
        numbers
            .iter()
            .zip(ranges)
            .all(|(number, (low, high))| low <= number && number <= high)
    }

    /// The place between the bounds of a point of the unit cube.
    fn place(&self, unit: &[f64]) -> Vec<f64> {
        let ranges = self.lower.iter().zip(&self.upper);
        unit.iter()
            .zip(ranges)
            .map(|(unit, (low, high))| low + unit * (high - low))
            .collect()
    }

    fn len(&self) -> usize {
        self.lower.len()
    }
}

/// A point of the unit cube for each index, spread evenly: the additive recurrence with the powers of the generalised
/// golden ratio (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018).
#[must_use]
pub fn spread(index: u64, dimensions: usize) -> Vec<f64> {
    let mut ratio = 2.0_f64;
    for _ in 0..60 {
        ratio = (1.0 + ratio).powf(1.0 / (number(dimensions) + 1.0));
    }
    // a sequence that starts again after 2³² points
    let place = 1.0 + f64::from(u32::try_from(index % (1 << 32)).unwrap_or(0));
    (1..=dimensions)
        .map(|dimension| (0.5 + place / ratio.powi(i32::try_from(dimension).unwrap_or(i32::MAX))).fract())
        .collect()
}

/// The best point of several starts, and its cost.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The point.
    pub point: Vec<f64>,
    /// Its cost.
    pub cost: f64,
    /// The start that led to it.
    pub start: u64,
}

/// A cost over the unit cube.
struct Cube<'a, C> {
    cost: &'a C,
    bounds: &'a Bounds,
    zeros: Vec<f64>,
    ones: Vec<f64>,
}

impl<C: Fn(&[f64]) -> f64> CostFunction for Cube<'_, C> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Infallible;

    fn cost(&self, unit: &Vec<f64>) -> Result<f64, Infallible> {
        Ok((self.cost)(&self.bounds.place(unit)))
    }
}

impl<C> Constraints for Cube<'_, C> {
    type Set = ConstraintSet<BoxBounds<Vec<f64>>>;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        ConstraintSet::new().with_bounds(BoxBounds::new(Some(&self.zeros), Some(&self.ones)))
    }
}

/// The smallest cost between bounds, by the covariance matrix adaptation evolution strategy (N. Hansen, "The CMA
/// evolution strategy: a tutorial", arXiv 1604.00772).
///
/// Each start is the best of many points that are spread evenly; a second run from its result, with a small step,
/// sharpens it. The starts run in parallel; the best cost wins, and of equal costs the earliest start, so the result
/// depends on the effort alone.
pub fn smallest<C: Fn(&[f64]) -> f64 + Sync>(bounds: &Bounds, effort: Effort, cost: C) -> Found {
    let one = |start: u64| {
        let dimensions = bounds.len();
        let seed = effort.seed.wrapping_add(start);
        let candidates = (0..SPREAD).map(|index| spread(seed.wrapping_mul(SPREAD).wrapping_add(index), dimensions));
        let mut point = candidates
            .map(|unit| (cost(&bounds.place(&unit)), unit))
            .min_by(|one, other| one.0.total_cmp(&other.0))
            .map_or_else(|| vec![0.5; dimensions], |(_, unit)| unit);
        let mut best = cost(&bounds.place(&point));
        for step in [0.2, 0.02, 0.002] {
            let cube = Cube {
                cost: &cost,
                bounds,
                zeros: vec![0.0; dimensions],
                ones: vec![1.0; dimensions],
            };
            let strategy = BoundedCmaEs::<_, DenseMatrix>::new(seed, step)
                .with_lambda(LITTER * BoundedCmaEs::<Vec<f64>, DenseMatrix>::default_lambda(dimensions))
                .with_absolute_distribution_size_tolerance(1e-13);
            let run = Executor::new(cube, strategy, PopulationProgress::from_point(point.clone()))
                .max_iter(effort.generations)
                .run();
            if let Ok(result) = run
                && result.best_cost() < best
            {
                (best, point) = (result.best_cost(), result.best_param().clone());
            }
        }
        Found {
            point: bounds.place(&point),
            cost: best,
            start,
        }
    };
    best_of(effort.starts, one)
}

/// The points among which a start is chosen.
const SPREAD: u64 = 400;
/// The offspring in each generation, in multiples of the usual number: rugged costs need more.
const LITTER: usize = 3;

/// Runs all starts, at least one, on all cores and takes the best one.
fn best_of(starts: u64, one: impl Fn(u64) -> Found + Sync) -> Found {
    let starts = usize::try_from(starts).unwrap_or(usize::MAX).max(1);
    let found = each(starts, 0, |start| one(start as u64));
    let best = found.into_iter().min_by(|one, other| one.cost.total_cmp(&other.cost));
    best.unwrap_or_else(|| one(0))
}

/// Residuals and their derivatives by the numbers, row by row; `None` where the linkage does not close.
pub type Rows = Option<(Vec<f64>, Vec<Vec<f64>>)>;

struct Squares<'a, R> {
    rows: &'a R,
    bounds: &'a Bounds,
    count: usize,
}

/// A residual that is larger than those of any linkage that closes, so that the step is refused.
const OPEN: f64 = 1e6;

impl<R: Fn(&[f64]) -> Rows> Residual for Squares<'_, R> {
    type Param = Vec<f64>;
    type Output = Vec<f64>;
    type Error = Infallible;

    fn residual(&self, point: &Vec<f64>) -> Result<Vec<f64>, Infallible> {
        Ok((self.rows)(point).map_or_else(|| vec![OPEN; self.count], |(residuals, _)| residuals))
    }
}

impl<R: Fn(&[f64]) -> Rows> Jacobian for Squares<'_, R> {
    type Jacobian = DenseMatrix;

    fn jacobian(&self, point: &Vec<f64>) -> Result<DenseMatrix, Infallible> {
        let rows = (self.rows)(point).map_or_else(|| vec![vec![0.0; point.len()]; self.count], |(_, rows)| rows);
        let entries: Vec<f64> = rows.into_iter().flatten().collect();
        Ok(DenseMatrix::from_row_slice(self.count, point.len(), &entries))
    }
}

impl<R> Constraints for Squares<'_, R> {
    type Set = ConstraintSet<BoxBounds<Vec<f64>>>;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        ConstraintSet::new().with_bounds(BoxBounds::new(Some(&self.bounds.lower), Some(&self.bounds.upper)))
    }
}

/// The smallest sum of squares between bounds, by the Levenberg-Marquardt method from many starts that are spread
/// evenly.
///
/// `accept` says which results count, for instance those whose crank makes full turns.
pub fn least_squares(
    bounds: &Bounds,
    effort: Effort,
    count: usize,
    start_of: impl Fn(&[f64]) -> Vec<f64> + Sync,
    rows: impl Fn(&[f64]) -> Rows + Sync,
    accept: impl Fn(&[f64]) -> bool + Sync,
) -> Found {
    let one = |start: u64| {
        let nothing = |point| Found {
            point,
            cost: f64::INFINITY,
            start,
        };
        let point = start_of(&spread(effort.seed.wrapping_add(start), bounds.len()));
        if rows(&point).is_none() {
            return nothing(point);
        }
        let squares = Squares {
            rows: &rows,
            bounds,
            count,
        };
        let method = BoundedLevenbergMarquardt::new()
            .with_relative_cost_change_tolerance(1e-15)
            .with_absolute_scaled_gradient_tolerance(1e-14);
        let run = Executor::new(squares, method, PointState::new(point.clone()))
            .max_iter(effort.generations)
            .run();
        let Ok(result) = run else {
            return nothing(point);
        };
        let point = result.best_param().clone();
        let Some((residuals, _)) = rows(&point).filter(|_| accept(&point)) else {
            return nothing(point);
        };
        Found {
            cost: residuals.iter().map(|residual| residual * residual).sum(),
            point,
            start,
        }
    };
    best_of(effort.starts, one)
}
