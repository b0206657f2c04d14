//! Drawings of mechanisms as SVG: links as bars and polygons, pivots, ground, sliders, paths of points.
//!
//! A [`Scene`] holds what is drawn: the skeleton of one position, and what a sweep shows. [`draw`] writes it.
//!
//! ```
//! use kin_core::library::FourBar;
//! use kin_core::prelude::*;
//! use kin_studio::drawing::{Scene, Style, draw};
//!
//! let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
//! let scene = Scene::of_mechanism(&linkage, [1.0], Assembly::Open)?;
//! let svg = draw(&scene, &Style::default());
//! assert!(svg.starts_with("<svg"));
//! # Ok::<(), SolveError>(())
//! ```

mod canvas;
mod drive;
mod frame;
mod labels;
mod moving;
mod scene;
mod shapes;
mod sweep;

pub use canvas::{Canvas, Keyframe};
pub use drive::Drive;
pub use moving::moving;
pub use scene::{Note, Scene};
pub use shapes::{Style, canvas, draw};

/// Ink, as dark as a pencil.
pub const INK: &str = "#222222";
/// The grey of guides, hatching and axes.
pub const GREY: &str = "#777777";
/// The path of a point: blue of Okabe's and Ito's palette.
pub const PATH: &str = "#0072B2";
/// The vermilion of driven parts.
pub const DRIVE: &str = "#D55E00";
