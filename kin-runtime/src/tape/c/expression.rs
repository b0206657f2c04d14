//! The numbers and functions of C.

use std::format;
use std::string::{String, ToString as _};

use crate::tape::expression::{Binding, Code};
use crate::tape::{Constant, NumberType};

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
