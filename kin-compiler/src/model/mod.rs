//! Syntax tree to model: names are resolved, dimensions are checked, and vectors are split into scalars along their
//! axes. Each item keeps its position in the source.

mod angles;
mod build;
mod dimension;
mod equations;
mod length;
mod lower;
mod order;
mod picture;
mod range;
mod repetition;
mod request;
mod scope;
mod usage;
mod value;

use proc_macro2::{Ident, TokenStream};
use syn::{Attribute, Visibility};

use crate::algebra::Graph;
use crate::mistakes::Extent;

pub(crate) use crate::syntax::{Dimension, Request, ValueShape};
pub(crate) use build::build;
pub(crate) use equations::Origin;
use request::Requested;
pub(crate) use value::FormulaValue;

/// A mechanism as declared, without mistakes in its formulas. The next pass decides whether it can be solved.
pub(crate) struct Model {
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) visibility: Visibility,
    pub(crate) name: Ident,
    pub(crate) parameters: Vec<DeclaredParameter>,
    pub(crate) inputs: Vec<Quantity>,
    pub(crate) unknowns: Vec<Unknown>,
    pub(crate) equations: Vec<Equation>,
    pub(crate) outputs: Vec<Output>,
    /// The highest time derivative.
    pub(crate) order: usize,
    /// The items to generate besides the solvers.
    pub(crate) requests: Vec<Requested>,
    /// The constant farthest from 1.
    pub(crate) extreme_constant: Option<Extent>,
    pub(crate) graph: Graph,
}

/// A field of the struct.
pub(crate) struct DeclaredParameter {
    pub(crate) name: Ident,
    pub(crate) visibility: Visibility,
    pub(crate) attributes: Vec<Attribute>,
    pub(crate) dimension: Dimension,
}

/// An input.
pub(crate) struct Quantity {
    pub(crate) name: Ident,
    pub(crate) documentation: Vec<Attribute>,
    pub(crate) dimension: Dimension,
}

/// An unknown.
pub(crate) struct Unknown {
    pub(crate) name: Ident,
    pub(crate) documentation: Vec<Attribute>,
    pub(crate) dimension: Dimension,
    pub(crate) range: Option<Range>,
}

/// The range in which an unknown is found. An end may be infinite.
pub(crate) struct Range {
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// `e > 0`
    pub(crate) text: String,
}

pub(crate) struct Equation {
    /// The left side minus the right side.
    pub(crate) residual: FormulaValue,
    /// The whole equation, for errors that underline all of it.
    pub(crate) tokens: TokenStream,
    pub(crate) text: String,
    /// Whether it is one of the copies that a `for` stands for.
    pub(crate) is_copy: bool,
}

impl Equation {
    /// Which of the copies at its position it is. It ends a message.
    pub(crate) fn which(&self) -> String {
        if self.is_copy {
            format!("; as a copy it is `{}`", self.text)
        } else {
            String::new()
        }
    }
}

/// A quantity that is computed from the others, with derivatives of the same orders.
pub(crate) struct Output {
    pub(crate) name: Ident,
    pub(crate) documentation: Vec<Attribute>,
    pub(crate) dimension: Dimension,
    pub(crate) value: FormulaValue,
    pub(crate) text: String,
}

#[cfg(test)]
#[allow(clippy::needless_pass_by_value, reason = "formulas are quoted where they are passed")]
mod tests;
