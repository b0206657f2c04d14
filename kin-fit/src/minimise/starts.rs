//! Searches from many starts.

use super::Cube;
use super::evolution::{Evolution, evolve};
use crate::threads::each;

/// The effort of a search, and the seed of its random numbers. The result depends on nothing else.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Effort {
    /// The number of starts; 0 is one start.
    pub starts: u64,
    /// The generations of each start.
    pub generations: u64,
    /// The seed of the first start; the others follow it.
    pub seed: u64,
}

/// The best numbers of several starts, and their cost.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The numbers.
    pub point: Vec<f64>,
    /// Their cost.
    pub cost: f64,
    /// The start that led to them.
    pub start: u64,
}

/// A point of the unit cube for each index, spread evenly: the additive recurrence with the powers of the generalised
/// golden ratio (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018).
#[must_use]
pub fn spread(index: u64, dimensions: usize) -> Vec<f64> {
    let mut ratio = 2.0_f64;
    for _ in 0..60 {
        ratio = (1.0 + ratio).powf(1.0 / (f64::from(u32::try_from(dimensions).unwrap_or(u32::MAX)) + 1.0));
    }
    // a sequence that starts again after 2³² points
    let point = 1.0 + f64::from(u32::try_from(index % (1 << 32)).unwrap_or(0));
    (1..=dimensions)
        .map(|dimension| (0.5 + point / ratio.powi(i32::try_from(dimension).unwrap_or(i32::MAX))).fract())
        .collect()
}

/// The points among which a start is chosen.
const SPREAD: u64 = 400;
/// The offspring in each generation, in multiples of the usual number: rugged costs need more.
const LITTER: usize = 3;
/// The standard deviations of the runs of a start, each from the result of the one before.
const STEPS: [f64; 3] = [0.2, 0.02, 0.002];
/// The width of the distribution, in shares of the bounds, below which a run ends.
const NARROW: f64 = 1e-13;

/// The smallest cost between bounds, by the covariance matrix adaptation evolution strategy, for costs that are no sums
/// of squares. [`penalised`](crate::penalised) gives the cost of a design that does not close.
///
/// Each start is the best of many points that are spread evenly; further runs from its result, with smaller steps,
/// sharpen it. The starts run in parallel; the best cost wins, and of equal costs the earliest start, so the result
/// depends on the effort alone.
///
/// ```
/// use kin_fit::{Effort, smallest};
///
/// let effort = Effort { starts: 1, generations: 200, seed: 0 };
/// let found = smallest(&[[-1.0, 2.0], [-1.0, 2.0]], effort, |at| (at[0] - 0.5).abs() + at[1] * at[1]);
/// assert!((found.point[0] - 0.5).abs() < 1e-6);
/// ```
pub fn smallest<C: Fn(&[f64]) -> f64 + Sync>(bounds: &[[f64; 2]], effort: Effort, cost: C) -> Found {
    let dimensions = bounds.len();
    let litter = LITTER * basin::BoundedCmaEs::<Vec<f64>, basin::DenseMatrix<f64>>::default_lambda(dimensions);
    let one = |start: usize| {
        let start = start as u64;
        let seed = effort.seed.wrapping_add(start);
        let cube = Cube::new(bounds);
        let of = |index: u64| cube.numbers(&spread(seed.wrapping_mul(SPREAD).wrapping_add(index), dimensions));
        let candidates = (0..SPREAD).map(of).map(|point| (cost(&point), point));
        let first = candidates.min_by(|one, other| one.0.total_cmp(&other.0));
        let (mut best, mut point) = first.unwrap_or_else(|| (f64::INFINITY, cube.numbers(&vec![0.5; dimensions])));
        for step in STEPS {
            let evolution = Evolution {
                evaluations: effort.generations.saturating_mul(litter as u64),
                spread: step,
                population: Some(litter),
            };
            if let Some((found, cost)) = evolve(bounds, &point, &cost, evolution, NARROW, seed)
                && cost < best
            {
                (best, point) = (cost, found);
            }
        }
        Found {
            point,
            cost: best,
            start,
        }
    };
    let starts = usize::try_from(effort.starts).unwrap_or(usize::MAX).max(1);
    let found = each(starts, 0, one);
    let best = found.into_iter().min_by(|one, other| one.cost.total_cmp(&other.cost));
    best.unwrap_or_else(|| one(0))
}
