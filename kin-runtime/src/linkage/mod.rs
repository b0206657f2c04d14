//! A mechanism with its dimensions, without its type: all answers for slices.
//!
//! What a declared mechanism answers in its own types, an [`AnyLinkage`] answers in slices of numbers. A program that
//! holds many mechanisms, or does not know which one it holds, is written for it once.
//!
//! ```
//! use std::f64::consts::TAU;
//! use kin_core::any::AssemblyChoice;
//! use kin_core::library::{FourBar, SliderCrank};
//! use kin_core::linkage::AnyLinkage;
//!
//! let press: SliderCrank = SliderCrank { r: 0.1, l: 0.3 };
//! let four_bar: FourBar = FourBar { r1: 90.0, r2: 30.0, r3: 70.0, r4: 60.0 };
//! for linkage in [AnyLinkage::of(&press), AnyLinkage::of(&four_bar)] {
//!     let description = linkage.description();
//!     let turn = linkage.sweep(AssemblyChoice::Index(0)).between(&[0.0], &[TAU], 361).speed(10.0);
//!     for unknown in description.unknowns {
//!         println!("{}: {}", description.name, turn.of(&format!("{}_jerk", unknown.name)).peak()?);
//!     }
//!     println!("{} circuits", linkage.cycle_along(&[0.0], &[1.0])?.circuits().len());
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod cycle;
#[cfg(test)]
mod made_tests;
mod position;
mod reaction;
mod sweep;
#[cfg(test)]
mod tests;

pub use cycle::AnyCycle;
pub use position::AnyLinkage;
#[doc(hidden)]
pub use position::LinkageFunctions;
pub use sweep::{AnyAssembled, AnyPose, AnySweep};

#[doc(hidden)]
pub use crate::sweep::TabledMechanism;
