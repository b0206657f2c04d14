//! The time derivatives of the closure, order by order, with one Jacobian for each block.
//!
//! Differentiating a closed loop n times gives J q⁽ⁿ⁾ = -Rₙ. The Jacobian J is the same for every order n. Rₙ is the
//! n-th derivative of the closure without the n-th rates of the block.

mod influence;
mod jacobian;
mod radius;
mod rates;
mod scale;
mod sensitivity;

use std::collections::{BTreeMap, BTreeSet};

pub(crate) use influence::Influences;
pub(crate) use jacobian::Regularity;
pub(crate) use sensitivity::{Definition, Dependent};

use influence::FoundCoefficient;
use jacobian::BlockJacobian;
use rates::KnownRates;
use scale::scale_rows;

use crate::algebra::{Expansion, Graph, LinearParts, Node, Symbol, TrigonometricPolynomial, Variables};
use crate::passes::Passes;
use crate::structure::Block;
use crate::work;

/// The rates of the unknowns, order by order, as expressions of positions and lower rates.
pub(crate) struct Derivatives {
    /// `orders[n - 1]` holds the rates of order n, in the order in which they can be computed.
    pub(crate) orders: Vec<Vec<Rate>>,
    /// `outputs[n - 1][k]` is the n-th derivative of the k-th output expression.
    pub(crate) outputs: Vec<Vec<Node>>,
    /// For each block, the condition under which its rates exist.
    pub(crate) regularity: Vec<Regularity>,
    /// Divisors of the rates, besides the determinants, that do not vanish unless a determinant does.
    pub(crate) guaranteed: Vec<Node>,
    rights: Vec<(Node, Hint)>,
    rates: KnownRates,
    jacobians: Vec<BlockJacobian>,
}

/// The error that the derivatives through an order take more expressions than are allowed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct TooLarge {
    pub(crate) order: usize,
}

/// A named part of the derivation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Hint {
    /// The right-hand side -Rₙ of a scalar equation.
    Right { equation: usize, order: usize },
    /// The coefficient of a motion in the rates of an unknown, or its opposite, if the motion is that of a single
    /// quantity.
    Influence {
        unknown: Symbol,
        by: Option<Mover>,
        is_opposite: bool,
    },
    /// Pₙ of an angle.
    P { angle: Symbol, order: usize },
    /// Qₙ of an angle.
    Q { angle: Symbol, order: usize },
}

/// The component of a quantity's motion that an influence coefficient multiplies.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Mover {
    /// An input or an unknown.
    pub(crate) quantity: Symbol,
    /// Whether the component is P of an angle, along the link, and not Q or a rate.
    pub(crate) is_along: bool,
}

/// The way to find time derivatives of unknowns.
pub(crate) enum Rate {
    /// One rate alone.
    Value { symbol: Symbol, value: Node },
    /// Several rates together, by the factors of their Jacobian.
    System {
        factors: Symbol,
        symbols: Vec<Symbol>,
        right: Vec<Node>,
    },
}

impl Rate {
    /// The symbols of the rates.
    pub(crate) fn symbols(&self) -> &[Symbol] {
        match self {
            Self::Value { symbol, .. } => std::slice::from_ref(symbol),
            Self::System { symbols, .. } => symbols,
        }
    }
}

/// The formulas to differentiate.
#[derive(Clone, Copy)]
pub(crate) struct Subject<'a> {
    pub(crate) residuals: &'a [Node],
    pub(crate) blocks: &'a [Block],
    pub(crate) outputs: &'a [Node],
    pub(crate) influences: Influences,
    pub(crate) passes: Passes,
    /// The largest number of expressions.
    pub(crate) most_expressions: usize,
}

/// The largest number of terms of a multiplied-out form for each node of the typed form. A larger form has never been
/// cheaper: the largest ratio in the library is 1.3, and most are below one half.
const TERMS_FOR_EACH_NODE: usize = 2;

/// Equations and outputs in a form that can be differentiated.
#[derive(Clone)]
pub(crate) struct Differentiable {
    pub(crate) residuals: Vec<Node>,
    pub(crate) outputs: Vec<Node>,
    /// The outputs in the form in which the position evaluates them: multiplied out if that makes them linear in the
    /// variables and in the cosines and sines of angles, so that values and rates share their coefficients. Other
    /// products may cancel where they are multiplied out.
    pub(crate) values: Vec<Node>,
    /// Whether multiplying out was given up for size.
    pub(crate) is_given_up: bool,
}

/// Equations and outputs, multiplied out or with their products left. In either form, the equations contain no quotient
/// of varying expressions.
pub(crate) fn formulas(
    graph: &mut Graph,
    residuals: &[Node],
    blocks: &[Block],
    outputs: &[Node],
    expand: bool,
) -> Differentiable {
    let mut is_given_up = false;
    let mut linear_parts = LinearParts::default();
    let mut choose =
        |graph: &mut Graph, typed: Node, multiplied_out: Option<TrigonometricPolynomial>, is_complete: bool| {
            if let Some(polynomial) = multiplied_out {
                if is_complete && polynomial.0.len() <= TERMS_FOR_EACH_NODE * graph.reachable(&[typed]).len() {
                    return polynomial.node(graph);
                }
                is_given_up = true;
            }
            linear_parts.multiply_out(graph, typed)
        };
    let mut residuals: Vec<Node> = residuals
        .iter()
        .map(|&residual| {
            let mut expansion = Expansion::new(graph, Variables::Position);
            let has_quotient = expansion.polynomial(residual).is_none();
            let equation = (expand || has_quotient).then(|| expansion.equation(residual));
            let is_complete = expansion.is_complete();
            choose(graph, residual, equation, is_complete)
        })
        .collect();
    scale_rows(graph, &mut residuals, blocks);
    let (outputs, values) = outputs
        .iter()
        .map(|&output| {
            let mut expansion = Expansion::new(graph, Variables::Position);
            let formula = expansion.polynomial(output);
            let is_complete = expansion.is_complete();
            let is_linear = is_complete && formula.as_ref().is_some_and(TrigonometricPolynomial::is_linear);
            let formula = formula.filter(|_| expand || is_linear);
            let chosen = choose(graph, output, formula, is_complete);
            (chosen, if is_linear { chosen } else { output })
        })
        .unzip();
    Differentiable {
        residuals,
        outputs,
        values,
        is_given_up,
    }
}

impl Derivatives {
    /// The derivatives of all orders through the given one.
    ///
    /// # Errors
    /// Returns the order at which there are too many expressions.
    pub(crate) fn new(graph: &mut Graph, task: Subject<'_>, order: usize) -> Result<Self, TooLarge> {
        let jacobians: Vec<BlockJacobian> = task
            .blocks
            .iter()
            .map(|block| BlockJacobian::new(graph, task.residuals, block, task.passes))
            .collect();
        let mut derivatives = Self {
            orders: Vec::new(),
            outputs: Vec::new(),
            regularity: jacobians.iter().map(|jacobian| jacobian.regularity(graph)).collect(),
            guaranteed: jacobians
                .iter()
                .flat_map(|jacobian| jacobian.guaranteed(graph))
                .collect(),
            rights: Vec::new(),
            rates: KnownRates::new(task.passes),
            jacobians,
        };
        for order in 1..=order {
            derivatives.derive_next(graph, task);
            if graph.len() > task.most_expressions || work::is_spent() {
                return Err(TooLarge { order });
            }
        }
        Ok(derivatives)
    }

    /// The determinants of all blocks, which must not vanish.
    pub(crate) fn determinants(&self) -> impl Iterator<Item = &Node> {
        self.regularity.iter().filter_map(|block| match block {
            Regularity::Determinant(determinant) => Some(determinant),
            Regularity::Factors { .. } => None,
        })
    }

    fn derive_next(&mut self, graph: &mut Graph, task: Subject<'_>) {
        let order = self.orders.len() + 1;
        let mut found = Vec::new();
        for (block, jacobian) in task.blocks.iter().zip(&self.jacobians) {
            if work::is_spent() {
                return;
            }
            self.rates.seek(&block.unknowns, order);
            let wholes: Vec<Node> = block
                .equations
                .iter()
                .map(|&equation| self.rates.total(graph, task.residuals[equation], order))
                .collect();
            self.rates.seek(&[], order);
            let zero = graph.zero();
            let mut without_block = BTreeMap::new();
            for &unknown in &block.unknowns {
                let rate = graph.symbol(Symbol::UnknownRate(unknown, order));
                match self.rates.lower(unknown, order) {
                    Some(lower) => {
                        let turning = graph.symbol(Symbol::Turning(unknown, order));
                        without_block.extend([(turning, zero), (rate, graph.negate(lower))]);
                    }
                    None => drop(without_block.insert(rate, zero)),
                }
            }
            let right: Vec<Node> = wholes
                .into_iter()
                .zip(&block.equations)
                .map(|(whole, &equation)| {
                    let rest = graph.substitute(whole, &mut without_block);
                    let right = graph.negate(rest);
                    self.rights.push((right, Hint::Right { equation, order }));
                    right
                })
                .collect();
            found.extend(jacobian.solve(graph, task.influences, &right, &|unknown| {
                match self.rates.lower(unknown, order) {
                    Some(_) => Symbol::Turning(unknown, order),
                    None => Symbol::UnknownRate(unknown, order),
                }
            }));
            for &unknown in &block.unknowns {
                if let Some(lower) = self.rates.lower(unknown, order) {
                    let turning = graph.symbol(Symbol::Turning(unknown, order));
                    found.push(Rate::Value {
                        symbol: Symbol::UnknownRate(unknown, order),
                        value: graph.subtract(turning, lower),
                    });
                }
            }
        }
        self.orders.push(found);
        self.outputs.push(
            task.outputs
                .iter()
                .map(|&output| self.rates.total(graph, output, order))
                .collect(),
        );
    }

    /// Names for the parts that have a meaning to readers of the program.
    pub(crate) fn hints(&self, graph: &Graph) -> Vec<(Node, Hint)> {
        let mut hints = self.rights.clone();
        let envelopes = self.rates.hints(graph);
        let mut movers = BTreeMap::new();
        for &(node, hint) in &envelopes {
            let mover = match hint {
                Hint::P { angle, .. } => Mover {
                    quantity: angle,
                    is_along: true,
                },
                Hint::Q { angle, .. } => Mover {
                    quantity: angle,
                    is_along: false,
                },
                Hint::Right { .. } | Hint::Influence { .. } => continue,
            };
            movers.insert(node, mover);
        }
        hints.extend(envelopes);
        let mut seen = BTreeSet::new();
        for rate in self.orders.iter().flatten() {
            if let Rate::Value { value, symbol } = *rate
                && let Symbol::UnknownRate(unknown, _) | Symbol::Turning(unknown, _) = symbol
            {
                let unknown = Symbol::Unknown(unknown);
                let mut found = Vec::new();
                influence::influences(graph, (value, 1.0), &movers, &mut seen, &mut found);
                hints.extend(found.into_iter().map(|FoundCoefficient { node, by, is_opposite }| {
                    let hint = Hint::Influence {
                        unknown,
                        by,
                        is_opposite,
                    };
                    (node, hint)
                }));
            }
        }
        hints
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An equation is multiplied out if this is complete, or leaves only a few terms for each node.
    #[test]
    fn equations_are_multiplied_out_if_they_stay_small() {
        let mut graph = Graph::new();
        let sum_of = |graph: &mut Graph, count: usize| {
            let unknowns: Vec<Node> = (0..count)
                .map(|unknown| graph.symbol(Symbol::Unknown(unknown)))
                .collect();
            graph.sum(&unknowns)
        };
        for (count, power, is_small) in [(2, 2, true), (12, 2, false), (40, 3, false)] {
            let sum = sum_of(&mut graph, count);
            let typed = graph.power(sum, power);
            for output in [false, true] {
                let (residuals, outputs) = if output {
                    (vec![], vec![typed])
                } else {
                    (vec![typed], vec![])
                };
                let chosen = formulas(&mut graph, &residuals, &[], &outputs, true);
                let node = chosen.residuals.iter().chain(&chosen.outputs).next();
                assert_eq!(node == Some(&typed), !is_small, "{count} {power}");
                assert_eq!(chosen.is_given_up, !is_small, "{count} {power}");
                let left = formulas(&mut graph, &residuals, &[], &outputs, false);
                assert_eq!((left.residuals, left.outputs), (residuals, outputs));
                assert!(!left.is_given_up);
            }
        }
    }
}
