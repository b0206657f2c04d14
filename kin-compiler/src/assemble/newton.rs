//! Parts without a closed form: their residuals as steps for Newton's method, or for all solutions.

use std::collections::BTreeMap;

use super::blocks::Builder;
use crate::algebra::{Node, NodeKind, Symbol};
use crate::program::{Mode, Step};
use crate::structure::{PolynomialSystem, PolynomialVariable};

impl Builder<'_> {
    /// The step that finds a part's unknowns from the caller's guess.
    pub(super) fn newton(&mut self, part: usize, unknowns: &[usize], residuals: &[Node]) {
        let residuals: Vec<Node> = residuals.iter().map(|&residual| self.known(residual)).collect();
        let jacobian: Vec<Vec<Node>> = residuals
            .iter()
            .map(|&residual| {
                unknowns
                    .iter()
                    .map(|&unknown| self.graph.partial(residual, Symbol::Unknown(unknown)))
                    .collect()
            })
            .collect();
        // values that stay the same in all iterations are computed once, before the first
        let mut moved = BTreeMap::new();
        let residuals: Vec<Node> = residuals
            .into_iter()
            .map(|node| self.hoist(node, unknowns, &mut moved))
            .collect();
        let jacobian: Vec<Vec<Node>> = jacobian
            .into_iter()
            .map(|row| {
                row.into_iter()
                    .map(|node| self.hoist(node, unknowns, &mut moved))
                    .collect()
            })
            .collect();
        let all: Vec<Node> = residuals.iter().chain(jacobian.iter().flatten()).copied().collect();
        let given = self
            .graph
            .reachable(&all)
            .into_iter()
            .filter(|&node| match self.graph.as_symbol(node) {
                Some(Symbol::Unknown(unknown)) => !unknowns.contains(&unknown),
                Some(_) => true,
                None => false,
            })
            .collect();
        self.steps.push(Step::Newton {
            part,
            unknowns: unknowns.to_vec(),
            given,
            body: Vec::new(),
            residuals,
            jacobian,
        });
    }

    /// The steps that go through all solutions of a block; `part` is its first.
    pub(super) fn every(&mut self, block: usize, part: usize, all: &PolynomialSystem) {
        self.steps.push(Step::Open { part, mode: Mode::Only });
        let coefficients = all
            .coefficients
            .iter()
            .map(|&coefficient| self.known(coefficient))
            .collect();
        let mut results = Vec::new();
        let mut angles = Vec::new();
        for &variable in &all.variables {
            match variable {
                PolynomialVariable::Turning(unknown) => {
                    let ([x, y], unit) = self.fresh_plane(&self.unknown_name(unknown));
                    results.extend([x, y]);
                    angles.push((unknown, unit));
                }
                PolynomialVariable::Plain(unknown) => results.push(Symbol::Unknown(unknown)),
            }
        }
        self.steps.push(Step::Every {
            block,
            coefficients,
            results,
        });
        for (unknown, unit) in angles {
            self.turn(unknown, unit);
        }
        for relation in &all.relations {
            self.form(relation, None);
        }
        self.steps.push(Step::Close { part });
    }

    /// An expression in which every part that is free of the unknowns is replaced by a name.
    fn hoist(&mut self, node: Node, unknowns: &[usize], moved: &mut BTreeMap<Node, Node>) -> Node {
        if let Some(&known) = moved.get(&node) {
            return known;
        }
        let result = if self.graph.has_any_of(node, unknowns) {
            match self.graph.kind(node).clone() {
                NodeKind::Number(_) | NodeKind::Pi | NodeKind::Symbol(_) => node,
                NodeKind::Sum(constant, terms) => {
                    let (given, moving): (Vec<_>, Vec<_>) = terms
                        .into_iter()
                        .map(|(part, coefficient)| (part, coefficient.get()))
                        .partition(|&(part, _)| !self.graph.has_any_of(part, unknowns));
                    let mut whole: Vec<(Node, f64)> = moving
                        .into_iter()
                        .map(|(part, coefficient)| (self.hoist(part, unknowns, moved), coefficient))
                        .collect();
                    if given.is_empty() {
                        self.graph.linear(constant.get(), &whole)
                    } else {
                        let given = self.graph.linear(constant.get(), &given);
                        whole.push((self.hoist(given, unknowns, moved), 1.0));
                        self.graph.linear(0.0, &whole)
                    }
                }
                NodeKind::Product(factors) => {
                    let (given, moving): (Vec<_>, Vec<_>) = factors
                        .into_iter()
                        .partition(|&(part, _)| !self.graph.has_any_of(part, unknowns));
                    let mut whole: Vec<(Node, i32)> = moving
                        .into_iter()
                        .map(|(part, exponent)| (self.hoist(part, unknowns, moved), exponent))
                        .collect();
                    let given = self.graph.product(&given);
                    whole.push((self.hoist(given, unknowns, moved), 1));
                    self.graph.product(&whole)
                }
                NodeKind::Call(function, arguments) => {
                    let arguments: Vec<Node> = arguments
                        .into_iter()
                        .map(|argument| self.hoist(argument, unknowns, moved))
                        .collect();
                    self.graph.call(function, &arguments)
                }
            }
        } else {
            self.define("given", node)
        };
        moved.insert(node, result);
        result
    }
}
