//! The terms of decisive numbers, for `kin_core::solve::decisive`. A number is decisive if its sign decides, or the
//! test that it is nonzero.
//!
//! A closed form knows the terms of the number under its root. Some forms decide by a number that they are given: the
//! coefficient of a linear equation, a determinant, the argument of a root. Only the expression of such a number tells
//! how large its terms are.

use proc_macro2::TokenStream;
use quote::quote;

use super::ProgramText;
use crate::algebra::Symbol;
use crate::program::{Expression, Step};

/// The largest number of terms of a product of sums that is multiplied out.
const MOST_TERMS: usize = 12;

/// A decisive number with its terms. They are the terms of its expression, or of the statement among `among` that
/// defines it.
pub(super) fn decisive(text: &ProgramText<'_>, value: &Expression, among: &[&Step<Expression>]) -> TokenStream {
    let (runtime, own) = (text.mechanism.runtime, text.expression(value));
    let terms = terms(value, among);
    if terms.len() < 2 {
        return own;
    }
    let terms = text.expressions(&terms);
    quote!(#runtime::solve::decisive(#own, || [#(#terms),*]))
}

/// A vector with its terms. The test that the vector is nonzero decides.
pub(super) fn decisive_vector(
    text: &ProgramText<'_>,
    [x, y]: &[Expression; 2],
    among: &[&Step<Expression>],
) -> TokenStream {
    let runtime = text.mechanism.runtime;
    let (own_x, own_y) = (text.expression(x), text.expression(y));
    let own = quote!(#runtime::Plane::new(#own_x, #own_y));
    let mut terms = terms(x, among);
    terms.extend(self::terms(y, among));
    if terms.len() < 3 {
        return own;
    }
    let terms = text.expressions(&terms);
    quote!(#runtime::solve::decisive_vector(#own, || [#(#terms),*]))
}

fn terms(value: &Expression, among: &[&Step<Expression>]) -> Vec<Expression> {
    let definition = |own: Symbol| {
        among.iter().find_map(|step| match step {
            Step::Define { symbol, value } if *symbol == own => Some(value),
            _ => None,
        })
    };
    match value {
        Expression::Name(symbol) => definition(*symbol).map_or_else(|| vec![value.clone()], sum_of),
        _ => sum_of(value),
    }
}

/// The terms of an expression. Their signs are left out if that is simpler.
fn sum_of(value: &Expression) -> Vec<Expression> {
    let whole = || vec![value.clone()];
    match value {
        Expression::Add(a, b) | Expression::Subtract(a, b) => {
            let mut terms = sum_of(a);
            terms.extend(sum_of(b));
            terms
        }
        Expression::Negate(a) => sum_of(a),
        Expression::Multiply(a, b) => {
            let (first, second) = (sum_of(a), sum_of(b));
            let count = first.len() * second.len();
            if !(2..=MOST_TERMS).contains(&count) {
                return whole();
            }
            let product = |a: &Expression, b: &Expression| Expression::Multiply(a.clone().into(), b.clone().into());
            first
                .iter()
                .flat_map(|a| second.iter().map(move |b| product(a, b)))
                .collect()
        }
        Expression::Divide(a, b) => {
            let above = sum_of(a);
            if above.len() < 2 {
                return whole();
            }
            above
                .into_iter()
                .map(|term| Expression::Divide(term.into(), b.clone()))
                .collect()
        }
        _ => whole(),
    }
}
