//! Published problems, each with what the literature reached and what this project reaches.

pub(crate) mod dwell;
pub(crate) mod half_turn;
pub(crate) mod logarithm;
pub(crate) mod path;
pub(crate) mod report;
pub(crate) mod straight_line;
pub(crate) mod walking;

/// A count as a number. Nothing here is counted beyond 2³².
fn number(count: usize) -> f64 {
    f64::from(u32::try_from(count).unwrap_or(u32::MAX))
}
