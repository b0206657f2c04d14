//! The straight-line program: which values are computed, in which stage and under which names, and their cost.
//!
//! Expressions become lines (sums and products of any length), and lines share their common parts. The result becomes
//! binary operations in the order in which the steps need them. A value is computed in the first stage that needs it
//! and carried to later ones.

mod carry;
mod lines;
mod name;
mod operation;
mod scheduler;
mod share;
mod style;

pub(crate) use carry::hand_on;
pub(crate) use scheduler::{schedule, schedule_on_trial};
pub(crate) use style::Style;
