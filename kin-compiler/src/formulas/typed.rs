//! Formulas of the declaration, as typed, in the notation of the field.

use super::names::{NotationNames, component};
use super::term::Notation;
use crate::algebra::Function;
use crate::syntax::{ArithmeticOperator, Callee, FormulaKind, TypedFormula};

/// The largest number of symbols of a formula that is printed.
const LARGEST: usize = 400;

/// A formula; dots if it is too long to be read.
pub(super) fn term(names: &NotationNames, formula: &TypedFormula) -> Notation {
    let term = convert(names, formula);
    if term.size(LARGEST) > LARGEST {
        Notation::Dots
    } else {
        term
    }
}

fn convert(names: &NotationNames, formula: &TypedFormula) -> Notation {
    match &formula.kind {
        FormulaKind::Number { value, .. } => Notation::Number(*value),
        FormulaKind::Degrees { value, .. } => Notation::Degrees(*value),
        FormulaKind::Pi => Notation::Pi,
        FormulaKind::Name(name) => names
            .of(&name.to_string())
            .map_or(Notation::Dots, |(name, _)| Notation::Name(name.clone())),
        FormulaKind::Negate(of) => convert(names, of).negative(),
        FormulaKind::Parenthesis(inner) => convert(names, inner),
        FormulaKind::Sum { first, rest } => {
            let rest = rest.iter().map(|operand| {
                let term = convert(names, &operand.formula);
                match operand.operator {
                    ArithmeticOperator::Subtract => term.negative(),
                    _ => term,
                }
            });
            Notation::sum([convert(names, first)].into_iter().chain(rest))
        }
        FormulaKind::Product { first, rest } => {
            let mut done = convert(names, first);
            let mut factors = Vec::new();
            for operand in rest {
                let term = convert(names, &operand.formula);
                if operand.operator == ArithmeticOperator::Divide {
                    done = Notation::product([done].into_iter().chain(factors.drain(..))).over(term);
                } else {
                    factors.push(term);
                }
            }
            Notation::product([done].into_iter().chain(factors))
        }
        FormulaKind::Power { base, exponent, .. } => convert(names, base).power(*exponent),
        FormulaKind::Part { of, axis } => {
            if let FormulaKind::Name(name) = &of.kind
                && let Some((name, _)) = names.of(&name.to_string())
            {
                return Notation::Name(component(name.clone(), *axis));
            }
            // the part of a formula is its product with the unit vector of the axis
            let unit = component(names.fresh('e'), *axis).marked_as_vector(true);
            Notation::Dot(Box::new(convert(names, of)), Box::new(Notation::Name(unit)))
        }
        FormulaKind::Call { callee, arguments, .. } => {
            let terms = arguments.iter().map(|argument| convert(names, argument)).collect();
            call(*callee, terms)
        }
    }
}

fn call(callee: Callee, mut terms: Vec<Notation>) -> Notation {
    match (callee, terms.as_mut_slice()) {
        (Callee::Elementary(function), _) => elementary(function, terms),
        (Callee::Cis, [angle]) => Notation::direction(angle.clone()),
        (Callee::Polar, [length, angle]) => Notation::product([length.clone(), Notation::direction(angle.clone())]),
        (Callee::Vec2, [x, y]) => complex(x.clone(), y.clone()),
        (Callee::Dot, [left, right]) => Notation::Dot(Box::new(left.clone()), Box::new(right.clone())),
        (Callee::Cross, [left, right]) => Notation::Cross(Box::new(left.clone()), Box::new(right.clone())),
        (Callee::Norm, [of]) => of.clone().norm(),
        (Callee::RotX, _) => Notation::Call("Rot_x", terms),
        (Callee::RotY, _) => Notation::Call("Rot_y", terms),
        (Callee::RotZ, _) => Notation::Call("Rot_z", terms),
        (Callee::Rot, _) => Notation::Call("Rot", terms),
        _ => Notation::Tuple(terms),
    }
}

/// x + i y
pub(super) fn complex(x: Notation, y: Notation) -> Notation {
    let imaginary = match y {
        Notation::Number(0.0) => Notation::Number(0.0),
        y => Notation::product([Notation::Imaginary, y]),
    };
    Notation::sum([x, imaginary])
}

/// A call of an elementary function.
pub(super) fn elementary(function: Function, mut arguments: Vec<Notation>) -> Notation {
    if function == Function::Sqrt && arguments.len() == 1 {
        return arguments.remove(0).root();
    }
    Notation::Call(function.notation(), arguments)
}
