//! The names that programs with mechanisms need: `use kin_core::prelude::*;`.

#[doc(hidden)]
pub use crate::__private::guessed::{
    IntegersInASweep as _, IntegersInFour as _, IntegersInOne as _, IntegersInThree as _, IntegersInTwo as _,
    LaterOrders as _, MadeOfNamedParameters as _,
};
#[doc(no_inline)]
pub use crate::{
    Assembly, Direction, Failure, Mechanism, Motion, Near, Number, Partials, Plane, Pose, PoseOf, Row, Scalar,
    Sensitive, SolveError, Space, load::Loaded, mechanism, rpm,
};
#[cfg(feature = "alloc")]
#[doc(no_inline)]
pub use crate::{cycle::FullCycle, sweep::Swept};
