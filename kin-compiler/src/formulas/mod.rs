//! Formulas to be read: the equations and their solution in the notation of textbooks, as text, MathML and LaTeX.
//!
//! Equations, abbreviations and outputs keep the shape in which they were typed. The solutions of the blocks and the
//! linear equations of the rates come from the graph. All of them become terms (`term.rs`), and one printer
//! (`print.rs`) writes terms in all three forms. The printer alone decides where parentheses stand.

mod expression;
mod form;
mod name;
mod names;
mod print;
mod rates;
mod solution;
mod term;
#[cfg(test)]
mod tests;
mod typed;

use std::collections::BTreeSet;

use crate::algebra::{Graph, Node};
use crate::model::Model;
use crate::structure::Block;
use crate::syntax::{Declaration, RangeKind, Relation, Statement};
use names::NotationNames;
use rates::{Residuals, equations, partials, recurrence, velocity};
use solution::Solutions;
use term::{DisplayLine, Notation};
use typed::term;

/// A formula, or several below each other, in three forms.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Formula {
    /// Lines for a terminal or an editor.
    pub text: String,
    /// A `<math>` element.
    pub mathml: String,
    /// For the mathematical mode, with the relations below each other.
    pub latex: String,
}

/// The formulas of a mechanism.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Formulas {
    /// The abbreviations, the equations, and the ranges of the unknowns.
    pub closure: Formula,
    /// The solution of each block, in order.
    pub position: Vec<Formula>,
    /// The linear equations of each block's velocities.
    pub velocity: Vec<Formula>,
    /// The linear equations of each order from the acceleration on.
    pub higher: Vec<Formula>,
    /// The linear equations of all orders from the acceleration on.
    pub rates: Formula,
    /// The outputs.
    pub outputs: Formula,
}

/// The formulas of a declaration without mistakes, whose scalar equations are `residual == 0`.
pub(crate) fn formulas(
    declaration: &Declaration,
    model: &Model,
    mut graph: Graph,
    residuals: &[Node],
    blocks: &[Block],
) -> Formulas {
    let names = NotationNames::new(declaration, model);
    let is_cis = names.look_complex();
    let formula = |lines: &[DisplayLine]| print::formula(lines, is_cis);
    let partials = partials(&mut graph, model, residuals);
    let residuals = Residuals::new(declaration, model, &names, residuals);
    let position = {
        let mut solutions = Solutions::new(&mut graph, &names, &residuals);
        blocks.iter().map(|block| formula(&solutions.block(block))).collect()
    };
    let velocity = blocks
        .iter()
        .map(|block| formula(&velocity(&graph, &partials, &residuals, block)))
        .collect();
    Formulas {
        closure: formula(&closure(declaration, &names)),
        position,
        velocity,
        higher: (2..=model.order)
            .map(|order| formula(&recurrence(&names, order..=order)))
            .collect(),
        rates: formula(&recurrence(&names, 2..=model.order)),
        outputs: formula(&outputs(declaration, &names)),
    }
}

/// The equations, after the abbreviations that they use, and before the ranges of the unknowns.
fn closure(declaration: &Declaration, names: &NotationNames) -> Vec<DisplayLine> {
    let mut used = BTreeSet::new();
    for equation in equations(declaration) {
        for side in [&equation.left, &equation.right] {
            side.visit_names(&mut |name| {
                used.insert(name.to_string());
            });
        }
    }
    let mut lines = abbreviations(declaration, names, used);
    lines.extend(
        equations(declaration)
            .map(|equation| DisplayLine::equation(term(names, &equation.left), term(names, &equation.right))),
    );
    for statement in &declaration.statements {
        let Statement::Unknowns(items) = statement else {
            continue;
        };
        for item in items {
            if let Some(clause) = &item.range {
                lines.extend(range(names, &item.quantity.name.to_string(), &clause.kind));
            }
        }
    }
    lines
}

/// The outputs, with the abbreviations that they use.
fn outputs(declaration: &Declaration, names: &NotationNames) -> Vec<DisplayLine> {
    let outputs = declaration.statements.iter().filter_map(|statement| match statement {
        Statement::Output(output) => Some(output.name.to_string()),
        _ => None,
    });
    abbreviations(declaration, names, outputs.collect())
}

/// The abbreviations among some names, and those that they use themselves, in the order of the declaration.
fn abbreviations(declaration: &Declaration, names: &NotationNames, mut used: BTreeSet<String>) -> Vec<DisplayLine> {
    let mut lines = Vec::new();
    // an abbreviation comes after those that it uses
    for statement in declaration.statements.iter().rev() {
        if let Some((name, value)) = statement.abbreviation()
            && used.contains(&name.to_string())
        {
            value.visit_names(&mut |name| {
                used.insert(name.to_string());
            });
            lines.push(DisplayLine::equation(
                named(names, &name.to_string()),
                term(names, value),
            ));
        }
    }
    lines.reverse();
    lines
}

/// The range of an unknown, as one or two comparisons.
fn range(names: &NotationNames, unknown: &str, kind: &RangeKind) -> Vec<DisplayLine> {
    let line = |relation, bound| DisplayLine {
        left: named(names, unknown),
        relation,
        right: term(names, bound),
    };
    match kind {
        RangeKind::Comparison { comparison, bound, .. } => {
            let relation = match comparison {
                Relation::Less => "<",
                Relation::LessOrEqual => "≤",
                Relation::Greater => ">",
                Relation::GreaterOrEqual => "≥",
            };
            vec![line(relation, bound)]
        }
        RangeKind::Between { low, high, closed } => {
            vec![line("≥", low), line(if *closed { "≤" } else { "<" }, high)]
        }
    }
}

fn named(names: &NotationNames, identifier: &str) -> Notation {
    names
        .of(identifier)
        .map_or(Notation::Dots, |(name, _)| Notation::Name(name.clone()))
}
