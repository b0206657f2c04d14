//! The position as steps of a program: the closed forms of the blocks, and Newton's method for the others.
//!
//! Closed forms give the vectors of the turning links, and one arctangent at the end gives the angle. From then on,
//! every sine and cosine of an unknown is read off these vectors. None is evaluated again.

mod blocks;
mod choice;
mod loops;
mod newton;
mod reciprocals;
mod unit_vectors;
mod units;

pub(crate) use blocks::{PositionSteps, assemble, assemble_every};
pub(crate) use reciprocals::{KnownRoot, Reciprocals};
pub(crate) use unit_vectors::{define, drop_idle, leave_angles};
pub(crate) use units::Units;
