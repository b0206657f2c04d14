//! The straight-line program: what is computed when, under which name, and what it costs.
//!
//! Expressions become lines (sums and products of any length), lines share what they have in common, and what is left is
//! put into binary operations in the order in which the steps need them. A value is computed in the first stage that
//! needs it and carried to the later ones.

mod carry;
mod lines;
mod name;
mod operation;
mod scheduler;
mod share;
mod style;

pub(crate) use scheduler::schedule;
pub(crate) use style::Style;
