//! Time derivatives of the closure, order by order, with one Jacobian for each block.
//!
//! Differentiating a closed loop n times gives J q⁽ⁿ⁾ = -Rₙ: the Jacobian J is the same for every order n, and Rₙ is
//! the n-th derivative of the closure with the block's own n-th rates left out.

mod jacobian;
mod rates;

use std::collections::BTreeMap;

pub(crate) use rates::{Rates, Way};

use jacobian::Jacobian;

use crate::expr::{Expansion, Graph, Node, Symbol};
use crate::structure::Block;

/// The rates of the unknowns, order by order, as expressions of positions and lower rates.
pub(crate) struct Derivatives {
    /// `orders[n - 1]` holds the rates of order n, in the order in which they can be computed.
    pub(crate) orders: Vec<Vec<Rate>>,
    /// `outputs[n - 1][k]` is the n-th derivative of the k-th output expression.
    pub(crate) outputs: Vec<Vec<Node>>,
    /// What of each block's Jacobian must not vanish: the factors of its determinant.
    pub(crate) regular: Vec<Vec<Node>>,
    /// What of each block's Jacobian is to be factored at run time, with the symbol of the factors.
    pub(crate) systems: Vec<Option<(Symbol, Vec<Vec<Node>>)>>,
    /// What the rates are divided by, besides the determinants, that does not vanish where these do not.
    pub(crate) guaranteed: Vec<Node>,
    /// Names for parts that a reader of the program will want to know.
    pub(crate) hints: Vec<(Node, Hint)>,
}

/// A part of the derivation that has a name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Hint {
    /// The right-hand side -Rₙ of a scalar equation.
    Right { equation: usize, order: usize },
    /// Pₙ of an angle.
    P { angle: Symbol, order: usize },
    /// Qₙ of an angle.
    Q { angle: Symbol, order: usize },
}

/// How time derivatives of unknowns are found.
pub(crate) enum Rate {
    /// One by itself.
    Value { unknown: usize, value: Node },
    /// Several together, by the factors of their Jacobian.
    System {
        factors: Symbol,
        unknowns: Vec<usize>,
        right: Vec<Node>,
    },
}

/// What is differentiated, and how.
pub(crate) struct Plan<'a> {
    pub(crate) residuals: &'a [Node],
    pub(crate) blocks: &'a [Block],
    pub(crate) outputs: &'a [Node],
    pub(crate) order: usize,
    /// How sines and cosines are differentiated, by order, the last one for all higher orders.
    pub(crate) ways: &'a [Way],
}

/// Equations and outputs in the form in which they are differentiated: as typed or multiplied out, and in any case
/// without a quotient of what varies in the equations.
pub(crate) fn forms(graph: &mut Graph, residuals: &[Node], outputs: &[Node], expand: bool) -> (Vec<Node>, Vec<Node>) {
    let varies = |symbol| matches!(symbol, Symbol::Input(_) | Symbol::Unknown(_));
    let residuals = residuals
        .iter()
        .map(|&residual| {
            let mut expansion = Expansion::new(graph, &varies);
            if expand || expansion.polynomial(residual).is_none() {
                expansion.equation(residual).node(graph)
            } else {
                residual
            }
        })
        .collect();
    let outputs = outputs
        .iter()
        .map(|&output| {
            let polynomial = if expand {
                Expansion::new(graph, &varies).polynomial(output)
            } else {
                None
            };
            polynomial.map_or(output, |polynomial| polynomial.node(graph))
        })
        .collect();
    (residuals, outputs)
}

/// Derives everything that a plan asks for.
pub(crate) fn derive(graph: &mut Graph, plan: &Plan<'_>) -> Derivatives {
    let jacobians: Vec<Jacobian> = plan
        .blocks
        .iter()
        .map(|block| Jacobian::new(graph, plan.residuals, block))
        .collect();
    let mut rates = Rates::new(plan.ways);
    let mut derivatives = Derivatives {
        orders: Vec::new(),
        outputs: Vec::new(),
        regular: jacobians.iter().map(|jacobian| jacobian.regular(graph)).collect(),
        systems: jacobians.iter().map(Jacobian::system).collect(),
        guaranteed: jacobians
            .iter()
            .flat_map(|jacobian| jacobian.guaranteed(graph))
            .collect(),
        hints: Vec::new(),
    };
    for order in 1..=plan.order {
        let mut found = Vec::new();
        for (block, jacobian) in plan.blocks.iter().zip(&jacobians) {
            let zero = graph.zero();
            let mut without_own: BTreeMap<Node, Node> = block
                .unknowns
                .iter()
                .map(|&unknown| (graph.symbol(Symbol::UnknownRate(unknown, order)), zero))
                .collect();
            let right: Vec<Node> = block
                .equations
                .iter()
                .map(|&equation| {
                    let whole = rates.total(graph, plan.residuals[equation], order);
                    let rest = graph.substitute(whole, &mut without_own);
                    let right = graph.negate(rest);
                    derivatives.hints.push((right, Hint::Right { equation, order }));
                    right
                })
                .collect();
            found.extend(jacobian.solve(graph, &right, order));
        }
        derivatives.orders.push(found);
        derivatives.outputs.push(
            plan.outputs
                .iter()
                .map(|&output| rates.total(graph, output, order))
                .collect(),
        );
    }
    derivatives.hints.extend(rates.hints(graph));
    derivatives
}
