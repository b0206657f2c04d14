//! The items that generated code uses. They are not for direct use, and may change at any time.

pub use crate::__assert_verified as assert_verified;
pub use crate::__choices as choices;
pub use crate::__fields as fields;
pub use crate::__in_parallel as in_parallel;
pub use crate::__locals as locals;
pub use crate::__poses as poses;
pub use crate::__readable as readable;
pub use crate::__stored as stored;
pub use crate::__unexpanded as unexpanded;
pub use crate::assemblies::{Assemblies, Choices, continuation, every, positions_near};
pub use crate::assembly::{Assembly, Guess, IntoAssembly, Near};
#[cfg(rust_analyzer)]
pub use crate::editor;
pub use crate::failure::{Failure, InputValues, SolveError};
pub use crate::geometry::{Plane, Rotation, Space};
pub use crate::mechanism::{
    Block, BlockForm, Description, Formula, Formulas, Mechanism, Partials, Pose, PoseOf, PositionSearch, Sensitive,
    Shown, culprit, failed, fmt_pose, length,
};
pub use crate::motion::{Direction, IntoMotion, Motion};
pub use crate::number::{Number, Operations, Row, series};
pub use crate::picture::{Body, Outline, Skeleton, Slide, TransmissionAngle};
pub use crate::quantity::{Dimension, Quantity};
pub use crate::solve::Scalar;
pub use crate::track::{TrackErrorOf, track_to};
pub use crate::{batch, solve};
pub use core;
pub use kin_macros::mechanism_in;
#[cfg(feature = "serde")]
pub use serde;

/// The traits whose methods generated code calls.
pub mod methods {
    pub use crate::batch::{MotionColumns as _, Parameter as _};
    pub use crate::mechanism::PoseOf as _;
    pub use crate::motion::IntoMotion as _;
    pub use crate::number::Number as _;
}

/// The function as which local names of generated code are imported, so that in patterns they cannot refer to constants
/// of the user.
pub const fn local() {}

/// A mechanism whose declaration contains mistakes.
pub trait Numeric {
    /// Its number type, by default an error of the compiler.
    type Number;
}
