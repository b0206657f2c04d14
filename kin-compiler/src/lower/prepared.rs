//! The part of a position that needs the parameters alone. It is calculated once for many poses of a mechanism.

use std::collections::BTreeSet;

use super::Lowering;
use crate::algebra::Symbol;
use crate::program::{Expression, Mode, Stage, Step};
use crate::structure::Block;

impl Lowering<'_> {
    /// The values of a position that are found first, because they need the parameters alone. There are none if they
    /// are found as fast as they are read, or if a block is coupled: that takes much longer than all of them.
    pub(crate) fn prepared(&self, position: &Stage<Expression>) -> BTreeSet<Symbol> {
        if self.blocks.iter().any(Block::is_coupled) {
            return BTreeSet::new();
        }
        of_parameters_alone(position)
    }
}

fn of_parameters_alone(position: &Stage<Expression>) -> BTreeSet<Symbol> {
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
    /// All of them.
    All,
    /// Those that find prepared values.
    Prepared(&'a BTreeSet<Symbol>),
    /// All others.
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

#[cfg(test)]
mod tests {
    use proc_macro2::TokenStream;
    use quote::quote;

    use super::*;
    use crate::passes::Passes;
    use crate::testing::sound;

    /// The names of what is prepared.
    fn names(declaration: TokenStream) -> Vec<String> {
        let solvers = sound(declaration).solvers(Passes::ALL);
        let prepared = of_parameters_alone(&solvers.orders()[0]);
        let names = prepared.iter().map(|&symbol| solvers.names().of(symbol).to_owned());
        let mut names: Vec<String> = names.collect();
        names.sort_unstable();
        names
    }

    /// A sine of a parameter is prepared with all that is made of it, and no sine of an input.
    #[test]
    fn sines_of_parameters_are_prepared() {
        let found = names(quote! {
            struct Tilted { tilt: Angle, length: Length }
            input theta: Angle;
            unknown s: Length;
            s == length * cos(tilt) * sin(theta);
        });
        assert_eq!(found, ["cos_tilt", "length_cos_tilt"]);
    }

    /// A term of a sum that needs the parameters alone is prepared, and not only its sine.
    #[test]
    fn terms_are_prepared() {
        let found = names(quote! {
            struct Tilted { tilt: Angle, lift: Length, length: Length }
            input theta: Angle;
            unknown s: Length;
            s == lift * cos(tilt) + length * sin(theta);
        });
        assert_eq!(found, ["cos_tilt", "lift_cos_tilt"]);
    }

    /// Few products are found as fast as they are read.
    #[test]
    fn products_alone_are_not_prepared() {
        let found = names(quote! {
            struct FourBar { r1: Length, r2: Length, r3: Length, r4: Length }
            input theta2: Angle;
            unknown theta3: Angle, theta4: Angle;
            r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
        });
        assert_eq!(found, [""; 0]);
    }

    /// What both candidates of a range need is found before them.
    #[test]
    fn candidates_are_prepared() {
        let found = names(quote! {
            struct Tilted { tilt: Angle, rod: Length }
            input s: Length;
            unknown phi: Angle in 0.0..3.0;
            rod * cos(phi) / cos(tilt) == s;
        });
        assert_eq!(found, ["cos_tilt"]);
    }
}
