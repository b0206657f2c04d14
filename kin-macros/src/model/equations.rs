//! The equations, scalar by scalar.

use super::{Model, Request};
use crate::algebra::Node;

/// The declared equation that a scalar equation is a part of, and which part.
#[derive(Clone, Copy)]
pub(crate) struct Origin {
    pub(crate) equation: usize,
    pub(crate) part: &'static str,
}

impl Model {
    /// Whether something is to be generated besides the solvers.
    pub(crate) fn is_requested(&self, request: Request) -> bool {
        self.requests.iter().any(|requested| requested.request == request)
    }

    /// A name that generated code needs for itself, made unlike any input or unknown.
    pub(crate) fn own_name(&self, name: &str) -> String {
        let mut name = name.to_owned();
        while self.inputs.iter().any(|input| input.name == name)
            || self.unknowns.iter().any(|unknown| unknown.name == name)
        {
            name.push('_');
        }
        name
    }

    /// The scalar parts of the equations, and the origin of each.
    pub(crate) fn scalar_equations(&self) -> (Vec<Node>, Vec<Origin>) {
        let (mut residuals, mut origins) = (Vec::new(), Vec::new());
        for (equation, declared) in self.equations.iter().enumerate() {
            let axes = declared.residual.shape().axes();
            for (part, node) in declared.residual.nodes().into_iter().enumerate() {
                residuals.push(node);
                origins.push(Origin {
                    equation,
                    part: axes.get(part).map_or("equation", |axis| axis.part_of_equation()),
                });
            }
        }
        (residuals, origins)
    }
}
