//! The numbers and functions of C.

use std::format;
use std::string::{String, ToString as _};

use crate::tape::expression::{Binding, Code};
use crate::tape::{Constant, Function, NumberType, Operator};

impl Code {
    /// A number that is read as the same number.
    pub(in crate::tape) fn constant(constant: Constant, precision: NumberType) -> Self {
        let value = constant.value();
        let size = value.abs();
        let text = if value.is_nan() {
            // `NAN` alone is a `float`.
            return match precision {
                NumberType::Single => Self::whole("NAN"),
                NumberType::Double => Self::of(Binding::Sign, "(double)NAN".to_string()),
            };
        } else if size.is_infinite() {
            match precision {
                NumberType::Single => "HUGE_VALF".to_string(),
                NumberType::Double => "HUGE_VAL".to_string(),
            }
        } else {
            number(size, precision)
        };
        if value.is_sign_negative() {
            Self::whole(text).negated()
        } else {
            Self::whole(text)
        }
    }

    /// An operation on two numbers.
    pub(in crate::tape) fn binary(&self, operator: Operator, other: &Self) -> Self {
        match operator {
            Operator::Add => self.sum("+", other),
            Operator::Subtract => self.sum("-", other),
            Operator::Multiply => self.product("*", other),
            Operator::Divide => self.product("/", other),
            Operator::ArcTangent => Self::call("kin_atan2", &[self, other]),
        }
    }

    /// A function of `<math.h>`. Sine and cosine are found together, and elsewhere.
    pub(in crate::tape) fn called(&self, function: Function, precision: NumberType) -> Self {
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
            NumberType::Single => Self::call(&format!("{name}f"), &[self]),
            NumberType::Double => Self::call(name, &[self]),
        }
    }
}

/// A number that is zero or positive, and finite.
#[expect(
    clippy::cast_possible_truncation,
    reason = "constants of a tape in single precision have that precision"
)]
fn number(value: f64, precision: NumberType) -> String {
    match precision {
        NumberType::Single => format!("{:?}f", value as f32),
        NumberType::Double => format!("{value:?}"),
    }
}
