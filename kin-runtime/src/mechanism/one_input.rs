//! Calls that make sense for a mechanism with a single input.

use crate::number::Row;

/// The inputs of a mechanism with a single one: an array of one number.
#[diagnostic::on_unimplemented(
    message = "the mechanism has several inputs, and this call is for mechanisms with a single one",
    label = "for several inputs: `.between([..], [..], rows)` sweeps from one point to another, `.cycle_along([..], \
             [..])` finds the circuits along a direction"
)]
pub trait OneInput: Row<f64> {}

impl OneInput for [f64; 1] {}
