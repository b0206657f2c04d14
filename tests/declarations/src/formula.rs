//! Formulas, which are printed with the parentheses that they need.

use std::fmt::{self, Display, Formatter};

/// How tightly the last operation of a formula binds, the loosest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Operand,
}

/// An operation of two formulas.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operator {
    Plus,
    Minus,
    Times,
    Over,
}

/// A formula that can be combined with others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Formula {
    /// A name, a number, or `PI`.
    Operand(String),
    /// `function(arguments)`
    Call(&'static str, Vec<Self>),
    /// `first.function(others)`
    Method(&'static str, Vec<Self>),
    Binary(Operator, Box<[Self; 2]>),
    Negated(Box<Self>),
    /// A coordinate.
    Part(Box<Self>, &'static str),
    Parentheses(Box<Self>),
}

impl Formula {
    pub(crate) fn operand(text: impl Into<String>) -> Self {
        Self::Operand(text.into())
    }

    pub(crate) fn call(function: &'static str, arguments: &[Self]) -> Self {
        Self::Call(function, arguments.to_vec())
    }

    pub(crate) fn method(function: &'static str, arguments: &[Self]) -> Self {
        Self::Method(function, arguments.to_vec())
    }

    /// A call whose arguments are numbers.
    pub(crate) fn of_numbers(function: &'static str, numbers: &[&str]) -> Self {
        Self::Call(function, numbers.iter().copied().map(Self::operand).collect())
    }

    fn binary(&self, operator: Operator, other: &Self) -> Self {
        Self::Binary(operator, Box::new([self.clone(), other.clone()]))
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        self.binary(Operator::Plus, other)
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        self.binary(Operator::Minus, other)
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        self.binary(Operator::Times, other)
    }

    pub(crate) fn over(&self, other: &Self) -> Self {
        self.binary(Operator::Over, other)
    }

    pub(crate) fn negated(&self) -> Self {
        Self::Negated(Box::new(self.clone()))
    }

    pub(crate) fn part(&self, axis: &'static str) -> Self {
        Self::Part(Box::new(self.clone()), axis)
    }

    pub(crate) fn in_parentheses(&self) -> Self {
        Self::Parentheses(Box::new(self.clone()))
    }

    /// Whether it is made of numbers alone, without a function.
    pub(crate) fn is_constant(&self) -> bool {
        match self {
            Self::Operand(text) => text == "PI" || text.starts_with(|letter: char| letter.is_ascii_digit()),
            Self::Call(..) | Self::Method(..) | Self::Part(..) => false,
            Self::Binary(_, sides) => sides.iter().all(Self::is_constant),
            Self::Negated(inner) | Self::Parentheses(inner) => inner.is_constant(),
        }
    }

    const fn binding(&self) -> Binding {
        match self {
            Self::Binary(Operator::Plus | Operator::Minus, _) => Binding::Sum,
            Self::Binary(Operator::Times | Operator::Over, _) => Binding::Product,
            Self::Negated(_) => Binding::Sign,
            _ => Binding::Operand,
        }
    }

    /// In parentheses if it binds more loosely.
    fn write(&self, f: &mut Formatter<'_>, least: Binding) -> fmt::Result {
        if self.binding() < least {
            write!(f, "({self})")
        } else {
            write!(f, "{self}")
        }
    }
}

impl Display for Formula {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let listed = |f: &mut Formatter<'_>, arguments: &[Self]| {
            arguments.iter().enumerate().try_for_each(|(place, argument)| {
                let comma = if place == 0 { "" } else { ", " };
                write!(f, "{comma}{argument}")
            })
        };
        match self {
            Self::Operand(text) => f.write_str(text),
            Self::Call(function, arguments) => {
                write!(f, "{function}(")?;
                listed(f, arguments)?;
                f.write_str(")")
            }
            Self::Method(function, arguments) => {
                let (first, others) = arguments.split_first().expect("a method has a receiver");
                first.write(f, Binding::Operand)?;
                write!(f, ".{function}(")?;
                listed(f, others)?;
                f.write_str(")")
            }
            Self::Binary(operator, sides) => {
                let (sign, left, right) = match operator {
                    Operator::Plus => ("+", Binding::Sum, Binding::Product),
                    Operator::Minus => ("-", Binding::Sum, Binding::Product),
                    Operator::Times => ("*", Binding::Product, Binding::Sign),
                    Operator::Over => ("/", Binding::Product, Binding::Sign),
                };
                sides[0].write(f, left)?;
                write!(f, " {sign} ")?;
                sides[1].write(f, right)
            }
            Self::Negated(inner) => {
                f.write_str("-")?;
                inner.write(f, Binding::Sign)
            }
            Self::Part(whole, axis) => {
                whole.write(f, Binding::Operand)?;
                write!(f, ".{axis}")
            }
            Self::Parentheses(inner) => write!(f, "({inner})"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Formula;

    #[test]
    fn numbers_are_constant_and_names_are_not() {
        let [number, pi, name] = ["25e-2", "PI", "PI2"].map(Formula::operand);
        assert!(
            number
                .times(&pi.minus(&number).in_parentheses().negated())
                .is_constant()
        );
        for formula in [
            number.times(&name),
            number.part("x"),
            Formula::of_numbers("cos", &["2"]),
        ] {
            assert!(!formula.is_constant(), "{formula}");
        }
    }

    #[test]
    fn parentheses_stand_where_they_are_needed() {
        let [a, b, c] = ["a", "b", "c"].map(Formula::operand);
        let sum = a.plus(&b);
        assert_eq!(sum.times(&c).to_string(), "(a + b) * c");
        assert_eq!(c.minus(&sum).to_string(), "c - (a + b)");
        assert_eq!(sum.minus(&c).to_string(), "a + b - c");
        assert_eq!(c.over(&a.times(&b)).to_string(), "c / (a * b)");
        assert_eq!(a.times(&b).negated().to_string(), "-(a * b)");
        assert_eq!(a.negated().negated().times(&b).to_string(), "--a * b");
        assert_eq!(a.negated().part("x").to_string(), "(-a).x");
        assert_eq!(
            Formula::method("atan2", &[sum, c.negated()]).to_string(),
            "(a + b).atan2(-c)"
        );
    }
}
