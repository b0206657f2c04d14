//! Numbers that travel: what programs store, by the traits of serde (feature `serde`, serde 1).
//!
//! | type | written as | read |
//! |---|---|---|
//! | [`Plane`](crate::Plane), [`Space`](crate::Space) | `{"x": 1.0, "y": 2.0}` | yes |
//! | [`Motion`](crate::Motion) | `[0.5, -10.0, 2.0]`: the value and its derivatives | yes |
//! | [`Direction`](crate::Direction) | `{"unit": {"x": 0.6, "y": 0.8}, "rates": [-10.0]}` | yes |
//! | [`Rotation`](crate::Rotation) | its three rows | yes |
//! | [`Assembly`](crate::Assembly), the generated structures of assemblies | `"Open"`, `{"theta3_theta4": "Crossed", …}` | yes |
//! | [`Near`](crate::Near) | its values: `[0.4, 1.9]` | yes |
//! | parameters | `{"pivot": {"x": 0.0, "y": 0.0}, "r1": 90.0, …}` | yes |
//! | poses of every order | inputs, unknowns and outputs by name | as [`PoseRecord`] |
//! | [`Description`](crate::Description) | its fields | as [`DescriptionRecord`] (feature `std`) |
//! | [`SolveError`](crate::SolveError) | its numbers, and its message | as [`SolveErrorRecord`] (feature `std`) |
//! | [`TrackError`](crate::TrackError) | its numbers, and its message | no |
//!
//! # Parameters
//!
//! The structure of a declaration may derive `Serialize` and `Deserialize` like any other structure, points included. A
//! program that does not depend on serde itself, or wants to hear of numbers that are not finite, calls
//! [`storable!`](crate::storable) instead. Both write the same JSON. The mechanisms of `library` are storable.
//!
//! # Numbers that are not finite
//!
//! JSON has no NaN and no infinity, and common writers replace them by `null` in silence. The types of this crate
//! refuse to be written instead, and the error names the number:
//! `unknowns.theta4[3] is NaN, and only finite numbers can be stored`. A structure that derives `Serialize` does what
//! serde does. [`check`] checks it, and any other value. Only errors are written with such numbers, as texts, because
//! these numbers may be the reason for the error.
//!
//! # Poses
//!
//! A pose has private numbers, which belong to the dimensions that it was solved for. They are not written, so that a
//! pose itself cannot be read. Its [`PoseRecord`] can, and `solve` makes a pose of it again.

mod assembly;
#[cfg(feature = "std")]
mod description;
mod finite;
mod lenient;
mod names;
mod parameters;
mod pose;
mod rows;
mod solve_error;
mod track_error;
mod values;

pub use finite::{NotFinite, check};
pub use parameters::ParameterRecord;
pub use pose::PoseRecord;
pub use solve_error::FailureRecord;
#[cfg(feature = "std")]
pub use {
    description::{BlockRecord, DescriptionRecord, QuantityRecord},
    solve_error::SolveErrorRecord,
};

#[doc(hidden)]
pub use assembly::{read_choices, write_choices};
#[doc(hidden)]
pub use pose::motion;
