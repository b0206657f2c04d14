//! Declared mechanisms to put the macro to the test.

pub mod cases;
pub mod chains;
pub mod coupled;
pub mod directions;
pub mod dyads;
pub mod four_bar_typings;
pub mod hyperbolic;
pub mod inverted_slider_crank_typings;
pub mod multi_loop;
pub mod outputs;
pub mod ranged;
pub mod scalar_forms;
pub mod sensitive;
pub mod slider_crank_typings;
pub mod space;
