//! The kinematics of mechanisms in the plane and in space: from loop closures to position, velocity, acceleration, jerk
//! and snap.
//!
//! [`mechanism!`] takes the loop closure of a mechanism as you would write it on a blackboard. At compile time it finds
//! out how to solve the closure, differentiates it, and generates a position solver and straight-line code for each
//! derivative. Where a closed form exists, the position solver uses it.
//!
//! ```
//! use kin_core::prelude::*;
//!
//! mechanism! {
//!     /// A slider-crank, driven at its slider.
//!     pub struct Pump {
//!         /// Crank.
//!         pub crank: Length,
//!         /// Connecting rod.
//!         pub rod: Length,
//!     }
//!     input s: Length;
//!     unknown theta: Angle, phi: Angle;
//!
//!     crank * cis(theta) + rod * cis(phi) == vec2(s, 0);
//! }
//!
//! let pump: Pump = Pump { crank: 3.0, rod: 4.0 };
//! let stroke = Motion::from((5.0, 1.0, 0.0, 0.0, 0.0));
//! let pose = pump.solve(stroke, Assembly::Open)?;
//! assert!((pose.theta.position().tan() - 4.0 / 3.0).abs() < 1e-15);
//! println!("{} {}", pose.theta.velocity(), pose.theta.snap());
//!
//! // beyond the reach of the links: an error, which says by how much
//! let error = pump.position(7.5, Assembly::Open).unwrap_err();
//! assert_eq!(error.margin(), Some(-0.5));
//! # Ok::<(), SolveError>(())
//! ```
//!
//! # Where to look
//!
//! | for | see |
//! |---|---|
//! | the language of declarations | [`mechanism!`] |
//! | a value with its time derivatives | [`Motion`] |
//! | motion laws of cams and servo drives | [`law`] |
//! | an angle as a unit vector, without an arctangent | [`Direction`] |
//! | the tangent and curvature of a point's path | [`Motion`], the methods of points |
//! | the instant centre of a link | [`LinkMotion`] |
//! | a picture of the mechanism | [`Skeleton`] |
//! | how well a dyad transmits force | [`TransmissionAngle`] |
//! | a point or vector in the plane, in space | [`Plane`], [`Space`] |
//! | a rotation in space | [`Rotation`] |
//! | the choice between two solutions (branches) | [`Assembly`] |
//! | moving from one position to another in the same assembly | [`track`](track()), [`TrackError`] |
//! | many poses over an input or over time, tables with named columns | [`sweep`] |
//! | peaks, extremes, zeros, dwells and means of a sweep | `extremes` (feature `alloc`) |
//! | tables that replace a solver, read in any language | [`exact`] |
//! | all circuits and branches with their limits, Grashof's type | `cycle` (feature `alloc`) |
//! | the reason why there is no position | [`SolveError`], [`Failure`] |
//! | code for any mechanism | [`Mechanism`], [`Pose`] |
//! | how the motion depends on the dimensions | [`Mechanism::sensitivities_at`], [`Sensitive`] |
//! | how unknowns and outputs depend on the inputs | [`Mechanism::jacobian`] |
//! | all positions of any mechanism | [`Mechanism::positions_at`] |
//! | the forms of the blocks, with the lengths of links | [`BlockForm`] |
//! | mechanisms ready to use | `library` (feature `library`) |
//! | verification of your own mechanism | `verify` (feature `std`) |
//! | all solutions of a block without a closed form | [`Assemblies`] |
//! | solvers as data, for other languages | `tape` (feature `tape`) |
//! | files and messages: JSON and other formats | `stored` (feature `serde`) |
//! | number types | [`Number`] and [`Scalar`], [`series`] for truncated Taylor series, [`Changing`] for a number with one derivative |
//!
//! # Units
//!
//! Angles are in radians and counter-clockwise. Lengths share any one unit, and times share any one unit.
//!
//! # Features
//!
//! The solvers do not allocate and need no standard library: without the default feature `std`, the feature `libm`
//! supplies the floating-point functions. The feature `alloc`, which `std` implies, adds tables and extremes of sweeps.
//! The feature `library` adds declared mechanisms, and `rayon` solves batches on all cores. The feature `num-dual`
//! makes the dual numbers of that crate a [`Scalar`], and `verify` uses them. The feature `nalgebra` converts to and
//! from the points and vectors of that crate, and `approx` compares vectors and motions within a tolerance by the
//! traits of that crate. The feature `serde` lets programs store parameters, motions, assemblies and poses. The feature
//! `tape`, which needs `std`, records solvers as data.
//!
//! The features stand for one version of each crate: `num-dual` 0.15, `nalgebra` 0.35, `approx` 0.5, `serde` 1. With
//! another version, pass vectors as their coordinates.
#![no_std]
#![cfg_attr(docsrs, feature(doc_cfg))]

// for lints of the tests in the library
#[cfg(test)]
extern crate std;

mod declaration;
#[cfg(feature = "library")]
pub mod library;
pub mod prelude;

#[doc(inline)]
pub use kin_runtime::*;

/// The items that generated code uses. They are not for direct use, and may change at any time.
#[doc(hidden)]
pub mod __private {
    pub use kin_macros::mechanism_in;
    pub use kin_runtime::__private::*;
}
