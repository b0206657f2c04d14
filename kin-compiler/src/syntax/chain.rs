//! Sums and products that are put together.

use proc_macro2::Span;
use syn::parse::Result;

use crate::syntax::{ArithmeticOperator, FormulaKind, Operand, TypedFormula, formula};

/// A sum or a product.
pub(super) struct Chain {
    first: TypedFormula,
    rest: Vec<Operand>,
}

impl Chain {
    fn new(first: TypedFormula) -> Self {
        let rest = Vec::new();
        Self { first, rest }
    }

    /// A sum with the terms of a formula.
    pub(super) fn of_terms(formula: TypedFormula) -> Self {
        match formula.kind {
            FormulaKind::Sum { first, rest } => Self { first: *first, rest },
            _ => Self::new(formula),
        }
    }

    /// A product with the factors of a formula.
    pub(super) fn of_factors(formula: TypedFormula) -> Self {
        match formula.kind {
            FormulaKind::Product { first, rest } => Self { first: *first, rest },
            _ => Self::new(formula),
        }
    }

    fn push(&mut self, operator: ArithmeticOperator, span: Span, formula: TypedFormula) {
        self.rest.push(Operand {
            operator,
            span,
            formula,
        });
    }

    /// Adds the terms of a formula, or subtracts the formula.
    pub(super) fn add(&mut self, operator: ArithmeticOperator, span: Span, term: TypedFormula) -> Result<()> {
        if operator == ArithmeticOperator::Subtract && matches!(term.kind, FormulaKind::Sum { .. }) {
            self.push(operator, span, term.grouped()?);
            return Ok(());
        }
        let terms = Self::of_terms(term);
        self.push(operator, span, terms.first);
        self.rest.extend(terms.rest);
        Ok(())
    }

    /// Multiplies or divides by a formula.
    pub(super) fn times(&mut self, operator: ArithmeticOperator, span: Span, factor: TypedFormula) -> Result<()> {
        if self.rest.is_empty() && matches!(self.first.kind, FormulaKind::Sum { .. }) {
            self.first = self.first.clone().grouped()?;
        }
        let factor = match factor.kind {
            FormulaKind::Sum { .. } | FormulaKind::Product { .. } => factor.grouped()?,
            _ => factor,
        };
        self.push(operator, span, factor);
        Ok(())
    }

    pub(super) fn sum(self) -> Result<TypedFormula> {
        self.formula(|first, rest| FormulaKind::Sum { first, rest })
    }

    pub(super) fn product(self) -> Result<TypedFormula> {
        self.formula(|first, rest| FormulaKind::Product { first, rest })
    }

    fn formula(self, kind: fn(Box<TypedFormula>, Vec<Operand>) -> FormulaKind) -> Result<TypedFormula> {
        formula::chain(self.first, self.rest, kind)
    }
}
