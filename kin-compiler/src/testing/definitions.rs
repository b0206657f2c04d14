//! The tests that every value of a program is computed before it is used.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::algebra::Symbol;
use crate::expand::expand;
use crate::program::{Expression, Solvers, Stage, Step};

/// Asserts that all programs of a mechanism compute values before their use. The tests of this crate call it for each
/// declaration that they expand.
pub(crate) fn assert_defined(solvers: &Solvers) {
    let stages = &solvers.motion.stages;
    for (order, stage) in stages.iter().enumerate() {
        let carried = stage.uses.iter().map(|carried| carried.symbol);
        let given: BTreeSet<Symbol> = stage.reads.iter().copied().chain(carried).collect();
        assert_of_stage(stage, |symbol| given.contains(&symbol));
        let before = order.checked_sub(1).map(|before| &stages[before].carries);
        for carried in &stage.uses {
            let is_carried = before.is_some_and(|carries| carries.contains(carried));
            assert!(
                is_carried,
                "a value is not carried to the stage of order {order}: {carried:?}"
            );
        }
    }
    for stage in solvers.every.iter().flat_map(|program| &program.stages) {
        assert_of_stage(stage, |symbol| {
            matches!(symbol, Symbol::Parameter(_) | Symbol::Input(_))
        });
    }
    for stage in solvers.closure.iter().flat_map(|closure| &closure.program.stages) {
        assert_of_stage(stage, |symbol| matches!(symbol, Symbol::Parameter(_)));
    }
    for stage in &solvers.orientations.stages {
        assert_of_stage(stage, |symbol| {
            matches!(symbol, Symbol::Parameter(_) | Symbol::Input(_) | Symbol::Unknown(_))
        });
    }
}

/// Asserts that each value used in a stage is given to the stage or defined by an earlier step.
fn assert_of_stage(stage: &Stage<Expression>, is_given: impl Fn(Symbol) -> bool) {
    let mut defined = BTreeSet::new();
    for step in &stage.steps {
        if let Step::Newton { unknowns, .. } = step {
            defined.extend(unknowns.iter().map(|&unknown| Symbol::Unknown(unknown)));
        }
        for symbol in step.uses() {
            assert!(
                is_given(symbol) || defined.contains(&symbol),
                "a value is used before it is computed: {symbol:?}"
            );
        }
        defined.extend(step.defines());
    }
}

/// Expands a declaration with two given equations and others, for `u`, `w` and other unknowns.
fn expand_equations(others: &TokenStream, equations: &TokenStream) {
    expand(quote! {
        struct Found { a: Length, b: Length }
        input t: Angle;
        unknown u: Angle, w: Angle #others;
        #equations
    });
}

/// An unknown occurs in a quotient of the equation from which it is taken out.
#[test]
fn what_is_taken_out_is_not_defined_by_itself() {
    expand_equations(
        &quote!(, v: Scalar, s: Length),
        &quote! {
            s + a * u == b;
            s / a - t == v;
            v == w;
            u * v == PI;
        },
    );
}

/// An unknown cancels when an equation is multiplied out, at first or after another unknown has been taken out.
#[test]
fn unknowns_that_cancel_are_not_waited_for() {
    expand_equations(
        &quote!(),
        &quote! {
            (b + a * u) / a - u + w == t;
            u * u + w == t;
        },
    );
    expand_equations(
        &quote!(, v: Length),
        &quote! {
            b + a * u == v;
            w + v / a - u == t;
            u * w == v / a + t;
        },
    );
}

/// An unknown occurs in an angle of many terms.
#[test]
fn an_angle_of_many_terms_is_split() {
    let corners: Vec<Ident> = (0..32).map(|index| format_ident!("d{index}")).collect();
    expand(quote! {
        struct Found { a: Length, b: Length, #(#corners: Angle),* }
        input t: Angle;
        unknown u: Angle, s: Length;
        a * cis(u + t #(+ #corners)*) + b * cis(t #(+ #corners)*) == vec2(s, 0);
    });
}
