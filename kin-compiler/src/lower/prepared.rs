//! The part of a position that needs the parameters alone. It is calculated once for many poses of a mechanism.

use std::collections::BTreeSet;

use crate::algebra::Symbol;
use crate::program::{Expression, Mode, Stage, Step};

/// The values of a position that need the parameters alone; none if they are found as fast as they are read.
pub(crate) fn prepared(position: &Stage<Expression>) -> BTreeSet<Symbol> {
    let (mut prepared, mut takes_long, mut is_ranged) = (BTreeSet::new(), false, false);
    for step in &position.steps {
        takes_long |= match step {
            // both candidates are found in a closure of their own
            Step::Open { mode, .. } => {
                is_ranged = *mode == Mode::Ranged;
                continue;
            }
            Step::Close { .. } => {
                is_ranged = false;
                continue;
            }
            // results of the position are tested where they are found
            Step::Define {
                symbol: Symbol::Unknown(_) | Symbol::OutputRate(..),
                ..
            } => continue,
            _ if is_ranged || !needs_parameters_alone(step, &prepared) => continue,
            Step::Define { value, .. } => divides(value),
            Step::Check { .. } | Step::SineCosine { .. } => true,
            _ => continue,
        };
        prepared.extend(step.defines());
    }
    if takes_long { prepared } else { BTreeSet::new() }
}

fn needs_parameters_alone(step: &Step<Expression>, prepared: &BTreeSet<Symbol>) -> bool {
    let is_known = |symbol: &Symbol| matches!(symbol, Symbol::Parameter(_)) || prepared.contains(symbol);
    step.uses().iter().all(is_known)
}

fn divides(value: &Expression) -> bool {
    match value {
        Expression::Divide(..) => true,
        Expression::Add(a, b) | Expression::Subtract(a, b) | Expression::Multiply(a, b) => divides(a) || divides(b),
        Expression::Negate(a) => divides(a),
        Expression::Call(_, arguments) => arguments.iter().any(divides),
        Expression::Name(_) | Expression::Number(_) | Expression::Pi => false,
    }
}

/// The steps of a position that are lowered.
#[derive(Clone, Copy)]
pub(crate) enum Extent<'a> {
    All,
    /// Those that find prepared values.
    Prepared(&'a BTreeSet<Symbol>),
    /// Those that need prepared values.
    Further(&'a BTreeSet<Symbol>),
}

impl Extent<'_> {
    pub(super) fn includes(self, step: &Step<Expression>) -> bool {
        let is_prepared = |prepared: &BTreeSet<Symbol>| {
            let found = step.defines();
            !found.is_empty() && found.iter().all(|symbol| prepared.contains(symbol))
        };
        match self {
            Self::All => true,
            Self::Prepared(prepared) => is_prepared(prepared),
            Self::Further(prepared) => !is_prepared(prepared),
        }
    }
}
