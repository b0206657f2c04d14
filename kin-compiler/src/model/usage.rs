//! Missing statements and unused names.

use std::collections::{BTreeMap, BTreeSet};

use super::scope::{NameRole, Scope};
use super::{Equation, Unknown};
use crate::algebra::{Graph, Node};
use crate::mistakes::Mistakes;
use crate::syntax::{Declaration, Statement, TypedFormula};

/// Reports missing inputs, unknowns or equations.
pub(super) fn missing_statements(declaration: &Declaration, mistakes: &mut Mistakes) {
    let name = &declaration.name;
    if declaration.statements.is_empty() {
        mistakes.error(
            name,
            format!(
                "nothing is said of `{name}` but its parameters: declare an `input`, the `unknown`s and the equations \
                 after the struct"
            ),
        );
        return;
    }
    let some = |kind: fn(&Statement) -> bool| declaration.statements.iter().any(kind);
    if !some(|statement| matches!(statement, Statement::Inputs(_))) {
        mistakes.error(
            name,
            format!("`{name}` has no input, so nothing moves it: declare one, as in `input theta2: Angle;`"),
        );
    }
    if !some(|statement| matches!(statement, Statement::Unknowns(_))) {
        mistakes.error(
            name,
            format!("`{name}` has no unknown to solve for: declare one, as in `unknown theta3: Angle;`"),
        );
    }
    if !some(|statement| matches!(statement, Statement::Equation(_))) {
        mistakes.error(
            name,
            format!("`{name}` has no equation: write its loop closure, as in `a * cis(theta) == b;`"),
        );
    }
}

/// Reports names that are declared and not used.
pub(super) fn unused_names(declaration: &Declaration, scope: &Scope<'_>, mistakes: &mut Mistakes) {
    for entry in &scope.entries {
        let word = entry.name.to_string();
        if entry.used || declaration.mentioned.contains(&word) || scope.is_meant(&word) {
            continue;
        }
        // a frame that is not used has been reported
        if declaration.fresh.is_of_frame(&word) {
            continue;
        }
        let word = declaration.fresh.written(&word);
        let complaint = match entry.role {
            NameRole::Parameter | NameRole::Input => format!(
                "{} `{word}` is not used in any equation or output: use it, or remove it",
                entry.role.word()
            ),
            NameRole::Let => format!("`let {word}` is never used: use it, or remove it"),
            NameRole::Unknown | NameRole::Output => continue,
        };
        mistakes.error(&entry.name, complaint);
    }
}

/// Reports unknowns that no equation contains, and scalar equations without an unknown. Returns false if there is one.
pub(super) fn unknowns_in_equations(
    declaration: &Declaration,
    unknowns: &[Unknown],
    equations: &[Option<Equation>],
    graph: &Graph,
    scope: &Scope<'_>,
    mistakes: &mut Mistakes,
) -> bool {
    let before = mistakes.is_empty();
    let mut found: BTreeSet<usize> = BTreeSet::new();
    for equation in equations.iter().flatten() {
        let residual = &equation.residual;
        let axes = residual.shape().axes();
        let parts: Vec<(Node, String)> = residual
            .nodes()
            .into_iter()
            .enumerate()
            .map(|(part, node)| match axes.get(part) {
                None => (node, "this equation".to_owned()),
                Some(axis) => (node, format!("the {axis} part of this equation")),
            })
            .collect();
        let mut idle: Vec<&(Node, String)> = Vec::new();
        for part in &parts {
            let contained: Vec<usize> = graph.unknowns(part.0).collect();
            if contained.is_empty() {
                idle.push(part);
            }
            found.extend(contained);
        }
        if unknowns.is_empty() || idle.is_empty() || scope.has_twins() {
            continue;
        }
        let whole = idle.len() == parts.len();
        for (node, subject) in idle.iter().take(if whole { 1 } else { parts.len() }) {
            let subject = if whole { "this equation" } else { subject.as_str() };
            let remedy = if whole {
                "remove it"
            } else {
                match axes {
                    [_, _] => "write the other part alone, by `.x` or `.y`",
                    _ => "write the other parts alone, by `.x`, `.y` and `.z`",
                }
            };
            let complaint = match graph.constant_value(*node) {
                Some(0.0) => format!("{subject} is always true and determines nothing: {remedy}"),
                Some(_) => {
                    format!("{subject} is never true, whatever the unknowns are: correct it")
                }
                None => format!("{subject} contains no unknown, so it determines none: {remedy}"),
            };
            mistakes.error(&equation.tokens, complaint + &equation.which());
        }
    }
    let mut written = None;
    for (index, unknown) in unknowns.iter().enumerate() {
        let word = unknown.name.to_string();
        if found.contains(&index) || declaration.mentioned.contains(&word) || scope.is_meant(&word) {
            continue;
        }
        let written = written.get_or_insert_with(|| written_names(declaration));
        let cancelled = declaration_mentions(written, equations, &word);
        match cancelled {
            Mention::InBroken => {}
            Mention::InSound => mistakes.error(
                &unknown.name,
                format!("unknown `{word}` cancels out of every equation: nothing determines it"),
            ),
            Mention::Nowhere => {
                if !equations.is_empty() && !declaration.breaks_off {
                    mistakes.error(
                        &unknown.name,
                        format!("no equation contains the unknown `{word}`: write one, or remove it"),
                    );
                }
            }
        }
    }
    before == mistakes.is_empty()
}

enum Mention {
    Nowhere,
    /// Only in equations without a mistake.
    InSound,
    /// In an equation with a mistake.
    InBroken,
}

fn declaration_mentions(written: &[BTreeSet<String>], equations: &[Option<Equation>], word: &str) -> Mention {
    let mut mention = Mention::Nowhere;
    for (names, equation) in written.iter().zip(equations) {
        if names.contains(word) {
            if equation.is_none() {
                return Mention::InBroken;
            }
            mention = Mention::InSound;
        }
    }
    mention
}

/// The names typed in each equation, including those in its abbreviations.
fn written_names(declaration: &Declaration) -> Vec<BTreeSet<String>> {
    let names_of = |expressions: &[&TypedFormula]| {
        let mut names = BTreeSet::new();
        for expression in expressions {
            expression.visit_names(&mut |name| {
                names.insert(name.to_string());
            });
        }
        names
    };
    let mut abbreviations: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
    let mut equations = Vec::new();
    for statement in &declaration.statements {
        match statement {
            Statement::Equation(statement) => equations.push(names_of(&[&statement.left, &statement.right])),
            statement => {
                if let Some((name, value)) = statement.abbreviation() {
                    abbreviations.insert(name.to_string(), names_of(&[value]));
                }
            }
        }
    }
    for names in &mut equations {
        let mut pending: Vec<String> = names.iter().cloned().collect();
        while let Some(name) = pending.pop() {
            for inner in abbreviations.get(&name).into_iter().flatten() {
                if names.insert(inner.clone()) {
                    pending.push(inner.clone());
                }
            }
        }
    }
    equations
}
