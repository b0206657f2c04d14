//! The scalar equations.

use std::collections::BTreeSet;

use super::{Dimension, Model, Request};
use crate::algebra::{Node, Symbol};

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

    /// The unknowns that are lengths, and the plain numbers among all quantities.
    pub(crate) fn lengths_and_numbers(&self) -> (BTreeSet<usize>, BTreeSet<Symbol>) {
        let unknowns = || self.unknowns.iter().map(|unknown| unknown.dimension).enumerate();
        let inputs = self.inputs.iter().map(|input| input.dimension).enumerate();
        let parameters = self.parameters.iter().flat_map(|parameter| {
            let parts = parameter.dimension.shape().axes().len().max(1);
            (0..parts).map(|_| parameter.dimension)
        });
        let quantities = (unknowns().map(|(index, dimension)| (Symbol::Unknown(index), dimension)))
            .chain(inputs.map(|(index, dimension)| (Symbol::Input(index), dimension)))
            .chain(
                parameters
                    .enumerate()
                    .map(|(index, dimension)| (Symbol::Parameter(index), dimension)),
            );
        let numbers = quantities.filter(|&(_, dimension)| dimension == Dimension::Scalar);
        let lengths = unknowns().filter(|&(_, dimension)| dimension == Dimension::Length);
        (
            lengths.map(|(index, _)| index).collect(),
            numbers.map(|(symbol, _)| symbol).collect(),
        )
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
