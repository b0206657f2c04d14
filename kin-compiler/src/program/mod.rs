//! The middle language: a program of stages and steps. Its expressions are nodes of a graph until the program is
//! scheduled; then they are ready to be written.
//!
//! Values are identified by symbols. Names are looked up only when a program becomes text.

mod choice;
mod cost;
mod directions;
mod expression;
mod names;
mod order;
mod printout;
mod solver;
mod solvers;
mod stage;
mod step;
mod trials;

pub(crate) use choice::{Choice, DeclaredRange, Mode};
pub(crate) use cost::Cost;
pub(crate) use directions::{DirectionSymbols, Directions, UnitPart};
pub(crate) use expression::Expression;
pub(crate) use names::{Names, OWN_NAMES};
pub(crate) use order::order_name;
pub use solver::Returns;
pub(crate) use solver::{FormArgument, Solver};
pub use solvers::Component;
pub(crate) use solvers::{ClosureTerms, FormLengths, Lengths, Solvers, TransmissionAngles};
pub(crate) use stage::{Carried, Program, Stage};
pub(crate) use step::Step;
pub(crate) use trials::{Approach, Trial, Trials};
