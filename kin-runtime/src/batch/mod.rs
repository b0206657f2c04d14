//! Many poses in one call: columns of parameters and inputs give columns of motions.
//!
//! Every mechanism has a method `batch`. It takes a [`Column`] for each number that `solve` takes: one value for
//! all poses, or one value per pose. The [`Batch`] stores the motions in a pose of [targets](Target), which are vectors
//! or slices. It calculates several poses at once, in the widest vectors of the machine, which it detects at run time
//! (feature `std`, on x86), so no compiler flag is needed. It finds the poses that `solve` finds, up to rounding. Where
//! it fails, it reports the same [outcome](Outcome): a pose out of reach does not affect the others. With the feature
//! `rayon`, `on_all_cores` does the same on all cores.
//!
//! ```
//! use kin_core::library::{FourBar, FourBarBatch};
//! use kin_core::prelude::*;
//! use kin_core::batch::{Column, Outcome};
//!
//! let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
//! let crank: Vec<f64> = (-90..90).map(|degrees| f64::from(degrees).to_radians()).collect();
//!
//! let mut poses = FourBarBatch::filled(|| vec![0.0; crank.len()]);
//! let mut outcomes = vec![Outcome::Unsolved; crank.len()];
//! let theta2 = Motion::from([
//!     Column::Each(&crank),
//!     Column::Same(-10.0),
//!     Column::Same(0.0),
//!     Column::Same(0.0),
//!     Column::Same(0.0),
//! ]);
//! let summary = linkage.batch(theta2, Assembly::Open).solve(&mut poses, &mut outcomes)?;
//! assert_eq!(summary.solved, 180);
//! let theta4 = &poses.theta4;
//! println!("at 65 degrees: {} rad, {} rad/s\u{2074}", theta4[0][155], theta4[4][155]);
//! # Ok::<(), kin_core::batch::LengthMismatch>(())
//! ```

mod column;
#[cfg(test)]
mod comparison_tests;
mod conclusion;
mod destination;
mod dispatch;
mod fold;
pub(crate) mod lanes;
mod line;
mod loads;
mod outcome;
#[cfg(feature = "rayon")]
mod parallel;
#[cfg(feature = "alloc")]
mod slices;
mod stream;
mod sweep;
mod target;
#[cfg(test)]
mod tests;
mod transmission;
#[cfg(feature = "alloc")]
mod untyped;
mod view;

pub use column::Column;
#[doc(hidden)]
pub use column::Parameter;
#[cfg(feature = "alloc")]
pub(crate) use dispatch::Kernel;
pub use dispatch::Vectors;
pub use fold::{Fold, FoldError, Folded, FoldedNumber, InputGrid, Poses};
#[doc(hidden)]
pub use lanes::Element;
pub use outcome::{LengthMismatch, Outcome, Summary};
#[cfg(feature = "rayon")]
#[cfg_attr(docsrs, doc(cfg(feature = "rayon")))]
pub use parallel::ParallelBatch;
#[cfg(feature = "alloc")]
#[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
#[doc(hidden)]
pub use slices::KeptMemory;
#[cfg(feature = "std")]
pub(crate) use slices::check_length;
#[cfg(feature = "alloc")]
#[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
#[doc(hidden)]
pub use slices::{Numbers, SliceSolver, fold_slices, solve_slices};
pub use sweep::Batch;
#[doc(hidden)]
pub use sweep::{Guide, InAssembly, Nearest};
#[doc(hidden)]
pub use target::{Columns, MotionColumns, Target, Visitor};
pub use target::{Slot, angles_from_cosines};
#[cfg(feature = "alloc")]
#[cfg_attr(docsrs, doc(cfg(feature = "alloc")))]
#[doc(hidden)]
pub use untyped::{AnyBatch, AnyFold, ColumnChoice, GivenColumns, WantedColumns};
