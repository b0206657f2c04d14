//! Formulas and statements with other formulas in them.

use proc_macro2::Ident;
use syn::parse::Result;

use crate::syntax::{FormulaKind, Statement, TypedFormula};
use crate::work;

impl TypedFormula {
    /// The formula with others instead of those directly in it.
    pub(super) fn with_parts(&self, of: &mut dyn FnMut(&Self) -> Result<Self>) -> Result<Self> {
        let mut kind = self.kind.clone();
        match &mut kind {
            FormulaKind::Number { .. } | FormulaKind::Degrees { .. } | FormulaKind::Pi | FormulaKind::Name(_) => {}
            FormulaKind::Negate(part)
            | FormulaKind::Parenthesis(part)
            | FormulaKind::Part { of: part, .. }
            | FormulaKind::Power { base: part, .. } => **part = of(part)?,
            FormulaKind::Sum { first, rest } | FormulaKind::Product { first, rest } => {
                **first = of(first)?;
                for operand in rest {
                    operand.formula = of(&operand.formula)?;
                }
            }
            FormulaKind::Call { arguments, .. } => {
                for argument in arguments {
                    *argument = of(argument)?;
                }
            }
        }
        Self::new(kind, self.extent)
    }

    /// The formula with others instead of names.
    pub(super) fn with_names(&self, meaning: &dyn Fn(&Ident) -> Option<Self>) -> Result<Self> {
        work::iteration();
        match &self.kind {
            FormulaKind::Name(name) => Ok(meaning(name).unwrap_or_else(|| self.clone())),
            _ => self.with_parts(&mut |part| part.with_names(meaning)),
        }
    }

    /// The formula as an operand of a product, or before a method.
    pub(super) fn grouped(self) -> Result<Self> {
        match &self.kind {
            FormulaKind::Sum { .. } | FormulaKind::Product { .. } | FormulaKind::Negate(_) => {
                let extent = self.extent;
                Self::new(FormulaKind::Parenthesis(Box::new(self)), extent)
            }
            _ => Ok(self),
        }
    }
}

impl Statement {
    /// The name and the value that other formulas may use: those of a `let`, or of an output.
    pub(crate) fn abbreviation(&self) -> Option<(&Ident, &TypedFormula)> {
        match self {
            Self::Let(statement) => Some((&statement.name, &statement.value)),
            Self::Output(statement) => Some((&statement.name, &statement.value)),
            _ => None,
        }
    }

    /// Its formulas, in source order. Ranges of unknowns are none of them.
    pub(super) fn formulas(&mut self) -> Vec<&mut TypedFormula> {
        match self {
            Self::Let(statement) => vec![&mut statement.value],
            Self::Frame(statement) => vec![&mut statement.origin, &mut statement.rotation],
            Self::Equation(statement) => vec![&mut statement.left, &mut statement.right],
            Self::Output(statement) => vec![&mut statement.value],
            Self::Body(statement) => statement.points.iter_mut().collect(),
            Self::Ground(statement) => statement.points.iter_mut().collect(),
            Self::Slide(statement) => vec![&mut statement.point, &mut statement.direction],
            Self::Inputs(_)
            | Self::Unknowns(_)
            | Self::Order(_)
            | Self::Requests(_)
            | Self::Repeats(_)
            | Self::Repeated => Vec::new(),
        }
    }
}
