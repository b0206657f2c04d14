//! Methods that are translated from the syntax tree, and not from the graph.
//!
//! The closure is an oracle: a verification compares what the solvers find with it. So it shares no code with the algebra that derives the
//! solvers. What is left of the equations at a solution is an independent check. The skeleton is drawn from the same vectors as they
//! were typed.

pub(crate) mod closure;
mod formula;
mod names;
pub(crate) mod skeleton;

use proc_macro2::{Ident, Span};

use crate::model::Shape;

/// The type of a vector of a shape; nothing for a scalar or a rotation.
pub(crate) fn vector_type(shape: Shape) -> Option<Ident> {
    let name = match shape {
        Shape::Plane => "Plane",
        Shape::Space => "Space",
        Shape::Scalar | Shape::Rotation => return None,
    };
    Some(Ident::new(name, Span::mixed_site()))
}
