//! Expressions of C, with parentheses where their meaning needs them.

use std::format;
use std::string::{String, ToString as _};

use crate::tape::{Comparison, Constant, Function, Operator, Precision};

/// How tightly an operator of C binds, from the loosest to the tightest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::tape) enum Binding {
    Conditional,
    Or,
    And,
    Equality,
    Relation,
    Sum,
    Product,
    Sign,
    Whole,
}

/// A piece of C with the binding of its outermost operator.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::tape) struct Expression {
    pub(in crate::tape) text: String,
    binding: Binding,
}

impl Expression {
    /// A name, a call, or something in brackets.
    pub(in crate::tape) fn whole(text: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            binding: Binding::Whole,
        }
    }

    /// A number that is read as the same number.
    pub(in crate::tape) fn constant(constant: Constant, precision: Precision) -> Self {
        let value = constant.value();
        let size = value.abs();
        let text = if value.is_nan() {
            // `NAN` alone is a `float`.
            return match precision {
                Precision::Single => Self::whole("NAN"),
                Precision::Double => Self::of(Binding::Sign, "(double)NAN".to_string()),
            };
        } else if size.is_infinite() {
            match precision {
                Precision::Single => "HUGE_VALF".to_string(),
                Precision::Double => "HUGE_VAL".to_string(),
            }
        } else {
            number(size, precision)
        };
        if value.is_sign_negative() {
            Self {
                text: format!("-{text}"),
                binding: Binding::Sign,
            }
        } else {
            Self::whole(text)
        }
    }

    /// The text as an operand that must bind at least as tightly.
    fn within(&self, least: Binding) -> String {
        if self.binding >= least {
            self.text.clone()
        } else {
            format!("({})", self.text)
        }
    }

    fn of(binding: Binding, text: String) -> Self {
        Self { text, binding }
    }

    pub(in crate::tape) fn sum(&self, sign: char, other: &Self) -> Self {
        // Sums and products are carried out from left to right, and may not be carried out otherwise.
        let text = format!(
            "{} {sign} {}",
            self.within(Binding::Sum),
            other.within(Binding::Product)
        );
        Self::of(Binding::Sum, text)
    }

    pub(in crate::tape) fn product(&self, sign: char, other: &Self) -> Self {
        let text = format!(
            "{} {sign} {}",
            self.within(Binding::Product),
            other.within(Binding::Sign)
        );
        Self::of(Binding::Product, text)
    }

    pub(in crate::tape) fn negated(&self) -> Self {
        // Two signs would be a decrement.
        Self::of(Binding::Sign, format!("-{}", self.within(Binding::Whole)))
    }

    pub(in crate::tape) fn call(function: &str, arguments: &[&Self]) -> Self {
        let arguments: std::vec::Vec<&str> = arguments.iter().map(|own| own.text.as_str()).collect();
        Self::whole(format!("{function}({})", arguments.join(", ")))
    }

    pub(in crate::tape) fn compared(&self, comparison: Comparison, other: &Self) -> Self {
        let (sign, binding) = match comparison {
            Comparison::AtLeast => (">=", Binding::Relation),
            Comparison::Exceeds => (">", Binding::Relation),
            Comparison::Equals => ("==", Binding::Equality),
        };
        // Compilers warn of comparisons of comparisons, which never occur.
        let text = format!("{} {sign} {}", self.within(Binding::Sum), other.within(Binding::Sum));
        Self::of(binding, text)
    }

    pub(in crate::tape) fn both(&self, other: &Self) -> Self {
        let text = format!(
            "{} && {}",
            self.within(Binding::Equality),
            other.within(Binding::Equality)
        );
        Self::of(Binding::And, text)
    }

    pub(in crate::tape) fn either(&self, other: &Self) -> Self {
        // Compilers warn of `&&` inside of `||` without parentheses.
        let text = format!(
            "{} || {}",
            self.within(Binding::Equality),
            other.within(Binding::Equality)
        );
        Self::of(Binding::Or, text)
    }

    pub(in crate::tape) fn not(&self) -> Self {
        Self::of(Binding::Sign, format!("!{}", self.within(Binding::Whole)))
    }

    pub(in crate::tape) fn select(&self, one: &Self, other: &Self) -> Self {
        let [truth, one, other] = [self, one, other].map(|own| own.within(Binding::Or));
        Self::of(Binding::Conditional, format!("{truth} ? {one} : {other}"))
    }

    /// An operation on two numbers.
    pub(in crate::tape) fn binary(&self, operator: Operator, other: &Self) -> Self {
        match operator {
            Operator::Add => self.sum('+', other),
            Operator::Subtract => self.sum('-', other),
            Operator::Multiply => self.product('*', other),
            Operator::Divide => self.product('/', other),
            Operator::ArcTangent => Self::call("kin_atan2", &[self, other]),
        }
    }

    /// A function of `<math.h>`. Sine and cosine are found together, and elsewhere.
    pub(in crate::tape) fn called(&self, function: Function, precision: Precision) -> Self {
        let name = match function {
            Function::Negate => return self.negated(),
            Function::Magnitude => "fabs",
            Function::SquareRoot => "sqrt",
            Function::Sine => "sin",
            Function::Cosine => "cos",
            Function::ArcSine => "asin",
            Function::ArcCosine => "acos",
            Function::ArcTangent => "atan",
            Function::HyperbolicSine => "sinh",
            Function::HyperbolicCosine => "cosh",
            Function::HyperbolicTangent => "tanh",
            Function::AreaHyperbolicSine => "asinh",
            Function::AreaHyperbolicCosine => "acosh",
            Function::AreaHyperbolicTangent => "atanh",
            Function::Exponential => "exp",
            Function::Logarithm => "log",
            Function::Round => "round",
            Function::Raise => "ceil",
        };
        match precision {
            Precision::Single => Self::call(&format!("{name}f"), &[self]),
            Precision::Double => Self::call(name, &[self]),
        }
    }
}

/// A number that is zero or positive, and finite.
#[expect(
    clippy::cast_possible_truncation,
    reason = "constants of a tape in single precision have that precision"
)]
fn number(value: f64, precision: Precision) -> String {
    match precision {
        Precision::Single => format!("{:?}f", value as f32),
        Precision::Double => format!("{value:?}"),
    }
}

#[cfg(test)]
mod tests {
    use super::Expression;
    use crate::tape::{Comparison, Constant, Precision};

    fn name(own: &str) -> Expression {
        Expression::whole(own)
    }

    #[test]
    fn parentheses_stand_where_the_order_needs_them() {
        let [a, b, c] = ["a", "b", "c"].map(name);
        let minus = |value: f64| Expression::constant(Constant::new(value), Precision::Double);
        let cases = [
            (a.sum('-', &b.sum('-', &c)), "a - (b - c)"),
            (a.sum('-', &b).sum('-', &c), "a - b - c"),
            (a.sum('+', &b.sum('+', &c)), "a + (b + c)"),
            (a.sum('+', &b.product('*', &c)), "a + b * c"),
            (a.sum('+', &b).product('*', &c), "(a + b) * c"),
            (a.product('*', &b.product('*', &c)), "a * (b * c)"),
            (a.product('/', &b.product('/', &c)), "a / (b / c)"),
            (a.product('/', &b).product('*', &c), "a / b * c"),
            (a.negated().negated(), "-(-a)"),
            (a.sum('-', &b.negated()), "a - -b"),
            (a.sum('+', &b).negated(), "-(a + b)"),
            (a.product('*', &minus(-2.0)), "a * -2.0"),
            (minus(-0.0).negated(), "-(-0.0)"),
            (a.compared(Comparison::AtLeast, &b.sum('+', &c)), "a >= b + c"),
            (a.compared(Comparison::Equals, &b).not(), "!(a == b)"),
            (
                a.compared(Comparison::Exceeds, &b)
                    .both(&b.compared(Comparison::Exceeds, &c)),
                "a > b && b > c",
            ),
            (a.both(&b).either(&c), "(a && b) || c"),
            (a.both(&b).both(&c), "(a && b) && c"),
            (a.select(&b, &c).sum('+', &a), "(a ? b : c) + a"),
            (a.select(&b.select(&a, &c), &c), "a ? (b ? a : c) : c"),
            (Expression::call("f", &[&a.sum('+', &b), &c]), "f(a + b, c)"),
        ];
        for (own, expected) in cases {
            assert_eq!(own.text, expected);
        }
    }

    #[test]
    fn numbers_are_read_as_the_same_numbers() {
        let double = |value: f64| Expression::constant(Constant::new(value), Precision::Double).text;
        for value in [0.1, 1e300, 5e-324, f64::MAX, 1.0, 3.0e-7, -0.0, -2.5] {
            assert_eq!(double(value).parse::<f64>().unwrap().to_bits(), value.to_bits());
        }
        assert_eq!(double(f64::NEG_INFINITY), "-HUGE_VAL");
        assert_eq!(double(f64::NAN), "(double)NAN");
        let single = Expression::constant(Constant::new(f64::from(0.1_f32)), Precision::Single).text;
        assert_eq!(single, "0.1f");
    }
}
