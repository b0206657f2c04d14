//! The curve of all positions over a line of inputs.
//!
//! A [`Way`] is the line with the closure on it. `local.rs` follows the curve with any coordinate as its parameter: one
//! bordered system of equations, one correction, one series. Tracks and exact circuits stand on it.
//!
//! Nothing allocates here: rows are taken of memory that the caller lends.

mod functions;
mod lent_rows;
mod limit;
mod local;
mod rounding;
mod sides;
mod way;

pub use functions::CurveFunctions;
pub(crate) use lent_rows::LentRows;
pub use limit::LimitKind;
#[cfg(feature = "alloc")]
pub(crate) use local::rates;
pub(crate) use local::{bordered, corrected, expanded, fastest, local_blur};
pub(crate) use rounding::{blur, is_crossed, is_indistinct};
pub(crate) use sides::Sides;
pub(crate) use way::{Way, WayPoint, largest, largest_difference};
