//! Formulas of the declaration, as typed, in the notation of the field.

use super::names::{Names, component};
use super::term::Term;
use crate::algebra::Function;
use crate::model::Shape;
use crate::syntax::{Callee, Formula, FormulaKind, Operator};

/// The largest number of symbols of a formula that is printed.
const LARGEST: usize = 400;

/// A formula; dots if it is too long to be read.
pub(super) fn term(names: &Names, formula: &Formula) -> Term {
    let term = convert(names, formula);
    if term.size(LARGEST) > LARGEST { Term::Dots } else { term }
}

fn convert(names: &Names, formula: &Formula) -> Term {
    match &formula.kind {
        FormulaKind::Number { value, .. } => Term::Number(*value),
        FormulaKind::Degrees { value, .. } => Term::Degrees(*value),
        FormulaKind::Pi => Term::Pi,
        FormulaKind::Name(name) => names
            .of(&name.to_string())
            .map_or(Term::Dots, |(name, _)| Term::Name(name.clone())),
        FormulaKind::Negate(of) => convert(names, of).negative(),
        FormulaKind::Parenthesis(inner) => convert(names, inner),
        FormulaKind::Sum { first, rest } => {
            let rest = rest.iter().map(|operand| {
                let term = convert(names, &operand.formula);
                match operand.operator {
                    Operator::Subtract => term.negative(),
                    _ => term,
                }
            });
            Term::sum([convert(names, first)].into_iter().chain(rest))
        }
        FormulaKind::Product { first, rest } => {
            let mut done = convert(names, first);
            let mut factors = Vec::new();
            for operand in rest {
                let term = convert(names, &operand.formula);
                if operand.operator == Operator::Divide {
                    done = Term::product([done].into_iter().chain(factors.drain(..))).over(term);
                } else {
                    factors.push(term);
                }
            }
            Term::product([done].into_iter().chain(factors))
        }
        FormulaKind::Power { base, exponent, .. } => convert(names, base).power(*exponent),
        FormulaKind::Part { of, axis } => {
            if let FormulaKind::Name(name) = &of.kind
                && let Some((name, _)) = names.of(&name.to_string())
            {
                return Term::Name(component(name.clone(), *axis));
            }
            // the part of a formula is its product with the unit vector of the axis
            let unit = component(names.fresh('e'), *axis).marked_as_vector(true);
            Term::Dot(Box::new(convert(names, of)), Box::new(Term::Name(unit)))
        }
        FormulaKind::Call { callee, arguments, .. } => {
            let terms = arguments.iter().map(|argument| convert(names, argument)).collect();
            call(*callee, terms)
        }
    }
}

fn call(callee: Callee, mut terms: Vec<Term>) -> Term {
    match (callee, terms.as_mut_slice()) {
        (Callee::Elementary(function), _) => elementary(function, terms),
        (Callee::Cis, [angle]) => Term::direction(angle.clone()),
        (Callee::Polar, [length, angle]) => Term::product([length.clone(), Term::direction(angle.clone())]),
        (Callee::Vec2, [x, y]) => complex(x.clone(), y.clone()),
        (Callee::Dot, [left, right]) => Term::Dot(Box::new(left.clone()), Box::new(right.clone())),
        (Callee::Cross, [left, right]) => Term::Cross(Box::new(left.clone()), Box::new(right.clone())),
        (Callee::Norm, [of]) => of.clone().norm(),
        (Callee::RotX, _) => Term::Call("Rot_x", terms),
        (Callee::RotY, _) => Term::Call("Rot_y", terms),
        (Callee::RotZ, _) => Term::Call("Rot_z", terms),
        (Callee::Rot, _) => Term::Call("Rot", terms),
        _ => Term::Tuple(terms),
    }
}

/// x + i y
pub(super) fn complex(x: Term, y: Term) -> Term {
    let imaginary = match y {
        Term::Number(0.0) => Term::Number(0.0),
        y => Term::product([Term::Imaginary, y]),
    };
    Term::sum([x, imaginary])
}

/// A call of an elementary function.
pub(super) fn elementary(function: Function, mut arguments: Vec<Term>) -> Term {
    if function == Function::Sqrt && arguments.len() == 1 {
        return arguments.remove(0).root();
    }
    Term::Call(function.notation(), arguments)
}

/// The shape of a formula without mistakes; `known` gives the shapes of the names.
pub(super) fn shape(formula: &Formula, known: &dyn Fn(&str) -> Option<Shape>) -> Shape {
    match &formula.kind {
        FormulaKind::Number { .. }
        | FormulaKind::Degrees { .. }
        | FormulaKind::Pi
        | FormulaKind::Power { .. }
        | FormulaKind::Part { .. } => Shape::Scalar,
        FormulaKind::Name(name) => known(&name.to_string()).unwrap_or(Shape::Scalar),
        FormulaKind::Negate(of) | FormulaKind::Parenthesis(of) => shape(of, known),
        FormulaKind::Sum { first, rest } | FormulaKind::Product { first, rest } => {
            let others = rest.iter().map(|operand| shape(&operand.formula, known));
            others.fold(shape(first, known), |left, right| match (left, right) {
                (Shape::Scalar, other) => other,
                // a rotation turns the vector behind it
                (Shape::Rotation, Shape::Space) => Shape::Space,
                (own, _) => own,
            })
        }
        FormulaKind::Call { callee, arguments, .. } => match callee {
            Callee::Cis | Callee::Polar | Callee::Vec2 => Shape::Plane,
            Callee::Vec3 => Shape::Space,
            Callee::RotX | Callee::RotY | Callee::RotZ | Callee::Rot => Shape::Rotation,
            Callee::Cross => match arguments.first().map(|first| shape(first, known)) {
                Some(Shape::Space) => Shape::Space,
                _ => Shape::Scalar,
            },
            Callee::Elementary(_) | Callee::Dot | Callee::Norm => Shape::Scalar,
        },
    }
}
