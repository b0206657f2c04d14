//! Position: the blocks' closed forms, and Newton's method for what has none, as steps of a program.
//!
//! Closed forms give the vectors of the links that turn, and the angle itself by one arctangent at the end. From then on
//! every sine and cosine of an unknown is read off those vectors; none is evaluated again.

mod blocks;
mod choice;
mod loops;
mod newton;
mod reciprocals;
mod unit_vectors;
mod units;

pub(crate) use blocks::{Assembled, assemble, assemble_every};
pub(crate) use reciprocals::{KnownRoot, Reciprocals};
pub(crate) use unit_vectors::{define, drop_idle, leave_angles};
pub(crate) use units::Units;
