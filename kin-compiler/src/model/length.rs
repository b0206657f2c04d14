//! The length of the longest path through a formula, and its limit.

use crate::algebra::{Graph, Index as _, Node, NodeKind};
use crate::mistakes::{Extent, Mistakes};

/// The largest number of operations of which each waits for the one before. The later passes recurse that deep, on a
/// stack that is large enough.
const LONGEST: usize = 10_000;

/// The largest number of formulas within each other. WebAssembly has no threads, so the later passes recurse there on
/// the engine's stack of 1 MB, which holds 300 to the twelfth order.
const DEEPEST: usize = if cfg!(target_family = "wasm") { 128 } else { LONGEST };

/// The longest path to a node of a graph.
#[derive(Clone, Copy, Default)]
struct Path {
    operations: usize,
    depth: usize,
}

/// The longest path to each node of a graph.
#[derive(Default)]
pub(super) struct PathLengths(Vec<Path>);

impl PathLengths {
    /// Whether no path to these nodes is too long. A longer one is reported at `extent`.
    pub(super) fn allow(&mut self, graph: &Graph, nodes: &[Node], extent: Extent, mistakes: &mut Mistakes) -> bool {
        for node in graph.nodes_from(self.0.len()) {
            // the terms of a sum are added one after the other, and the factors of a product multiplied
            let operations = match graph.kind(node) {
                NodeKind::Number(_) | NodeKind::Pi | NodeKind::Symbol(_) => 0,
                NodeKind::Sum(_, terms) => terms.len(),
                NodeKind::Product(factors) => factors
                    .iter()
                    .map(|(_, exponent)| exponent.unsigned_abs() as usize)
                    .sum(),
                NodeKind::Call(..) => 1,
            };
            let mut path = Path::default();
            for operand in graph.operands(node) {
                let operand = self.0[operand.index()];
                path.operations = path.operations.max(operand.operations);
                path.depth = path.depth.max(operand.depth);
            }
            path.operations = path.operations.saturating_add(operations);
            path.depth += usize::from(operations > 0);
            self.0.push(path);
        }
        let longest = |measure: fn(&Path) -> usize| nodes.iter().map(|node| measure(&self.0[node.index()])).max();
        let fault = if longest(|path| path.operations) > Some(LONGEST) {
            format!("takes a chain of more than {LONGEST} operations")
        } else if longest(|path| path.depth) > Some(DEEPEST) {
            format!("is nested more than {DEEPEST} deep, with the abbreviations in it")
        } else {
            return true;
        };
        mistakes.error(
            extent,
            format!("this {fault}: declare a part of it as an unknown with an equation of its own"),
        );
        false
    }
}
