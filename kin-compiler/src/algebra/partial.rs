//! Partial derivatives.

use std::collections::BTreeMap;

use super::{Graph, Node, NodeKind, Symbol};

impl Graph {
    /// The partial derivative of an expression by a parameter, an input or an unknown.
    pub(crate) fn partial(&mut self, node: Node, symbol: Symbol) -> Node {
        self.partial_remembered(node, symbol, &mut BTreeMap::new())
    }

    fn partial_remembered(&mut self, node: Node, symbol: Symbol, known: &mut BTreeMap<Node, Node>) -> Node {
        if !self.contains(node, symbol) {
            return self.zero();
        }
        if let Some(&derivative) = known.get(&node) {
            return derivative;
        }
        let derivative = match self.kind(node).clone() {
            NodeKind::Number(_) | NodeKind::Pi => unreachable!("numbers contain no symbol"),
            NodeKind::Symbol(_) => self.one(),
            NodeKind::Sum(_, terms) => {
                let terms: Vec<(Node, f64)> = terms
                    .into_iter()
                    .map(|(part, coefficient)| (self.partial_remembered(part, symbol, known), coefficient.get()))
                    .collect();
                self.linear(0.0, &terms)
            }
            NodeKind::Product(factors) => {
                let mut terms = Vec::new();
                for (index, &(part, exponent)) in factors.iter().enumerate() {
                    let inner = self.partial_remembered(part, symbol, known);
                    if self.is_zero(inner) {
                        continue;
                    }
                    let mut others = factors.clone();
                    others[index].1 -= 1;
                    others.push((inner, 1));
                    terms.push((self.product(&others), f64::from(exponent)));
                }
                self.linear(0.0, &terms)
            }
            NodeKind::Call(function, arguments) => {
                let partials = function.partials(self, &arguments, node);
                let mut terms = Vec::new();
                for (argument, partial) in arguments.into_iter().zip(partials) {
                    if !self.contains(argument, symbol) {
                        continue;
                    }
                    let inner = self.partial_remembered(argument, symbol, known);
                    terms.push(self.multiply(partial, inner));
                }
                self.sum(&terms)
            }
        };
        known.insert(node, derivative);
        derivative
    }
}
