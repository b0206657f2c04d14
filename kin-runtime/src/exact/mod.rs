//! Exact tables: a motion as a few kilobytes of numbers, which can be read at every parameter, with all derivatives, to
//! a tolerance.
//!
//! A row holds the value and the derivatives of each column at a parameter. Between two rows a column is the polynomial
//! that agrees with both in all orders, of degree 9 if the derivatives go up to snap. So a table replaces a solver: for
//! an animation, a controller, a cam. Reading it takes twenty lines of any language.
//!
//! ```
//! use std::f64::consts::TAU;
//! use kin_core::library::FourBar;
//! use kin_core::prelude::*;
//!
//! let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
//! // a revolution of the crank, with an error of at most 10⁻⁷ in every order
//! let table = linkage.sweep(Assembly::Open).over(0.0..=TAU, 13).exact_table(1e-7)?;
//! assert!(table.as_bytes().len() < 10_000);
//!
//! // the rocker at the crank angle 1, while the crank rotates at 10 rad/s
//! let [angle, velocity, acceleration, jerk, snap] = table.column("theta4")?.at_speed(1.0, 10.0)?;
//! let pose = linkage.solve([1.0, 10.0, 0.0, 0.0, 0.0], Assembly::Open)?;
//! assert!((angle - pose.theta4.position()).abs() < 1e-8);
//! assert!((jerk - pose.theta4.jerk()).abs() < 1e-5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # How exact
//! Pieces are halved until they agree with `solve` in every order, within the [`Precision`] that was asked for, at a
//! third, at the middle and at two thirds. Twice the largest difference that was seen is the error that the table
//! states for each column and each order, [`ExactColumn::errors`].
//!
//! The error of a piece falls with the tenth power of its length in the values, and with one power less for each
//! derivative. Rounding in the values at both ends of a piece comes back in its derivatives, divided by powers of its
//! length. So sparse rows keep the highest derivatives best, and a tolerance that rounding does not allow is an error.

#[cfg(feature = "alloc")]
mod circuit;
mod error;
#[cfg(feature = "alloc")]
#[cfg(feature = "alloc")]
mod failure;
#[cfg(feature = "alloc")]
mod owned;
mod piece;
#[cfg(feature = "alloc")]
mod precision;
#[cfg(feature = "tape")]
mod print;
mod read;
#[cfg(feature = "alloc")]
mod refine;
#[cfg(feature = "alloc")]
mod swept;
#[cfg(test)]
mod tests;

pub use error::{LookupError, ReadError};
#[cfg(feature = "alloc")]
pub use failure::ExactTableError;
#[cfg(feature = "alloc")]
pub use owned::ExactTable;
#[cfg(feature = "alloc")]
#[doc(hidden)]
pub use owned::{ExactColumnParts, ExactParts};
#[cfg(feature = "alloc")]
pub use precision::Precision;
pub use read::{ExactColumn, ExactTableRef};
#[cfg(feature = "alloc")]
pub(crate) use swept::exact_table;
