//! Many poses in one call: columns of inputs, and of parameters, to columns of motions.
//!
//! `solve_batch`, which every mechanism has, takes a [`Column`] for each number that `solve` takes, the same value for all poses or one
//! for each, and fills a pose of [targets](Target), vectors or slices, with the motions. It calculates several poses at once, in
//! as wide vectors as the machine has; which these are is found out at run time (feature `std`, on x86), so that no flag of the
//! compiler is needed. What it finds are the poses that `solve` finds, up to rounding, and where it fails, it fails with the same
//! [outcome](Outcome): a pose that is out of reach disturbs no other one. With the feature `rayon` there is `solve_batch_in_parallel`, which does
//! the same on all cores.
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
//! let summary = linkage.solve_batch(theta2, Assembly::Open, &mut poses, &mut outcomes)?;
//! assert_eq!(summary.solved, 180);
//! let theta4 = &poses.theta4;
//! println!("at 65 degrees: {} rad, {} rad/s\u{2074}", theta4[0][155], theta4[4][155]);
//! # Ok::<(), kin_core::batch::LengthMismatch>(())
//! ```

mod column;
#[cfg(test)]
mod comparison_tests;
mod destination;
mod dispatch;
pub(crate) mod lanes;
mod outcome;
#[cfg(feature = "rayon")]
mod parallel;
mod sweep;
mod target;
#[cfg(test)]
mod tests;
mod view;

pub use column::{Column, Parameter};
pub use dispatch::Vectors;
pub use outcome::{LengthMismatch, Outcome, Summary};
#[cfg(feature = "rayon")]
pub use parallel::{solve_in_parallel, solve_near_in_parallel};
pub use sweep::{solve, solve_near};
pub use target::{Columns, MotionColumns, Place, Target, Visitor};
