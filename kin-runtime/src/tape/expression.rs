//! Expressions of other languages, with parentheses where their meaning needs them. The operators bind as those of C.

use std::format;
use std::string::String;

/// How tightly an operator binds, from the loosest to the tightest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Binding {
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

/// A piece of code with the binding of its outermost operator.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Code {
    pub(super) text: String,
    binding: Binding,
}

impl Code {
    /// A name, a call, or something in brackets.
    pub(super) fn whole(text: impl Into<String>) -> Self {
        Self {
            text: text.into(),
            binding: Binding::Whole,
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

    /// A text whose outermost operator binds so tightly.
    pub(super) fn of(binding: Binding, text: String) -> Self {
        Self { text, binding }
    }

    /// Two operands and the operator between them, with the least binding of each.
    fn infix(&self, binding: Binding, sign: &str, other: &Self, [left, right]: [Binding; 2]) -> Self {
        Self::of(binding, format!("{} {sign} {}", self.within(left), other.within(right)))
    }

    pub(super) fn sum(&self, sign: &str, other: &Self) -> Self {
        // Sums and products are carried out from left to right, and may not be carried out otherwise.
        self.infix(Binding::Sum, sign, other, [Binding::Sum, Binding::Product])
    }

    pub(super) fn product(&self, sign: &str, other: &Self) -> Self {
        self.infix(Binding::Product, sign, other, [Binding::Product, Binding::Sign])
    }

    pub(super) fn negated(&self) -> Self {
        // Two signs would be a decrement.
        Self::of(Binding::Sign, format!("-{}", self.within(Binding::Whole)))
    }

    pub(super) fn call(function: &str, arguments: &[Self]) -> Self {
        let arguments: std::vec::Vec<&str> = arguments.iter().map(|argument| argument.text.as_str()).collect();
        Self::whole(format!("{function}({})", arguments.join(", ")))
    }

    pub(super) fn compared(&self, sign: &str, other: &Self) -> Self {
        let binding = if sign == "==" {
            Binding::Equality
        } else {
            Binding::Relation
        };
        // Compilers warn of comparisons of comparisons, which never occur.
        self.infix(binding, sign, other, [Binding::Sum; 2])
    }

    pub(super) fn both(&self, other: &Self) -> Self {
        self.infix(Binding::And, "&&", other, [Binding::Equality; 2])
    }

    pub(super) fn either(&self, other: &Self) -> Self {
        // Compilers warn of `&&` inside of `||` without parentheses.
        self.infix(Binding::Or, "||", other, [Binding::Equality; 2])
    }

    pub(super) fn not(&self) -> Self {
        Self::of(Binding::Sign, format!("!{}", self.within(Binding::Whole)))
    }

    pub(super) fn select(&self, one: &Self, other: &Self) -> Self {
        let [truth, one, other] = [self, one, other].map(|operand| operand.within(Binding::Or));
        Self::of(Binding::Conditional, format!("{truth} ? {one} : {other}"))
    }
}

#[cfg(test)]
mod tests {
    use super::Code;
    use crate::tape::{Constant, NumberType};

    fn name(name: &str) -> Code {
        Code::whole(name)
    }

    #[test]
    fn parentheses_stand_where_the_order_needs_them() {
        let [a, b, c] = ["a", "b", "c"].map(name);
        let minus = |value: f64| Code::constant(Constant::new(value), NumberType::Double);
        let cases = [
            (a.sum("-", &b.sum("-", &c)), "a - (b - c)"),
            (a.sum("-", &b).sum("-", &c), "a - b - c"),
            (a.sum("+", &b.sum("+", &c)), "a + (b + c)"),
            (a.sum("+", &b.product("*", &c)), "a + b * c"),
            (a.sum("+", &b).product("*", &c), "(a + b) * c"),
            (a.product("*", &b.product("*", &c)), "a * (b * c)"),
            (a.product("/", &b.product("/", &c)), "a / (b / c)"),
            (a.product("/", &b).product("*", &c), "a / b * c"),
            (a.negated().negated(), "-(-a)"),
            (a.sum("-", &b.negated()), "a - -b"),
            (a.sum("+", &b).negated(), "-(a + b)"),
            (a.product("*", &minus(-2.0)), "a * -2.0"),
            (minus(-0.0).negated(), "-(-0.0)"),
            (a.compared(">=", &b.sum("+", &c)), "a >= b + c"),
            (a.compared("==", &b).not(), "!(a == b)"),
            (a.compared(">", &b).both(&b.compared(">", &c)), "a > b && b > c"),
            (a.both(&b).either(&c), "(a && b) || c"),
            (a.both(&b).both(&c), "(a && b) && c"),
            (a.select(&b, &c).sum("+", &a), "(a ? b : c) + a"),
            (a.select(&b.select(&a, &c), &c), "a ? (b ? a : c) : c"),
            (Code::call("f", &[a.sum("+", &b), c]), "f(a + b, c)"),
        ];
        for (code, expected) in cases {
            assert_eq!(code.text, expected);
        }
    }

    #[test]
    fn numbers_are_read_as_the_same_numbers() {
        let double = |value: f64| Code::constant(Constant::new(value), NumberType::Double).text;
        for value in [0.1, 1e300, 5e-324, f64::MAX, 1.0, 3.0e-7, -0.0, -2.5] {
            assert_eq!(double(value).parse::<f64>().unwrap().to_bits(), value.to_bits());
        }
        assert_eq!(double(f64::NEG_INFINITY), "-HUGE_VAL");
        assert_eq!(double(f64::NAN), "(double)NAN");
        let single = Code::constant(Constant::new(f64::from(0.1_f32)), NumberType::Single).text;
        assert_eq!(single, "0.1f");
    }
}
