//! Questions about extremes to a sweep that does not say yet how its inputs move: see [`sweep::guessed`](crate::sweep::guessed).

use super::{Crossing, Extreme, ExtremesError, Peak};
use crate::sweep::guessed::questions;

questions! {
    peak(N) -> Result<Peak, ExtremesError>;
    highest(N) -> Result<Peak, ExtremesError>;
    lowest(N) -> Result<Peak, ExtremesError>;
    extremes(N) -> Result<alloc::vec::Vec<Extreme>, ExtremesError>;
    crossings(N L) -> Result<alloc::vec::Vec<Crossing>, ExtremesError>;
}
