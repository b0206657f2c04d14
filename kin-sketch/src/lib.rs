//! Drawings of plane linkages become declarations.
//!
//! A [`Sketch`] holds what a person draws: points, links through them, slides, drives. [`Sketch::declaration`] finds
//! the loops of the drawing, writes the declaration that a person would have written, and measures its dimensions.
//! What the drawing leaves open is returned as [`SketchFault`]s, all at once.
//!
//! ```
//! use kin_sketch::{Body, Drive, Sketch};
//!
//! let mut four_bar = Sketch::new("FourBar");
//! let [o, a, b, d] = [("o", 0.0, 0.0), ("a", 0.0, 2.0), ("b", 4.0, 4.0), ("d", 5.0, 0.0)]
//!     .map(|(name, x, y)| four_bar.point(name, x, y));
//! four_bar.fix(o);
//! four_bar.fix(d);
//! let crank = four_bar.link("", &[o, a]);
//! four_bar.link("", &[a, b]);
//! four_bar.link("", &[d, b]);
//! four_bar.drives.push(Drive::Angle { of: crank, to: Body::Ground });
//!
//! let declared = four_bar.declaration().expect("it moves in one way, and has one drive");
//! assert!(declared.text.contains("b == d + r4 * cis(theta4);"));
//! assert_eq!(declared.dimensions[1], ("r2".to_owned(), 2.0));
//! ```

mod declaration;
mod fault;
#[cfg(feature = "foreign")]
pub mod foreign;
mod freedom;
#[cfg(feature = "serde")]
mod json;
mod kin_file;
mod local;
mod names;
mod parts;
mod placement;
mod quantities;
mod sketch;
mod statements;
mod vectors;
mod ways;

pub use declaration::SketchDeclaration;
pub use fault::{SketchFault, SketchFaultKind, SketchParts};
pub use kin_file::DriveMotion;
pub use sketch::{Body, Drive, LinkId, PointId, Sketch, SketchLink, SketchPoint, SketchSlide, SlideId};
