//! Dimensions from an id, by a low-discrepancy sequence.
//!
//! A candidate of a search is no row of a table but a number, its id, from which the dimensions follow. So only ids are
//! stored and sent, every process finds the same candidates, and a search is continued by the ids that follow.
//!
//! The sequence is `R_d` of M. Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences" (2018): coordinate j
//! of the point n in d dimensions is the fractional part of 1/2 + n α^j, where α is the inverse of the root of x^(d+1)
//! = x + 1 that lies above 1. It fills every part of the box evenly, whatever the number of points, and costs one
//! multiplication.

mod functions;
mod sequence;

pub(crate) use functions::functions;
pub use sequence::{MOST_DIMENSIONS, Sequence};
