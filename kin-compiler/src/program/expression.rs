//! Expressions, ready to be written.

use crate::algebra::{Function, Symbol};

/// The right side of a `let`.
#[derive(Clone, PartialEq, Debug)]
pub(crate) enum Expression {
    Name(Symbol),
    Number(f64),
    Pi,
    Add(Box<Self>, Box<Self>),
    Subtract(Box<Self>, Box<Self>),
    Multiply(Box<Self>, Box<Self>),
    Divide(Box<Self>, Box<Self>),
    Negate(Box<Self>),
    Call(Function, Vec<Self>),
}

impl Expression {
    /// Adds the symbols in the expression.
    pub(super) fn collect_symbols(&self, symbols: &mut Vec<Symbol>) {
        match self {
            Self::Name(symbol) => symbols.push(*symbol),
            Self::Number(_) | Self::Pi => {}
            Self::Add(a, b) | Self::Subtract(a, b) | Self::Multiply(a, b) | Self::Divide(a, b) => {
                a.collect_symbols(symbols);
                b.collect_symbols(symbols);
            }
            Self::Negate(a) => a.collect_symbols(symbols),
            Self::Call(_, arguments) => arguments.iter().for_each(|argument| argument.collect_symbols(symbols)),
        }
    }
}
