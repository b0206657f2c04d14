//! The length of the longest path through a formula, and its limit.

use crate::algebra::{Graph, Node, NodeKind};
use crate::mistakes::{Extent, Mistakes};

/// The largest number of operations of which each waits for the one before. The later passes recurse that deep, on a
/// stack that is large enough.
const LONGEST: usize = 10_000;

/// The longest path to each node of a graph, as a number of operations.
#[derive(Default)]
pub(super) struct PathLengths(Vec<usize>);

impl PathLengths {
    /// Whether no path to these nodes is too long. A longer one is reported at `extent`.
    pub(super) fn allow(&mut self, graph: &Graph, nodes: &[Node], extent: Extent, mistakes: &mut Mistakes) -> bool {
        for node in graph.nodes_from(self.0.len()) {
            // the terms of a sum are added one after the other, and the factors of a product multiplied
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
                    "this takes a chain of more than {LONGEST} operations: declare a part of it as an unknown with an equation \
                     of its own"
                ),
            );
        }
        is_allowed
    }
}
