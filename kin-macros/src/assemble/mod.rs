//! Position: the blocks' closed forms, and Newton's method for what has none, as steps of a program.
//!
//! Closed forms give the vectors of the links that turn, and the angle itself by one arctangent at the end. From then on
//! every sine and cosine of an unknown is read off those vectors; none is evaluated again.

mod blocks;
mod choice;
mod directions;
mod loops;
mod newton;
mod program;
mod reciprocals;
mod solver;
mod transmission;
mod units;

pub(crate) use blocks::{assemble, assemble_every};
pub(crate) use directions::{Directions, UnitPart};
pub(crate) use program::{Choice, Limits, Mode, Names, Program, Stage, Step};
pub(crate) use reciprocals::Reciprocals;
pub(crate) use solver::{Argument, Cost, Returns, Shape, Solver};
pub(crate) use transmission::{Dyad, dyads};
