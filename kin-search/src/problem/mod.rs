//! Published problems, each with what the literature reached and what this project reaches.

pub mod dwell;
mod half_turn;
pub mod logarithm;
mod path;
mod report;
mod search;
pub mod straight_line;
mod traced;
pub mod walking;

pub use half_turn::{Sample, Stroke, turn};
pub use path::{CASES, CLOSED, HALF_CIRCLE, LINE, PathCase, PathFound, Published, TIMED, Timing};
pub use report::Problem;
pub use search::{Bounds, Effort, Found, Rows, least_squares, smallest, spread};
pub use traced::TracedFourBar;

/// A count as a number. Nothing here is counted beyond 2³².
fn number(count: usize) -> f64 {
    f64::from(u32::try_from(count).unwrap_or(u32::MAX))
}
