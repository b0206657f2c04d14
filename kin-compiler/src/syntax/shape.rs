//! The shapes of formulas without mistakes.

use crate::syntax::{Callee, FormulaKind, TypedFormula, ValueShape};

/// The shape of a formula without mistakes; `known` gives the shapes of the names.
pub(crate) fn shape(formula: &TypedFormula, known: &dyn Fn(&str) -> Option<ValueShape>) -> ValueShape {
    match &formula.kind {
        FormulaKind::Number { .. }
        | FormulaKind::Degrees { .. }
        | FormulaKind::Pi
        | FormulaKind::Power { .. }
        | FormulaKind::Part { .. } => ValueShape::Scalar,
        FormulaKind::Name(name) => known(&name.to_string()).unwrap_or(ValueShape::Scalar),
        FormulaKind::Negate(of) | FormulaKind::Parenthesis(of) => shape(of, known),
        FormulaKind::Sum { first, rest } | FormulaKind::Product { first, rest } => {
            let others = rest.iter().map(|operand| shape(&operand.formula, known));
            others.fold(shape(first, known), |left, right| match (left, right) {
                (ValueShape::Scalar, other) => other,
                // a rotation rotates the vector behind it
                (ValueShape::Rotation, ValueShape::Space) => ValueShape::Space,
                (shape, _) => shape,
            })
        }
        FormulaKind::Call { callee, arguments, .. } => match callee {
            Callee::Cis | Callee::Polar | Callee::Vec2 => ValueShape::Plane,
            Callee::Vec3 => ValueShape::Space,
            Callee::RotX | Callee::RotY | Callee::RotZ | Callee::Rot => ValueShape::Rotation,
            Callee::Cross => match arguments.first().map(|first| shape(first, known)) {
                Some(ValueShape::Space) => ValueShape::Space,
                _ => ValueShape::Scalar,
            },
            Callee::Elementary(_) | Callee::Dot | Callee::Norm => ValueShape::Scalar,
        },
    }
}
