//! Values with every operation chosen.

use crate::algebra::Symbol;
use crate::program::Expression;

/// The right side of an assignment. Operands are evaluated from left to right, as they stand here.
#[derive(Clone, PartialEq, Debug)]
pub enum Value {
    /// A value that is known.
    Symbol(Symbol),
    /// A constant.
    Constant(f64),
    /// The constant π.
    Pi,
    /// a + b
    Add(Box<Self>, Box<Self>),
    /// a - b
    Subtract(Box<Self>, Box<Self>),
    /// a * b
    Multiply(Box<Self>, Box<Self>),
    /// a / b
    Divide(Box<Self>, Box<Self>),
    /// -a
    Negate(Box<Self>),
    /// a + b * c, which machines with a fused operation round once.
    PlusProduct(Box<Self>, Box<Self>, Box<Self>),
    /// a - b * c, likewise.
    MinusProduct(Box<Self>, Box<Self>, Box<Self>),
    /// A method of the number type, by its name.
    Call(&'static str, Vec<Self>),
}

impl Value {
    /// The value of an expression. A sum or difference with a product is a fused operation.
    pub(crate) fn of(expression: &Expression) -> Self {
        let boxed = |of: &Expression| Box::new(Self::of(of));
        let product = |of: &Expression| match of {
            Expression::Multiply(a, b) => Some((boxed(a), boxed(b))),
            _ => None,
        };
        match expression {
            Expression::Name(symbol) => Self::Symbol(*symbol),
            Expression::Number(value) => Self::Constant(*value),
            Expression::Pi => Self::Pi,
            Expression::Subtract(rest, by) => match product(by) {
                Some((a, b)) => Self::MinusProduct(boxed(rest), a, b),
                None => Self::Subtract(boxed(rest), boxed(by)),
            },
            Expression::Add(first, second) => {
                let last = product(second).map(|(a, b)| Self::PlusProduct(boxed(first), a, b));
                last.or_else(|| product(first).map(|(a, b)| Self::PlusProduct(boxed(second), a, b)))
                    .unwrap_or_else(|| Self::Add(boxed(first), boxed(second)))
            }
            Expression::Multiply(a, b) => Self::Multiply(boxed(a), boxed(b)),
            Expression::Divide(a, b) => Self::Divide(boxed(a), boxed(b)),
            Expression::Negate(a) => Self::Negate(boxed(a)),
            Expression::Call(function, arguments) => Self::Call(function.name(), Self::all(arguments)),
        }
    }

    /// The values of some expressions.
    pub(crate) fn all(expressions: &[Expression]) -> Vec<Self> {
        expressions.iter().map(Self::of).collect()
    }
}
