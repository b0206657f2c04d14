//! Divisors that have to be checked with the position, as later stages cannot fail.

use std::collections::BTreeSet;

use crate::algebra::{Graph, Node, NodeKind, Symbol};
use crate::program::Stage;

/// The divisors of later stages that nothing before them has found to be regular.
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
            // a product that does not vanish has no factor that does
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
        // a length that a closed form has turned into a direction is not zero
        .filter(|&divisor| {
            !matches!(
                graph.as_symbol(divisor),
                Some(Symbol::Unknown(_) | Symbol::Parameter(_))
            )
        })
        .collect()
}
