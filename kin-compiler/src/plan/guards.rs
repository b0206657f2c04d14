//! Divisors that are checked together with the position, because later stages cannot fail.

use std::collections::BTreeSet;

use crate::algebra::{Graph, Node, NodeKind, Symbol};
use crate::program::Stage;

/// The divisors of later stages that no earlier check has found to be nonzero.
pub(super) fn unguarded_divisors(graph: &Graph, stages: &[Stage<Node>], guaranteed: &[Node]) -> Vec<Node> {
    let divisors = |stages: &[Stage<Node>]| -> BTreeSet<Node> {
        let needs: Vec<Node> = stages.iter().flat_map(Stage::needs).collect();
        graph
            .reachable(&needs)
            .into_iter()
            .filter_map(|node| match graph.kind(node) {
                NodeKind::Product(factors) => Some(factors),
                _ => None,
            })
            .flatten()
            .filter(|&&(_, exponent)| exponent < 0)
            .map(|&(base, _)| base)
            .collect()
    };
    let Some((first, later)) = stages.split_first() else {
        return Vec::new();
    };
    let mut known = divisors(std::slice::from_ref(first));
    for &node in guaranteed {
        known.insert(node);
        match graph.kind(node) {
            // if a product is nonzero, so are its factors
            NodeKind::Product(factors) => known.extend(factors.iter().map(|&(base, _)| base)),
            NodeKind::Sum(constant, terms) if constant.get() == 0.0 && terms.len() == 1 => {
                known.insert(terms[0].0);
                if let NodeKind::Product(factors) = graph.kind(terms[0].0) {
                    known.extend(factors.iter().map(|&(base, _)| base));
                }
            }
            _ => {}
        }
    }
    divisors(later)
        .into_iter()
        .filter(|divisor| !known.contains(divisor))
        // a length that a closed form has made a direction is nonzero
        .filter(|&divisor| {
            !matches!(
                graph.as_symbol(divisor),
                Some(Symbol::Unknown(_) | Symbol::Parameter(_))
            )
        })
        .collect()
}
