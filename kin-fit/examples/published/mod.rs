//! Published problems, each with the results of the literature and those of this project.

pub(crate) mod dwell;
pub(crate) mod logarithm;
pub(crate) mod path;
pub(crate) mod report;
pub(crate) mod straight_line;
pub(crate) mod stroke;
pub(crate) mod walking;

use kin_fit::{Effort, Found, smallest};

/// The smallest cost over all kinds of a linkage, such as its assemblies.
fn smallest_of<K: Copy + Sync, const N: usize>(
    kinds: [K; N],
    bounds: &[[f64; 2]],
    effort: Effort,
    cost: impl Fn(&[f64], K) -> f64 + Sync,
) -> Option<(Found, K)> {
    let found = kinds.map(|kind| (smallest(bounds, effort, |numbers| cost(numbers, kind)), kind));
    found
        .into_iter()
        .min_by(|one, other| one.0.cost.total_cmp(&other.0.cost))
}

/// A count as a number. Nothing here is counted beyond 2³².
fn number(count: usize) -> f64 {
    f64::from(u32::try_from(count).unwrap_or(u32::MAX))
}
