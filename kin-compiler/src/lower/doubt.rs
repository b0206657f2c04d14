//! The terms of decisive numbers, for `kin_core::solve::decisive`. A number is decisive if its sign decides, or the
//! test that it is nonzero.
//!
//! A closed form knows the terms of the number under its root. Some forms decide by a number that they are given: the
//! coefficient of a linear equation, a determinant, the argument of a root. Only the expression of such a number says
//! how large its terms are.

use super::{Decisive, Value};
use crate::algebra::Symbol;
use crate::program::{Expression, Step};

/// The largest number of terms of a product of sums that is multiplied out.
const MOST_TERMS: usize = 12;

/// A decisive number with its terms. They are the terms of its expression, or of the step among `among` that defines
/// it.
pub(super) fn decisive(value: &Expression, among: &[&Step<Expression>]) -> Decisive {
    Decisive {
        value: Value::of(value),
        terms: at_least(2, &terms(value, among)),
    }
}

/// The terms of a vector. The test that the vector is nonzero decides.
pub(super) fn terms_of_vector([x, y]: &[Expression; 2], among: &[&Step<Expression>]) -> Vec<Value> {
    let mut terms = terms(x, among);
    terms.extend(self::terms(y, among));
    at_least(3, &terms)
}

/// The terms, if there are enough of them for a sum.
fn at_least(count: usize, terms: &[Expression]) -> Vec<Value> {
    if terms.len() < count {
        return Vec::new();
    }
    Value::all(terms)
}

fn terms(value: &Expression, among: &[&Step<Expression>]) -> Vec<Expression> {
    let definition = |wanted: Symbol| {
        among.iter().find_map(|step| match step {
            Step::Define { symbol, value } if *symbol == wanted => Some(value),
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
