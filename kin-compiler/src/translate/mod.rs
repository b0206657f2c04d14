//! Methods that are translated from the syntax tree instead of the graph.
//!
//! The closure is an oracle: a verification compares the solvers' results with it. So it shares no code with the
//! algebra that derives the solvers, and the residuals at a solution are an independent check. The skeleton is drawn
//! from the same vectors, as they were typed.

pub(crate) mod closure;
mod formula;
mod names;
pub(crate) mod outputs;
pub(crate) mod skeleton;

use proc_macro2::{Ident, Span};

use crate::model::ValueShape;

/// The vector type of a shape; `None` for a scalar or a rotation.
pub(crate) fn vector_type(shape: ValueShape) -> Option<Ident> {
    let name = match shape {
        ValueShape::Plane => "Plane",
        ValueShape::Space => "Space",
        ValueShape::Scalar | ValueShape::Rotation => return None,
    };
    Some(Ident::new(name, Span::mixed_site()))
}
