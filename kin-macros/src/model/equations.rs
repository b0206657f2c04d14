//! The scalar equations.

use super::{Model, Request};
use crate::algebra::Node;

/// The declared equation to which a scalar equation belongs, and the part that it is.
#[derive(Clone, Copy)]
pub(crate) struct Origin {
    pub(crate) equation: usize,
    pub(crate) part: &'static str,
}

impl Model {
    /// Whether an item besides the solvers is requested.
    pub(crate) fn is_requested(&self, request: Request) -> bool {
        self.requests.iter().any(|requested| requested.request == request)
    }

    /// A name that generated code needs for itself, changed so that no input or unknown has it.
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
