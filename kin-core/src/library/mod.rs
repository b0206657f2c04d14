//! Declared mechanisms, ready to use, one file each.
//!
//! Every file is also an example of the declaration language: what stands in `mechanism!` is all that was written by
//! hand.

mod approximate_slider_crank;
mod four_bar;
mod freudenstein_four_bar;
mod geometric_four_bar;
mod inverted_slider_crank;
mod slider_crank;
mod slider_crank_series;

pub use approximate_slider_crank::*;
pub use four_bar::*;
pub use freudenstein_four_bar::*;
pub use geometric_four_bar::*;
pub use inverted_slider_crank::*;
pub use slider_crank::*;
pub use slider_crank_series::SliderCrankSeries;
