//! Expressions to Rust, with only the parentheses that are needed.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::ProgramText;
use crate::emit::compiled::local;
use crate::precedence::Precedence;
use crate::program::Expression;

fn precedence(expression: &Expression) -> Precedence {
    match expression {
        _ if sum_with_product(expression).is_some() => Precedence::Atom,
        Expression::Add(..) | Expression::Subtract(..) => Precedence::Sum,
        Expression::Multiply(..) | Expression::Divide(..) => Precedence::Product,
        Expression::Negate(_) => Precedence::Sign,
        _ => Precedence::Atom,
    }
}

/// A sum or difference with a product: the other term, the method, and the two factors. This saves a rounding on
/// machines with a fused operation.
fn sum_with_product<'a>(
    expression: &'a Expression,
) -> Option<(&'a Expression, &'static str, &'a Expression, &'a Expression)> {
    let factors = |expression: &'a Expression| match expression {
        Expression::Multiply(a, b) => Some((&**a, &**b)),
        _ => None,
    };
    match expression {
        Expression::Subtract(rest, product) => factors(product).map(|(a, b)| (&**rest, "minus_product", a, b)),
        Expression::Add(one, other) => {
            let last = factors(other).map(|(a, b)| (&**one, "plus_product", a, b));
            last.or_else(|| factors(one).map(|(a, b)| (&**other, "plus_product", a, b)))
        }
        _ => None,
    }
}

impl ProgramText<'_> {
    /// Expressions in the number type `T`.
    pub(super) fn expressions(&self, expressions: &[Expression]) -> Vec<TokenStream> {
        expressions
            .iter()
            .map(|expression| self.expression(expression))
            .collect()
    }

    /// An expression in the number type `T`.
    pub(super) fn expression(&self, expression: &Expression) -> TokenStream {
        if let Some((rest, method, a, b)) = sum_with_product(expression) {
            let (rest, method) = (self.within(rest, Precedence::Atom), local(method));
            let (a, b) = (self.expression(a), self.expression(b));
            return quote!(#rest.#method(#a, #b));
        }
        match expression {
            Expression::Name(symbol) => {
                let name = self.name(*symbol);
                quote!(#name)
            }
            Expression::Number(value) if *value < 0.0 => {
                let value = Literal::f64_unsuffixed(-value);
                quote!(T::constant(-#value))
            }
            Expression::Number(value) => {
                let value = Literal::f64_unsuffixed(*value);
                quote!(T::constant(#value))
            }
            Expression::Pi => quote!(T::constant(::core::f64::consts::PI)),
            Expression::Add(a, b) => self.binary(a, &quote!(+), b, Precedence::Sum, Precedence::Product),
            Expression::Subtract(a, b) => self.binary(a, &quote!(-), b, Precedence::Sum, Precedence::Product),
            Expression::Multiply(a, b) => self.binary(a, &quote!(*), b, Precedence::Product, Precedence::Sign),
            Expression::Divide(a, b) => self.binary(a, &quote!(/), b, Precedence::Product, Precedence::Sign),
            Expression::Negate(a) => {
                let a = self.within(a, Precedence::Atom);
                quote!(-#a)
            }
            Expression::Call(function, arguments) => {
                let method = local(function.name());
                let (first, others) = arguments.split_first().expect("functions have arguments");
                let first = self.within(first, Precedence::Atom);
                let others = self.expressions(others);
                quote!(#first.#method(#(#others),*))
            }
        }
    }

    fn binary(
        &self,
        a: &Expression,
        operator: &TokenStream,
        b: &Expression,
        left: Precedence,
        right: Precedence,
    ) -> TokenStream {
        let (a, b) = (self.within(a, left), self.within(b, right));
        quote!(#a #operator #b)
    }

    /// An expression, in parentheses if its operator binds less tightly than its place requires.
    fn within(&self, expression: &Expression, place: Precedence) -> TokenStream {
        let inner = self.expression(expression);
        if precedence(expression).needs_parentheses(place) {
            quote!((#inner))
        } else {
            inner
        }
    }
}
