//! The terms of a sum, however it is put in parentheses, negated and abbreviated.

use crate::syntax::{ArithmeticOperator, Callee, FormulaKind, Operand, TypedFormula};

use super::SkeletonNames;

/// So many abbreviations are written out in one sum.
const WRITTEN_OUT: usize = 256;

/// A term of a sum.
#[derive(Clone, Copy)]
pub(super) struct LinkTerm<'a> {
    pub(super) negative: bool,
    pub(super) formula: &'a TypedFormula,
}

impl LinkTerm<'_> {
    /// The term with its sign: equal terms have equal texts.
    pub(super) fn text(&self) -> String {
        let sign = if self.negative { '-' } else { '+' };
        // a scalar lies along x
        let formula = match &self.formula.kind {
            FormulaKind::Call {
                callee: Callee::Vec2,
                arguments,
                ..
            } => match arguments.as_slice() {
                [x, y] if matches!(y.kind, FormulaKind::Number { value: 0.0, .. }) => x,
                _ => self.formula,
            },
            _ => self.formula,
        };
        format!("{sign}{formula}")
    }
}

/// The terms of a vector, abbreviations of vectors written out. Zero has none.
pub(super) fn terms<'a>(formula: &'a TypedFormula, names: &SkeletonNames<'a>) -> Vec<LinkTerm<'a>> {
    let mut terms = Terms {
        names,
        left: WRITTEN_OUT,
        found: Vec::new(),
    };
    terms.add(formula, false);
    terms.found
}

struct Terms<'a, 'b> {
    names: &'b SkeletonNames<'a>,
    /// How many abbreviations may still be written out: there are as many terms in them as two to the power of their
    /// number.
    left: usize,
    found: Vec<LinkTerm<'a>>,
}

impl<'a> Terms<'a, '_> {
    fn add(&mut self, formula: &'a TypedFormula, negative: bool) {
        match &formula.kind {
            FormulaKind::Parenthesis(inner) => self.add(inner, negative),
            FormulaKind::Negate(inner) => self.add(inner, !negative),
            FormulaKind::Sum { first, rest } => {
                self.add(first, negative);
                for Operand {
                    operator,
                    formula: operand,
                    ..
                } in rest
                {
                    self.add(operand, negative != (*operator == ArithmeticOperator::Subtract));
                }
            }
            FormulaKind::Number { value: 0.0, .. } => {}
            FormulaKind::Name(name) => match self.names.vector_behind(name) {
                Some(value) if self.left > 0 => {
                    self.left -= 1;
                    self.add(value, negative);
                }
                _ => self.found.push(LinkTerm { negative, formula }),
            },
            _ => self.found.push(LinkTerm { negative, formula }),
        }
    }
}
