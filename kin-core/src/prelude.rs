//! The names that programs with mechanisms need: `use kin_core::prelude::*;`.

pub use crate::assembly::{Assembly, Near};
pub use crate::batch::LoadedBatch;
#[cfg(feature = "alloc")]
pub use crate::cycle::FullCycle;
pub use crate::failure::{Failure, SolveError};
pub use crate::geometry::{Plane, Space};
pub use crate::load::Loaded;
pub use crate::mechanism;
#[doc(hidden)]
pub use crate::mechanism::guessed::{
    IntegersInASweep as _, IntegersInFour as _, IntegersInOne as _, IntegersInThree as _, IntegersInTwo as _,
    LaterOrders as _, MadeOfNamedParameters as _,
};
pub use crate::mechanism::{Mechanism, Partials, Pose, PoseOf, Sensitive};
pub use crate::motion::{Direction, Motion, rpm};
pub use crate::number::{Number, Row};
pub use crate::solve::Scalar;
#[cfg(feature = "alloc")]
pub use crate::sweep::Sweep;
