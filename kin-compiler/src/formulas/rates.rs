//! The linear equations of the rates.

use std::collections::BTreeMap;

use super::expression::{Expressions, functions_last};
use super::name::Name;
use super::names::NotationNames;
use super::term::{DisplayLine, Notation};
use super::typed::{complex, term};
use crate::algebra::{Graph, Node, Symbol};
use crate::model::{Model, ValueShape};
use crate::room::with_room;
use crate::structure::Block;
use crate::syntax::{Declaration, EquationStatement, Statement};

/// The scalar equations f = 0, with their names.
pub(super) struct Residuals<'a> {
    names: &'a NotationNames,
    nodes: &'a [Node],
    /// For each scalar equation, the declared one to which it belongs.
    origins: Vec<usize>,
    shapes: Vec<ValueShape>,
    equations: Vec<&'a EquationStatement>,
}

impl<'a> Residuals<'a> {
    pub(super) fn new(
        declaration: &'a Declaration,
        model: &Model,
        names: &'a NotationNames,
        nodes: &'a [Node],
    ) -> Self {
        let (_, origins) = model.scalar_equations();
        Self {
            names,
            nodes,
            origins: origins.into_iter().map(|origin| origin.equation).collect(),
            shapes: model
                .equations
                .iter()
                .map(|equation| equation.residual.shape())
                .collect(),
            equations: equations(declaration).collect(),
        }
    }

    /// The index of a scalar equation.
    pub(super) fn index_of(&self, residual: Node) -> Option<usize> {
        self.nodes.iter().position(|&node| node == residual)
    }

    /// The name of the left side minus the right side of a scalar equation.
    pub(super) fn name(&self, index: usize) -> Name {
        let name = self.names.fresh('f');
        if self.nodes.len() == 1 {
            name
        } else {
            name.indexed((index + 1).to_string())
        }
    }

    /// The definitions of the names of some scalar equations.
    pub(super) fn definitions(&self, indices: &[usize]) -> Vec<DisplayLine> {
        let mut declared: Vec<usize> = indices.iter().map(|&index| self.origins[index]).collect();
        declared.sort_unstable();
        declared.dedup();
        declared
            .into_iter()
            .map(|equation| {
                let parts = (0..self.nodes.len()).filter(|&index| self.origins[index] == equation);
                let mut parts: Vec<Notation> = parts.map(|index| Notation::Name(self.name(index))).collect();
                let left = match (self.shapes[equation], parts.len()) {
                    (ValueShape::Plane, 2) => complex(parts.remove(0), parts.remove(0)),
                    (_, 1) => parts.remove(0),
                    _ => Notation::Tuple(parts),
                };
                let typed = self.equations[equation];
                let right = term(self.names, &typed.left).minus(term(self.names, &typed.right));
                DisplayLine::equation(left, right)
            })
            .collect()
    }
}

/// The equations of a declaration.
pub(super) fn equations(declaration: &Declaration) -> impl Iterator<Item = &EquationStatement> {
    declaration.statements.iter().filter_map(|statement| match statement {
        Statement::Equation(equation) => Some(equation),
        _ => None,
    })
}

/// ∂f/∂x
pub(super) fn change_over(of: &Name, by: &Name) -> Notation {
    Notation::Change('∂', of.clone()).over(Notation::Change('∂', by.clone()))
}

/// The partial derivatives of each scalar equation by the unknowns and inputs that it contains, without zeros.
pub(super) fn partials(graph: &mut Graph, model: &Model, residuals: &[Node]) -> Vec<Vec<(Symbol, Node)>> {
    let unknowns = (0..model.unknowns.len()).map(Symbol::Unknown);
    let symbols: Vec<Symbol> = unknowns.chain((0..model.inputs.len()).map(Symbol::Input)).collect();
    with_room(|| {
        let mut rows = Vec::new();
        for &residual in residuals {
            let mut row = Vec::new();
            for &symbol in &symbols {
                if graph.contains(residual, symbol) {
                    let partial = graph.partial(residual, symbol);
                    row.extend((!graph.is_zero(partial)).then_some((symbol, partial)));
                }
            }
            rows.push(row);
        }
        rows
    })
}

/// The linear equations of a block's velocities, given the partial derivatives of all scalar equations. The rates of
/// the block's unknowns are on the left, those of all other quantities on the right.
pub(super) fn velocity(
    graph: &Graph,
    partials: &[Vec<(Symbol, Node)>],
    residuals: &Residuals<'_>,
    block: &Block,
) -> Vec<DisplayLine> {
    let names = residuals.names;
    let is_own = |symbol| matches!(symbol, Symbol::Unknown(unknown) if block.unknowns.contains(&unknown));
    let (mut rows, mut named) = (Vec::new(), Vec::new());
    for &index in &block.equations {
        let (mut left, mut right) = (Vec::new(), Vec::new());
        for &(symbol, partial) in &partials[index] {
            let Some(name) = names.symbol(symbol) else { continue };
            let expressions = Expressions {
                graph,
                names,
                results: &BTreeMap::new(),
            };
            let rate = Notation::Rate(name.clone(), 1);
            let term = expressions.coefficient(partial).map_or_else(
                || {
                    named.push(index);
                    Notation::product([change_over(&residuals.name(index), &name), rate.clone()])
                },
                |coefficient| times(coefficient, rate.clone()),
            );
            if is_own(symbol) {
                left.push(term);
            } else {
                right.push(term.negative());
            }
        }
        rows.push(DisplayLine::equation(Notation::sum(left), Notation::sum(right)));
    }
    let mut lines = residuals.definitions(&named);
    lines.extend(rows);
    lines
}

/// A coefficient times a rate, which stands before the functions.
fn times(coefficient: Notation, rate: Notation) -> Notation {
    match coefficient {
        Notation::Negative(of) => times(*of, rate).negative(),
        Notation::Product(mut factors) => {
            factors.push(rate);
            functions_last(factors)
        }
        // a sum begins with a minus sign only if all its terms do
        Notation::Sum(terms) if matches!(terms.first(), Some(Notation::Negative(_))) => {
            let opposite = Notation::sum(terms.into_iter().map(Notation::negative));
            Notation::Product(vec![opposite, rate]).negative()
        }
        sum @ Notation::Sum(_) => Notation::Product(vec![sum, rate]),
        other => functions_last(vec![other, rate]),
    }
}

/// The same linear equations at the orders from acceleration to `order`, by Leibniz's rule from A ẋ = b.
pub(super) fn recurrence(names: &NotationNames, orders: std::ops::RangeInclusive<usize>) -> Vec<DisplayLine> {
    let [matrix, right, unknowns] = ['A', 'b', 'x'].map(|letter| names.fresh(letter).marked_as_vector(true));
    let derivative = |name: &Name, order: usize| match order {
        0 => Notation::Name(name.clone()),
        order => Notation::Rate(name.clone(), order),
    };
    let row = |order: usize| {
        let mut terms = vec![derivative(&right, order - 1)];
        let mut binomial = 1;
        for below in 1..order {
            binomial = binomial * (order - below) / below;
            let factor = Notation::Number(f64::from(u32::try_from(binomial).unwrap_or(u32::MAX)));
            let product = [factor, derivative(&matrix, below), derivative(&unknowns, order - below)];
            terms.push(Notation::product(product).negative());
        }
        let left = Notation::product([Notation::Name(matrix.clone()), derivative(&unknowns, order)]);
        DisplayLine::equation(left, Notation::sum(terms))
    };
    orders.map(row).collect()
}
