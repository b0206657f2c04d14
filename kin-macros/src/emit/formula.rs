//! Expressions to Rust, with parentheses where they are needed and nowhere else.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::local;
use crate::schedule::Expression;

/// How tightly an expression holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Atom,
}

const fn binding(expression: &Expression) -> Binding {
    match expression {
        Expression::Add(..) | Expression::Subtract(..) => Binding::Sum,
        Expression::Multiply(..) | Expression::Divide(..) => Binding::Product,
        Expression::Negate(_) => Binding::Sign,
        _ => Binding::Atom,
    }
}

/// An expression in the number type `T`.
pub(super) fn tokens(expression: &Expression) -> TokenStream {
    match expression {
        Expression::Name(name) => {
            let name = local(name);
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
        Expression::Add(a, b) => binary(a, &quote!(+), b, Binding::Sum, Binding::Product),
        Expression::Subtract(a, b) => binary(a, &quote!(-), b, Binding::Sum, Binding::Product),
        Expression::Multiply(a, b) => binary(a, &quote!(*), b, Binding::Product, Binding::Sign),
        Expression::Divide(a, b) => binary(a, &quote!(/), b, Binding::Product, Binding::Sign),
        Expression::Negate(a) => {
            let a = within(a, Binding::Atom);
            quote!(-#a)
        }
        Expression::Call(function, arguments) => {
            let method = local(function.name());
            let (first, others) = arguments.split_first().expect("functions have arguments");
            let first = within(first, Binding::Atom);
            let others = others.iter().map(tokens);
            quote!(#first.#method(#(#others),*))
        }
    }
}

fn binary(a: &Expression, operator: &TokenStream, b: &Expression, left: Binding, right: Binding) -> TokenStream {
    let (a, b) = (within(a, left), within(b, right));
    quote!(#a #operator #b)
}

/// In parentheses if it holds together less tightly than its place requires.
fn within(expression: &Expression, place: Binding) -> TokenStream {
    let inner = tokens(expression);
    if binding(expression) < place {
        quote!((#inner))
    } else {
        inner
    }
}
