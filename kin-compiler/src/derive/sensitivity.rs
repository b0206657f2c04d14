//! Partial derivatives of the motion by the parameters, order by order, with the same Jacobians.
//!
//! The closure F(q, u, p) = 0 holds for all values of the parameters p, and q depends on them. Its derivative by one
//! parameter, with S = ∂q/∂p, is J S + ∂F/∂p = 0. Leibniz's rule gives the n-th time derivative:
//!
//! J S⁽ⁿ⁾ = -[(∂F/∂p)⁽ⁿ⁾ + Σ C(n, k) J⁽ⁿ⁻ᵏ⁾ S⁽ᵏ⁾] over k below n.
//!
//! In a chain of blocks the unknowns of earlier blocks join the sum, with all k up to n. The derivatives of J along the
//! motion are the same for all parameters and are computed once. (Direct differentiation of an implicit function: A.
//! Griewank and A. Walther, "Evaluating Derivatives", 2nd edition, SIAM 2008, chapter 15. For a four-bar linkage up to
//! the acceleration: D. M. Erickson, "Computer aided design of minimum sensitivity four-bar linkages", Kansas State
//! University, 1988, chapter III.)

use std::collections::BTreeMap;

use super::jacobian::BlockJacobian;
use super::rates::{KnownRates, binomial};
use super::{Derivatives, Influences, Rate, Subject, TooLarge};
use crate::algebra::{Graph, Node, NodeKind, Symbol};
use crate::work;

/// One step of the program of sensitivities.
pub(crate) enum Definition {
    /// A sensitivity.
    Value { symbol: Symbol, node: Node },
    /// Several sensitivities to one parameter, of one order, by the factors of a Jacobian with which the rates were
    /// found.
    System {
        factors: Symbol,
        right: Vec<Node>,
        results: Vec<Symbol>,
    },
    /// The part that the sensitivities to all parameters share: the time derivative of a partial derivative by an
    /// unknown.
    Entry {
        symbol: Symbol,
        node: Node,
        row: Dependent,
        unknown: usize,
        order: usize,
    },
}

/// A quantity that is differentiated.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Dependent {
    Equation(usize),
    Output(usize),
}

impl Derivatives {
    /// The sensitivities to `parameters` parameters, of every order derived so far, in the order in which they can be
    /// computed.
    ///
    /// # Errors
    /// Returns an error if there are too many expressions.
    pub(crate) fn sensitivities(
        &mut self,
        graph: &mut Graph,
        task: Subject<'_>,
        parameters: usize,
    ) -> Result<Vec<Definition>, TooLarge> {
        let highest = self.orders.len();
        let mut derivation = Derivation {
            graph,
            task,
            rates: &mut self.rates,
            definitions: Vec::new(),
            partials: BTreeMap::new(),
            entries: BTreeMap::new(),
            found: BTreeMap::new(),
        };
        for order in 0..=highest {
            for parameter in 0..parameters {
                if work::is_spent() {
                    return Err(TooLarge { order });
                }
                let mut known = Vec::new();
                for (block, jacobian) in task.blocks.iter().zip(&self.jacobians) {
                    known.extend(&block.unknowns);
                    let right: Vec<Node> = block
                        .equations
                        .iter()
                        .map(|&equation| {
                            let total = derivation.total(Dependent::Equation(equation), &known, parameter, order);
                            derivation.graph.negate(total)
                        })
                        .collect();
                    derivation.solve(jacobian, &right, parameter, order);
                }
                for output in 0..task.outputs.len() {
                    let node = derivation.total(Dependent::Output(output), &known, parameter, order);
                    derivation.definitions.push(Definition::Value {
                        symbol: Symbol::OutputSensitivity(output, parameter, order),
                        node,
                    });
                }
            }
            if derivation.graph.len() > task.most_expressions {
                return Err(TooLarge { order });
            }
        }
        Ok(derivation.definitions)
    }
}

struct Derivation<'a> {
    graph: &'a mut Graph,
    task: Subject<'a>,
    rates: &'a mut KnownRates,
    definitions: Vec<Definition>,
    partials: BTreeMap<(Dependent, Symbol), Node>,
    /// The symbols of the time derivatives of partial derivatives, as the sums refer to them.
    entries: BTreeMap<Node, Node>,
    /// The sensitivities of unknowns found so far: symbols, or zero.
    found: BTreeMap<Symbol, Node>,
}

impl Derivation<'_> {
    /// (∂f/∂p)⁽ⁿ⁾ + Σ C(n, k) (∂f/∂q)⁽ⁿ⁻ᵏ⁾ S⁽ᵏ⁾ over the given unknowns and the S⁽ᵏ⁾ found so far.
    fn total(&mut self, row: Dependent, unknowns: &[usize], parameter: usize, order: usize) -> Node {
        let partial = self.partial(row, Symbol::Parameter(parameter), order);
        let mut terms = vec![(partial, 1.0)];
        let whole = self.node(row);
        for &unknown in unknowns {
            if !self.graph.contains(whole, Symbol::Unknown(unknown)) {
                continue;
            }
            for k in 0..=order {
                let Some(&sensitivity) = self.found.get(&Symbol::Sensitivity(unknown, parameter, k)) else {
                    continue;
                };
                if self.graph.is_zero(sensitivity) {
                    continue;
                }
                let entry = self.entry(row, unknown, order - k);
                terms.push((self.graph.multiply(entry, sensitivity), binomial(order, k)));
            }
        }
        self.graph.linear(0.0, &terms)
    }

    const fn node(&self, row: Dependent) -> Node {
        match row {
            Dependent::Equation(equation) => self.task.residuals[equation],
            Dependent::Output(output) => self.task.outputs[output],
        }
    }

    /// The time derivative of a partial derivative.
    fn partial(&mut self, row: Dependent, symbol: Symbol, order: usize) -> Node {
        let node = self.node(row);
        let partial = if let Some(&partial) = self.partials.get(&(row, symbol)) {
            partial
        } else {
            let partial = self.graph.partial(node, symbol);
            self.partials.insert((row, symbol), partial);
            partial
        };
        self.rates.total(self.graph, partial, order)
    }

    /// The time derivative of a partial derivative by an unknown, computed once for all parameters.
    fn entry(&mut self, row: Dependent, unknown: usize, order: usize) -> Node {
        let whole = self.partial(row, Symbol::Unknown(unknown), order);
        let (coefficient, bare) = self.graph.split_coefficient(whole);
        if matches!(self.graph.kind(bare), NodeKind::Number(_) | NodeKind::Symbol(_)) {
            return whole;
        }
        let symbol = if let Some(&symbol) = self.entries.get(&bare) {
            symbol
        } else {
            let (symbol, node) = self.graph.new_step();
            self.definitions.push(Definition::Entry {
                symbol,
                node: bare,
                row,
                unknown,
                order,
            });
            self.entries.insert(bare, node);
            node
        };
        self.graph.scale(coefficient, symbol)
    }

    /// S⁽ⁿ⁾ of a block, from J S⁽ⁿ⁾ = right by the solver of the rates.
    fn solve(&mut self, jacobian: &BlockJacobian, right: &[Node], parameter: usize, order: usize) {
        let symbol = |unknown: usize| Symbol::Sensitivity(unknown, parameter, order);
        // each right-hand side has entries of the order of the row only
        for solution in jacobian.solve(self.graph, Influences::Separate, right, &symbol) {
            match solution {
                Rate::Value { symbol, value } => {
                    let node = if self.graph.is_zero(value) {
                        value
                    } else {
                        self.graph.symbol(symbol)
                    };
                    self.found.insert(symbol, node);
                    self.definitions.push(Definition::Value { symbol, node: value });
                }
                Rate::System {
                    factors,
                    symbols,
                    right,
                } => {
                    for &symbol in &symbols {
                        let node = self.graph.symbol(symbol);
                        self.found.insert(symbol, node);
                    }
                    self.definitions.push(Definition::System {
                        factors,
                        right,
                        results: symbols,
                    });
                }
            }
        }
    }
}
