//! The names that programs with mechanisms need: `use kin_core::prelude::*;`.

pub use crate::assembly::{Assembly, Near};
#[cfg(feature = "alloc")]
pub use crate::cycle::FullCycle;
pub use crate::failure::{Failure, SolveError};
pub use crate::geometry::{Plane, Space};
pub use crate::mechanism;
pub use crate::mechanism::{Mechanism, Partials, Pose, PoseOf, Sensitive};
pub use crate::motion::{Direction, Motion, rpm};
pub use crate::number::{Number, Row};
pub use crate::solve::Scalar;
pub use crate::sweep::Sweep;
