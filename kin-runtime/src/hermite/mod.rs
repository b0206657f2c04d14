//! Pieces of curves that agree with a function at both ends, in the value and four derivatives: Hermite polynomials of
//! degree 9.
//!
//! The error of a piece goes with the tenth power of its length. Seventy-two pieces reproduce a revolution of an
//! ordinary crank-rocker to rounding.

mod piece;
mod zeros;

pub(crate) use piece::Piece;

/// The number of terms of the series at the ends: the value and four derivatives.
pub(crate) const TERMS: usize = 5;

/// The number of coefficients of a piece.
const COEFFICIENTS: usize = 2 * TERMS;
