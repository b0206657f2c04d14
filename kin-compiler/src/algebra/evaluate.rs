//! Numeric evaluation, to fold constants and to probe identities.

use std::collections::BTreeMap;

use super::{Graph, Node, NodeKind, Symbol};

impl Graph {
    /// The value of an expression for given values of the symbols; NaN outside a function's domain.
    pub(crate) fn evaluate(&self, node: Node, symbols: &dyn Fn(Symbol) -> f64) -> f64 {
        let mut values = BTreeMap::new();
        for part in self.reachable(&[node]) {
            let value = self.value(part, |operand| values[&operand], symbols);
            values.insert(part, value);
        }
        values[&node]
    }

    /// The value of an expression, given the values of its operands.
    pub(super) fn value(&self, node: Node, operand: impl Fn(Node) -> f64, symbols: impl Fn(Symbol) -> f64) -> f64 {
        match self.kind(node) {
            NodeKind::Number(number) => number.get(),
            NodeKind::Pi => std::f64::consts::PI,
            NodeKind::Symbol(symbol) => symbols(*symbol),
            NodeKind::Sum(constant, terms) => terms.iter().fold(constant.get(), |sum, &(part, coefficient)| {
                sum + coefficient.get() * operand(part)
            }),
            NodeKind::Product(factors) => factors
                .iter()
                .fold(1.0, |product, &(part, exponent)| product * operand(part).powi(exponent)),
            NodeKind::Call(function, arguments) => {
                let arguments: Vec<f64> = arguments.iter().map(|&argument| operand(argument)).collect();
                function.value(&arguments)
            }
        }
    }
}
