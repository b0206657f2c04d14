//! Telltales: the smallest set of rates whose finiteness proves that all rates are finite.
//!
//! A sum or a product of floating-point numbers is not finite if one of its operands is not: ∞ · 0 and ∞ - ∞ are NaN
//! (IEEE 754-2019, sections 6.1 and 6.2). So a non-finite value makes every value non-finite that is computed from it
//! by additions and multiplications, or by dividing it. P and Q of the highest rate of an angle are computed from lower
//! rates of the angle, which therefore need no further test.

use std::collections::{BTreeMap, BTreeSet};

use crate::algebra::{Graph, Node, NodeKind, Symbol};
use crate::program::{Stage, Step};

/// The rates of unknowns whose non-finite values would not make another rate non-finite, by unknown and order.
pub(crate) fn telltales(graph: &mut Graph, stages: &[Stage<Node>]) -> BTreeSet<(usize, usize)> {
    let steps = || stages.iter().flat_map(|stage| &stage.steps);
    let mut definitions = BTreeMap::new();
    for step in steps() {
        if let Step::Define { symbol, value } = step {
            definitions.insert(graph.symbol(*symbol), *value);
        }
    }
    let (mut shown, mut telltales) = (BTreeSet::new(), BTreeSet::new());
    for step in steps().rev() {
        let symbols = match step {
            Step::Define { symbol, .. } => std::slice::from_ref(symbol),
            Step::Substitute { results, .. } => results,
            _ => &[],
        };
        for &symbol in symbols {
            if let Symbol::UnknownRate(unknown, order) = symbol {
                let rate = graph.symbol(symbol);
                if !shown.contains(&rate) {
                    telltales.insert((unknown, order));
                    show(graph, &definitions, rate, &mut shown);
                }
            }
        }
    }
    telltales
}

/// Adds a value, and all values that make it non-finite if they are.
fn show(graph: &Graph, definitions: &BTreeMap<Node, Node>, value: Node, shown: &mut BTreeSet<Node>) {
    let mut pending = vec![value];
    while let Some(node) = pending.pop() {
        if !shown.insert(node) {
            continue;
        }
        match graph.kind(node) {
            NodeKind::Symbol(_) => pending.extend(definitions.get(&node)),
            NodeKind::Sum(_, terms) => pending.extend(terms.iter().map(|&(term, _)| term)),
            NodeKind::Product(factors) => pending.extend(
                factors
                    .iter()
                    .filter(|&&(_, exponent)| exponent > 0)
                    .map(|&(factor, _)| factor),
            ),
            NodeKind::Number(_) | NodeKind::Pi | NodeKind::Call(..) => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use proc_macro2::TokenStream;

    use crate::passes::Passes;
    use crate::testing::declarations::{four_bar, slider_crank};
    use crate::testing::sound;

    fn telltales(declaration: TokenStream) -> Vec<(usize, usize)> {
        sound(declaration).solvers(Passes::ALL).telltales.into_iter().collect()
    }

    #[test]
    fn lower_rates_show_in_higher_ones_where_they_turn_something() {
        assert_eq!(telltales(four_bar()), [(0, 4), (1, 4)]);
    }

    #[test]
    fn rates_that_nothing_is_made_of_are_tested_themselves() {
        assert_eq!(telltales(slider_crank()), [(0, 4), (1, 1), (1, 2), (1, 3), (1, 4)]);
    }
}
