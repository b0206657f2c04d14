//! The lecture notes' hand-derived formulas, transcribed line by line.
//!
//! This is an oracle: every function here is what the notes print and nothing
//! else, in plain `f64`, sharing no code with the crates it is used to check.
//! Nothing is simplified, factored out or made robust. Where a printed formula
//! divides by zero (each file says where), so does its transcription, and
//! outside the reach of a linkage `asin`, `acos` or a square root gives NaN.
//!
//! Conventions, the same in every file:
//!
//! - `theta2_1`, `theta2_2`, `theta2_3`, `theta2_4` are the first to fourth time
//!   derivatives of `theta2` (the notes write primes), and likewise for any
//!   other quantity.
//! - `[f64; 5]` is a quantity with its derivatives: position, velocity,
//!   acceleration, jerk, snap.
//! - Angles are in radians, counter-clockwise positive, measured from the ground
//!   line.
//! - Names are the notes' own, in lower case where the notes use a capital
//!   (`R`, `L`, `K1`, `C0`).
//! - `position` chooses a branch; `derivatives` holds on any branch, for it takes
//!   the position as given; `solve` is the one after the other.

pub mod four_bar_geometric;
pub mod freudenstein;
pub mod inverted_slider_crank;
pub mod sample;
pub mod slider_crank;
pub mod slider_crank_approximate;

/// The two ways in which a four-bar linkage can be put together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Assembly {
    /// As drawn in the notes: the angle `gamma` at the joint of coupler and
    /// rocker lies between 0 and 180 degrees.
    Open,
    /// Coupler and rocker mirrored about the diagonal: `gamma` is negative.
    Crossed,
}

/// The notes' s(x).
fn sin(x: f64) -> f64 {
    x.sin()
}

/// The notes' c(x).
fn cos(x: f64) -> f64 {
    x.cos()
}
