//! Replacement of expressions by others.

use std::collections::BTreeMap;

use super::{Graph, Node, NodeKind};

impl Graph {
    /// An expression with every node in `replacements` replaced, and the result brought into normal form again.
    ///
    /// `replacements` also remembers all rewritten nodes, so that many expressions share the work.
    pub(crate) fn substitute(&mut self, node: Node, replacements: &mut BTreeMap<Node, Node>) -> Node {
        if let Some(&replacement) = replacements.get(&node) {
            return replacement;
        }
        let replacement = match self.kind(node).clone() {
            NodeKind::Number(_) | NodeKind::Pi | NodeKind::Symbol(_) => node,
            NodeKind::Sum(constant, terms) => {
                let terms: Vec<(Node, f64)> = terms
                    .into_iter()
                    .map(|(part, coefficient)| (self.substitute(part, replacements), coefficient.get()))
                    .collect();
                self.linear(constant.get(), &terms)
            }
            NodeKind::Product(factors) => {
                let factors: Vec<(Node, i32)> = factors
                    .into_iter()
                    .map(|(part, exponent)| (self.substitute(part, replacements), exponent))
                    .collect();
                self.product(&factors)
            }
            NodeKind::Call(function, arguments) => {
                let arguments: Vec<Node> = arguments
                    .into_iter()
                    .map(|argument| self.substitute(argument, replacements))
                    .collect();
                self.call(function, &arguments)
            }
        };
        replacements.insert(node, replacement);
        replacement
    }
}
