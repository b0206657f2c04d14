//! How long a way leads through a formula, and where that ends.

use crate::algebra::{Graph, Node, NodeKind};
use crate::mistakes::{Extent, Mistakes};

/// So many operations may wait for each other. The passes after this one go that deep, each on a stack that has room for it.
const LONGEST: usize = 10_000;

/// The longest way through each node of a graph, as the number of operations on it.
#[derive(Default)]
pub(super) struct Lengths(Vec<usize>);

impl Lengths {
    /// Whether no way through these nodes is too long; a mistake is reported at `extent`.
    pub(super) fn allow(&mut self, graph: &Graph, nodes: &[Node], extent: Extent, mistakes: &mut Mistakes) -> bool {
        for node in graph.nodes_from(self.0.len()) {
            // the terms of a sum are added one after the other, and so are the factors of a product multiplied
            let own = match graph.kind(node) {
                NodeKind::Number(_) | NodeKind::Pi | NodeKind::Symbol(_) => 0,
                NodeKind::Sum(_, terms) => terms.len(),
                NodeKind::Product(factors) => factors
                    .iter()
                    .map(|(_, exponent)| exponent.unsigned_abs() as usize)
                    .sum(),
                NodeKind::Call(..) => 1,
            };
            let operands = graph.operands(node).into_iter().map(|operand| self.0[operand.index()]);
            let longest = own.saturating_add(operands.max().unwrap_or(0));
            self.0.push(longest);
        }
        let is_allowed = nodes.iter().all(|node| self.0[node.index()] <= LONGEST);
        if !is_allowed {
            mistakes.error(
                extent,
                format!(
                    "more than {LONGEST} operations wait for each other here: declare a part of this as an unknown with an equation \
                     of its own"
                ),
            );
        }
        is_allowed
    }
}
