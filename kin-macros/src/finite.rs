//! Which rates have to be tested, that all be known to be finite.
//!
//! A sum or a product of floating-point numbers of which one is not finite is not finite, whatever the others are: ∞ · 0 and ∞ - ∞ are no
//! numbers. (IEEE 754-2019, sections 6.1 and 6.2.) So what is not finite shows in all that is computed from it by additions and
//! multiplications, or by dividing it. The lower rates of an angle, of which P and Q of its highest one are made, need no test of
//! their own.

use std::collections::{BTreeMap, BTreeSet};

use crate::assemble::{Stage, Step};
use crate::expr::{Graph, Node, Symbol, Term};

/// The rates of unknowns that show in no other one, by unknown and order: if they are finite, all are.
pub(crate) fn telltales(graph: &mut Graph, stages: &[Stage]) -> BTreeSet<(usize, usize)> {
    let steps = || stages.iter().flat_map(|stage| &stage.steps);
    let mut definitions = BTreeMap::new();
    for step in steps() {
        if let Step::Define { symbol, node } = step {
            definitions.insert(graph.symbol(*symbol), *node);
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

/// Adds a value, and all that shows in it.
fn show(graph: &Graph, definitions: &BTreeMap<Node, Node>, value: Node, shown: &mut BTreeSet<Node>) {
    let mut open = vec![value];
    while let Some(node) = open.pop() {
        if !shown.insert(node) {
            continue;
        }
        match graph.term(node) {
            Term::Symbol(_) => open.extend(definitions.get(&node)),
            Term::Sum(_, terms) => open.extend(terms.iter().map(|&(term, _)| term)),
            Term::Product(factors) => open.extend(
                factors
                    .iter()
                    .filter(|&&(_, exponent)| exponent > 0)
                    .map(|&(factor, _)| factor),
            ),
            Term::Number(_) | Term::Pi | Term::Call(..) => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use proc_macro2::TokenStream;

    use crate::declarations::{four_bar, slider_crank};
    use crate::expand::sound;
    use crate::passes::Passes;
    use crate::plan::plan;

    fn telltales(declaration: TokenStream) -> Vec<(usize, usize)> {
        plan(&sound(declaration).task(Passes::ALL))
            .expect("it is small")
            .telltales
            .into_iter()
            .collect()
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
