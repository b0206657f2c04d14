//! Formulas as text, with the parentheses that they need.

use std::fmt::{self, Display, Formatter};

/// How tightly the last operation of a formula binds, the loosest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Operand,
}

/// A formula that can be combined with others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Formula {
    text: String,
    binding: Binding,
}

impl Formula {
    /// A name, a number, or whatever else stands by itself.
    pub(crate) fn operand(text: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            binding: Binding::Operand,
        }
    }

    /// `function(arguments)`
    pub(crate) fn call(function: &str, arguments: &[Self]) -> Self {
        let arguments: Vec<&str> = arguments.iter().map(|argument| argument.text.as_str()).collect();
        Self::operand(format!("{function}({})", arguments.join(", ")))
    }

    /// `first.function(others)`
    pub(crate) fn method(function: &str, arguments: &[Self]) -> Self {
        let (first, others) = arguments.split_first().expect("a method has a receiver");
        let others: Vec<&str> = others.iter().map(|argument| argument.text.as_str()).collect();
        Self::operand(format!(
            "{}.{function}({})",
            first.bound(Binding::Operand),
            others.join(", ")
        ))
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        Self {
            text: format!("{self} + {}", other.bound(Binding::Product)),
            binding: Binding::Sum,
        }
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        Self {
            text: format!("{self} - {}", other.bound(Binding::Product)),
            binding: Binding::Sum,
        }
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        Self {
            text: format!("{} * {}", self.bound(Binding::Product), other.bound(Binding::Sign)),
            binding: Binding::Product,
        }
    }

    pub(crate) fn over(&self, other: &Self) -> Self {
        Self {
            text: format!("{} / {}", self.bound(Binding::Product), other.bound(Binding::Sign)),
            binding: Binding::Product,
        }
    }

    pub(crate) fn negated(&self) -> Self {
        Self {
            text: format!("-{}", self.bound(Binding::Sign)),
            binding: Binding::Sign,
        }
    }

    /// `self.x`
    pub(crate) fn part(&self, axis: &str) -> Self {
        Self::operand(format!("{}.{axis}", self.bound(Binding::Operand)))
    }

    /// Whether it is made of numbers alone.
    pub(crate) fn is_constant(&self) -> bool {
        let is_of_word = |letter: char| letter.is_alphanumeric() || letter == '_';
        let mut words = self
            .text
            .split(|letter| !is_of_word(letter))
            .filter(|word| !word.is_empty());
        words.all(|word| word == "PI" || word.starts_with(|letter: char| letter.is_ascii_digit()))
    }

    pub(crate) fn in_parentheses(&self) -> Self {
        Self::operand(format!("({self})"))
    }

    /// In parentheses if it binds more loosely.
    fn bound(&self, least: Binding) -> String {
        if self.binding < least {
            format!("({})", self.text)
        } else {
            self.text.clone()
        }
    }
}

impl Display for Formula {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

#[cfg(test)]
mod tests {
    use super::Formula;

    #[test]
    fn numbers_are_constant_and_names_are_not() {
        for text in ["2f64", "-1E0 / 0.1_5", "25e-2 * (PI - 3.0f64)"] {
            assert!(Formula::operand(text).is_constant(), "{text}");
        }
        for text in ["a1", "cos(2)", "2 * _a", "PI2"] {
            assert!(!Formula::operand(text).is_constant(), "{text}");
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
