//! Influence coefficients: the contribution of each rate in the right-hand sides to an unknown's rate.
//!
//! The solution of J x = R is x = adj(J) R / det J, and R is a sum of rates of links, each times a component of a
//! link's vector. These vectors depend on the position alone, and so do the sums of their products with the adjugate.
//! So these sums are computed once for all orders, whereas R would have to be multiplied by the adjugate in each order.
//! (For a four-bar linkage they are dot and cross products of its links.)

use std::collections::{BTreeMap, BTreeSet};

use super::Mover;
use super::radius::radius;
use crate::algebra::{Graph, Node, NodeKind, Symbol};
use crate::passes::{Pass, Passes};

/// The way to multiply right-hand sides by an adjugate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Influences {
    /// Each right-hand side is multiplied as it is.
    Separate,
    /// Coefficients that depend on the position alone are collected, for all orders together.
    Collected,
}

impl Influences {
    /// Σ weight · right.
    pub(super) fn combined(self, graph: &mut Graph, weights: &[Node], rights: &[Node], passes: Passes) -> Node {
        if self == Self::Collected {
            return collected(graph, weights, rights, passes);
        }
        let terms: Vec<Node> = weights
            .iter()
            .zip(rights)
            .map(|(&weight, &right)| graph.multiply(right, weight))
            .collect();
        graph.sum(&terms)
    }

    /// Σ weight · right / determinant.
    pub(super) fn quotient(
        self,
        graph: &mut Graph,
        weights: &[Node],
        rights: &[Node],
        determinant: Node,
        passes: Passes,
    ) -> Node {
        // without a divisor, the orders have nothing to share
        if self == Self::Collected && graph.as_number(determinant).is_none() {
            let quotients: Vec<Node> = weights
                .iter()
                .map(|&weight| graph.divide(weight, determinant))
                .collect();
            return collected(graph, &quotients, rights, passes);
        }
        let numerator = Self::Separate.combined(graph, weights, rights, passes);
        graph.divide(numerator, determinant)
    }
}

/// Coefficients that depend on the position, by their cofactors.
#[derive(Default)]
struct Collected {
    coefficients: BTreeMap<Node, Vec<(Node, f64)>>,
}

/// Σ weight · right, with the rates as factors of expressions that depend on the position alone.
fn collected(graph: &mut Graph, weights: &[Node], rights: &[Node], passes: Passes) -> Node {
    let mut collected = Collected::default();
    for (&weight, &right) in weights.iter().zip(rights) {
        let (constant, terms) = match graph.kind(right).clone() {
            NodeKind::Sum(constant, terms) => (constant.get(), terms),
            _ => (0.0, Vec::new()),
        };
        if terms.is_empty() {
            collected.add(graph, weight, right, 1.0);
        }
        for (term, coefficient) in terms {
            collected.add(graph, weight, term, coefficient.get());
        }
        if constant != 0.0 {
            let one = graph.one();
            collected.add(graph, weight, one, constant);
        }
    }
    let terms: Vec<(Node, f64)> = collected
        .coefficients
        .into_iter()
        .map(|(rate, coefficients)| {
            let (number, influence) = influence(graph, &coefficients, passes);
            (graph.multiply(rate, influence), number)
        })
        .collect();
    graph.linear(0.0, &terms)
}

impl Collected {
    /// A term of a right-hand side, with its weight.
    fn add(&mut self, graph: &mut Graph, weight: Node, term: Node, coefficient: f64) {
        let factors = match graph.kind(term) {
            NodeKind::Product(factors) => factors.clone(),
            _ => vec![(term, 1)],
        };
        let (mut position, rates): (Vec<_>, Vec<_>) = factors
            .into_iter()
            .partition(|&(factor, _)| graph.depends_on_position_alone(factor));
        position.push((weight, 1));
        let (influence, rate) = (graph.product(&position), graph.product(&rates));
        // the sign and the number go into the coefficient, so that the rate is the same in every row
        let (number, rate) = graph.split_coefficient(rate);
        let terms = self.coefficients.entry(rate).or_default();
        terms.push((influence, number * coefficient));
    }
}

/// A coefficient and the number in front of it. The coefficient is the same for all orders, whatever the numbers in
/// their right-hand sides.
fn influence(graph: &mut Graph, terms: &[(Node, f64)], passes: Passes) -> (f64, Node) {
    let sum = graph.linear(0.0, terms);
    let sum = radius(graph, sum, passes);
    let NodeKind::Sum(constant, terms) = graph.kind(sum).clone() else {
        return (1.0, sum);
    };
    let number = terms[0].1.get();
    let is_common = terms.iter().all(|(_, other)| other.get().abs() == number.abs());
    if constant.get() != 0.0 || !is_common || !passes.include(Pass::CommonNumbers) {
        return (1.0, sum);
    }
    let terms: Vec<(Node, f64)> = terms
        .into_iter()
        .map(|(node, other)| (node, other.get() / number))
        .collect();
    (number, graph.linear(0.0, &terms))
}

/// A coefficient in a collected expression.
pub(super) struct FoundCoefficient {
    pub(super) node: Node,
    /// The motion that the coefficient multiplies.
    pub(super) by: Option<Mover>,
    /// Whether the product is subtracted.
    pub(super) is_opposite: bool,
}

/// The coefficients in a collected expression, which is multiplied by a number. Expressions in `seen` have been visited
/// before.
pub(super) fn influences(
    graph: &Graph,
    (node, number): (Node, f64),
    movers: &BTreeMap<Node, Mover>,
    seen: &mut BTreeSet<Node>,
    found: &mut Vec<FoundCoefficient>,
) {
    if !seen.insert(node) {
        return;
    }
    let is_opposite = number < 0.0;
    match graph.kind(node) {
        NodeKind::Sum(..) if graph.depends_on_position_alone(node) => found.push(FoundCoefficient {
            node,
            by: None,
            is_opposite,
        }),
        NodeKind::Sum(_, terms) => {
            for (term, coefficient) in terms {
                influences(graph, (*term, number * coefficient.get()), movers, seen, found);
            }
        }
        NodeKind::Product(factors) => {
            let (position, motion): (Vec<_>, Vec<_>) = factors
                .iter()
                .copied()
                .partition(|&(factor, _)| graph.depends_on_position_alone(factor));
            // with other coefficients beside it, this is not the whole factor of the motion
            let by = mover(graph, &motion, movers).filter(|_| position.len() == 1);
            let (by, is_opposite) = (
                by.map(|(mover, _)| mover),
                is_opposite != by.is_some_and(|(_, is_minus)| is_minus),
            );
            for (node, exponent) in position {
                if exponent > 0 && matches!(graph.kind(node), NodeKind::Sum(..)) && seen.insert(node) {
                    found.push(FoundCoefficient { node, by, is_opposite });
                }
            }
            for (factor, exponent) in motion {
                if exponent > 0 {
                    influences(graph, (factor, number), movers, seen, found);
                }
            }
        }
        _ => {}
    }
}

/// The component of a quantity's motion that a product of rates is, and whether the product is its opposite.
fn mover(graph: &Graph, factors: &[(Node, i32)], movers: &BTreeMap<Node, Mover>) -> Option<(Mover, bool)> {
    if let [(factor, 1)] = *factors
        && let Some(&mover) = movers.get(&factor)
    {
        return Some((mover, false));
    }
    let mut quantities = factors.iter().map(|&(factor, _)| match graph.as_symbol(factor)? {
        Symbol::InputRate(index, _) => Some(Symbol::Input(index)),
        Symbol::UnknownRate(index, _) | Symbol::Turning(index, _) => Some(Symbol::Unknown(index)),
        _ => None,
    });
    let quantity = quantities.next()??;
    if !quantities.all(|other| other == Some(quantity)) {
        return None;
    }
    let degree: i32 = factors.iter().map(|(_, exponent)| exponent).sum();
    // P₂ = -ω² and P₃ = -3 ω α
    (1..=2).contains(&degree).then_some((
        Mover {
            quantity,
            is_along: degree == 2,
        },
        degree == 2,
    ))
}
