//! A reference of 50 digits and more, written separately from the engine.
//!
//! It knows nothing of a mechanism but its declaration: the closure, which the macro translates from the syntax tree
//! operator by operator, and not from the algebra from which solvers are derived. The closure is evaluated in truncated
//! Taylor series of 77-digit coefficients; Newton's method on all equations at once, from where the engine ended, gives
//! the position, and the Taylor coefficients of the unknowns follow order by order. No assembly, block, closed form or
//! generated derivative takes part.
//!
//! Parameters and inputs are exactly the numbers that the engine was given. A literal of the declaration is the `f64`
//! that it denotes; `PI` is π itself.

mod branch;
mod closure;
mod cut;
mod errors;
mod linear;
mod poses;
mod response;
pub mod series;
mod solution;
mod tape;

pub use closure::Given;
pub use cut::{
    Body, Connection, Cut, Forces, Inertia, Joint, JointKind, Rates, Shape, Solid, SpaceCut, SpaceShape, written,
};
pub use errors::Errors;
pub use poses::{Kind, Pose, poses};
pub use solution::{Solution, Stray, solution};
