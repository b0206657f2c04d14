//! Declared mechanisms that are ready to use, one per file.
//!
//! Every file is also an example of the declaration language: only the content of `mechanism!` was written by hand.
//!
//! Some are other ways to solve or to approximate a linkage, as courses teach them: [`GeometricFourBar`] and
//! [`FreudensteinFourBar`] beside [`FourBar`]; [`SliderCrankFirstApproximation`], [`SliderCrankHigherApproximation`]
//! and [`SliderCrankSeries`] beside [`SliderCrank`].

mod andrews_squeezer;
mod approximate_slider_crank;
mod bennett;
mod chebyshev_linkage;
mod class_three_triad;
mod five_bar;
mod four_bar;
mod freudenstein_four_bar;
mod geometric_four_bar;
mod hoeken_linkage;
mod inverted_slider_crank;
mod jansen_leg;
mod klann_leg;
mod names;
mod pantograph;
mod peaucellier_linkage;
mod roberts_linkage;
mod rssp;
mod rssr;
mod scotch_yoke;
mod slider_crank;
mod slider_crank_series;
mod spherical_four_bar;
mod stephenson_six_bars;
mod stewart_gough_leg;
#[cfg(feature = "serde")]
mod stored;
mod universal_joint;
mod watt_six_bars;
mod whitworth_quick_return;

pub use andrews_squeezer::*;
pub use approximate_slider_crank::*;
pub use bennett::*;
pub use chebyshev_linkage::*;
pub use class_three_triad::*;
pub use five_bar::*;
pub use four_bar::*;
pub use freudenstein_four_bar::*;
pub use geometric_four_bar::*;
pub use hoeken_linkage::*;
pub use inverted_slider_crank::*;
pub use jansen_leg::*;
pub use klann_leg::*;
pub use pantograph::*;
pub use peaucellier_linkage::*;
pub use roberts_linkage::*;
pub use rssp::*;
pub use rssr::*;
pub use scotch_yoke::*;
pub use slider_crank::*;
pub use slider_crank_series::SliderCrankSeries;
pub use spherical_four_bar::*;
pub use stephenson_six_bars::*;
pub use stewart_gough_leg::*;
pub use universal_joint::*;
pub use watt_six_bars::*;
pub use whitworth_quick_return::*;
