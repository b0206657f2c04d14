//! A frame, and what it makes of points and of other frames.

use proc_macro2::Span;
use syn::parse::Result;

use crate::mistakes::Extent;
use crate::syntax::chain::Chain;
use crate::syntax::{ArithmeticOperator, Callee, FormulaKind, TypedFormula};
use crate::work;

/// A frame: where its origin is, and how it is rotated.
#[derive(Clone)]
pub(super) struct Frame {
    pub(super) origin: TypedFormula,
    /// An angle in the plane, a rotation in space.
    pub(super) rotation: TypedFormula,
    /// `None` where a mistake hides it, which is reported elsewhere.
    pub(super) in_plane: Option<bool>,
}

impl Frame {
    /// The frame as it is used at a position.
    pub(super) fn at(&self, span: Span) -> Self {
        let at = |formula: &TypedFormula| {
            let mut formula = formula.clone();
            formula.extent = Extent::at(span);
            if let FormulaKind::Name(name) = &mut formula.kind {
                name.set_span(span);
            }
            formula
        };
        Self {
            origin: at(&self.origin),
            rotation: at(&self.rotation),
            in_plane: self.in_plane,
        }
    }

    /// A vector of the frame, as one of the frame around it.
    fn rotated(&self, vector: TypedFormula, span: Span) -> Result<TypedFormula> {
        let (first, second) = if self.in_plane == Some(true) {
            let call = FormulaKind::Call {
                callee: Callee::Cis,
                arguments: vec![self.rotation.clone()],
                method: false,
            };
            (vector, TypedFormula::new(call, self.rotation.extent)?)
        } else {
            (self.rotation.clone(), vector)
        };
        let mut factors = Chain::of_factors(first);
        factors.times(ArithmeticOperator::Multiply, span, second)?;
        factors.product()
    }

    /// A point of the frame, as one of the frame around it.
    pub(super) fn place(self, point: TypedFormula, span: Span) -> Result<TypedFormula> {
        if is_zero(&point) {
            return Ok(self.origin);
        }
        let rotated = self.rotated(point, span)?;
        if is_zero(&self.origin) {
            return Ok(rotated);
        }
        let mut terms = Chain::of_terms(self.origin);
        terms.add(ArithmeticOperator::Add, span, rotated)?;
        terms.sum()
    }

    /// A frame within this one, as one of the frame around it.
    pub(super) fn times(self, inner: Self, span: Span) -> Result<Self> {
        work::iterations(self.rotation.length() + self.origin.length());
        if work::is_spent() {
            return Ok(self);
        }
        let rotation = if self.in_plane == Some(true) {
            let mut terms = Chain::of_terms(self.rotation.clone());
            terms.add(ArithmeticOperator::Add, span, inner.rotation)?;
            terms.sum()?
        } else {
            self.rotated(inner.rotation, span)?
        };
        Ok(Self {
            in_plane: self.in_plane,
            rotation,
            origin: self.place(inner.origin, span)?,
        })
    }
}

impl TypedFormula {
    /// The number of operands that are copied with it.
    fn length(&self) -> usize {
        match &self.kind {
            FormulaKind::Sum { rest, .. } | FormulaKind::Product { rest, .. } => {
                1 + rest.iter().map(|operand| operand.formula.length()).sum::<usize>()
            }
            FormulaKind::Parenthesis(inner) => inner.length(),
            _ => 1,
        }
    }
}

/// Whether a formula is a literal zero.
pub(super) fn is_zero(formula: &TypedFormula) -> bool {
    match &formula.kind {
        FormulaKind::Number { value, .. } => *value == 0.0,
        FormulaKind::Parenthesis(inner) => is_zero(inner),
        _ => false,
    }
}
