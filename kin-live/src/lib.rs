//! Mechanisms that are declared while a program runs.
//!
//! A declaration is a text. [`Mechanism::declare`] compiles it without rustc, and a machine runs the result. The
//! machine gives the numbers of the compiled mechanism to the last bit, and all answers of [`kin_core::linkage`].
//!
//! ```
//! use kin_live::Mechanism;
//! use kin_core::any::AssemblyChoice;
//!
//! let slider_crank = Mechanism::declare("
//!     struct SliderCrank { r: Length, l: Length }
//!     input theta: Angle;
//!     unknown phi: Angle, s: Length;
//!     r * cis(theta) + l * cis(phi) == vec2(s, 0);
//! ")?;
//! let press = slider_crank.linkage(&[("r", 0.1), ("l", 0.3)])?;
//! let sweep = press.sweep(AssemblyChoice::Index(0)).between(&[0.0], &[6.0], 361).speed(10.0);
//! println!("{}", sweep.of("s_jerk").peak()?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod batch;
mod budget;
mod code;
mod elementary;
mod every;
mod forms;
mod formulas;
mod functions;
mod mechanism;
mod memory;
mod motion;
mod names;
mod routine;
mod run;
#[doc(hidden)]
pub mod sheet;

pub use budget::Budget;
pub use kin_compiler::{Budget as CompilerBudget, Mistake, Position, Resource, TooLarge};
pub use mechanism::{DeclareError, DimensionError, Mechanism};
