//! Descriptions of declared mechanisms.
//!
//! A description borrows its names, so that a mechanism can be made while the program runs. The names of a declared
//! mechanism are constants: here are the types of its descriptions, without a lifetime. The types with one are in
//! [`any`](crate::any).

use crate::{mechanism, picture, quantity};

/// The description of a declared mechanism: its quantities, equations, blocks and costs.
pub type Description = mechanism::Description<'static>;
/// A named quantity of a declared mechanism.
pub type Quantity = quantity::Quantity<'static>;
/// A block of a declared mechanism: unknowns that are solved together.
pub type Block = mechanism::Block<'static>;
/// A term of a scalar equation of the closure of a declared mechanism.
pub type ClosureTerm = mechanism::ClosureTerm<'static>;
/// The sine or cosine in a term of the closure of a declared mechanism.
pub type ClosureHarmonic = mechanism::ClosureHarmonic<'static>;
/// A formula of a declared mechanism, or several below each other, in three forms.
pub type Formula = mechanism::Formula<'static>;
/// The equations of a declared mechanism and their solution, in the notation of textbooks.
pub type Formulas = mechanism::Formulas<'static>;
/// Which joints of a declared mechanism belong together, whatever the position.
pub type Outline = picture::Outline<'static>;
/// A rigid body of a declared mechanism that moves: its joints keep their distances.
pub type Body = picture::Body<'static>;
/// A declared mechanism in one position: joints, the bodies between them, and what stands still.
pub type Skeleton<P> = picture::Skeleton<'static, P>;
