//! Values to Rust, with only the parentheses that are needed.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::ProgramText;
use crate::emit::compiled::local;
use crate::lower::Value;
use crate::precedence::Precedence;

fn precedence(value: &Value) -> Precedence {
    match value {
        Value::Add(..) | Value::Subtract(..) => Precedence::Sum,
        Value::Multiply(..) | Value::Divide(..) => Precedence::Product,
        Value::Negate(_) => Precedence::Sign,
        _ => Precedence::Atom,
    }
}

impl ProgramText<'_> {
    /// Values in the number type `T`.
    pub(super) fn values(&self, values: &[Value]) -> Vec<TokenStream> {
        values.iter().map(|value| self.value(value)).collect()
    }

    /// A value in the number type `T`.
    pub(super) fn value(&self, value: &Value) -> TokenStream {
        match value {
            Value::Symbol(symbol) => {
                let name = self.name(*symbol);
                quote!(#name)
            }
            Value::Constant(value) if *value < 0.0 => {
                let value = Literal::f64_unsuffixed(-value);
                quote!(T::constant(-#value))
            }
            Value::Constant(value) => {
                let value = Literal::f64_unsuffixed(*value);
                quote!(T::constant(#value))
            }
            Value::Pi => quote!(T::constant(::core::f64::consts::PI)),
            Value::Add(a, b) => self.binary(a, &quote!(+), b, Precedence::Sum, Precedence::Product),
            Value::Subtract(a, b) => self.binary(a, &quote!(-), b, Precedence::Sum, Precedence::Product),
            Value::Multiply(a, b) => self.binary(a, &quote!(*), b, Precedence::Product, Precedence::Sign),
            Value::Divide(a, b) => self.binary(a, &quote!(/), b, Precedence::Product, Precedence::Sign),
            Value::Negate(a) => {
                let a = self.within(a, Precedence::Atom);
                quote!(-#a)
            }
            Value::PlusProduct(rest, a, b) => self.method("plus_product", rest, [&**a, b]),
            Value::MinusProduct(rest, a, b) => self.method("minus_product", rest, [&**a, b]),
            Value::Call(function, arguments) => {
                let (first, others) = arguments.split_first().expect("functions have arguments");
                if self.goes_through_all {
                    let (function, arguments) = (self.function(function), self.values(arguments));
                    return quote!(#function(#(#arguments),*));
                }
                self.method(function, first, others)
            }
        }
    }

    /// A function of the number type `T`. In double precision a type itself has functions of the same names, with other
    /// rounding errors.
    pub(super) fn function(&self, name: &str) -> TokenStream {
        let (runtime, name) = (self.mechanism.runtime, local(name));
        if self.goes_through_all {
            quote!(#runtime::Number::#name)
        } else {
            quote!(T::#name)
        }
    }

    fn method<'v>(&self, name: &str, first: &Value, others: impl IntoIterator<Item = &'v Value>) -> TokenStream {
        let (method, first) = (local(name), self.within(first, Precedence::Atom));
        let others = others.into_iter().map(|value| self.value(value));
        quote!(#first.#method(#(#others),*))
    }

    fn binary(&self, a: &Value, operator: &TokenStream, b: &Value, left: Precedence, right: Precedence) -> TokenStream {
        let (a, b) = (self.within(a, left), self.within(b, right));
        quote!(#a #operator #b)
    }

    /// A value, in parentheses if its operator binds less tightly than the expression around it requires.
    fn within(&self, value: &Value, outside: Precedence) -> TokenStream {
        let inner = self.value(value);
        if precedence(value).needs_parentheses(outside) {
            quote!((#inner))
        } else {
            inner
        }
    }
}
