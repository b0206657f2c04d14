//! Ranges as programs give them.

use core::ops::RangeInclusive;

/// A range with both of its ends: `0.0..=1.5`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a range of an input or of the time",
    label = "write both ends with a decimal point, and `=` before the last: `0.0..=1.5`",
    note = "angles are in radians: a revolution is `0.0..=TAU`, with `use std::f64::consts::TAU;`, and 90 degrees are \
            `90_f64.to_radians()`"
)]
pub trait ClosedRange {
    /// Its ends, in the order in which they were given.
    fn ends(self) -> [f64; 2];
}

impl ClosedRange for RangeInclusive<f64> {
    fn ends(self) -> [f64; 2] {
        let (start, end) = self.into_inner();
        [start, end]
    }
}
