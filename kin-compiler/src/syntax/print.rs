//! Formulas as text: as typed, with even spacing.

use std::fmt::{self, Display, Formatter};

use crate::syntax::{
    ArithmeticOperator, Axis, EquationStatement, FormulaKind, RangeClause, RangeKind, Relation, TypedFormula,
};

impl ArithmeticOperator {
    pub(crate) fn symbol(self) -> &'static str {
        match self {
            Self::Add => "+",
            Self::Subtract => "-",
            Self::Multiply => "*",
            Self::Divide => "/",
        }
    }
}

impl Relation {
    fn symbol(self) -> &'static str {
        match self {
            Self::Less => "<",
            Self::LessOrEqual => "<=",
            Self::Greater => ">",
            Self::GreaterOrEqual => ">=",
        }
    }
}

impl Axis {
    /// The name in messages of an equation's part along this axis.
    pub(crate) fn part_of_equation(self) -> &'static str {
        match self {
            Self::X => "equation's x part",
            Self::Y => "equation's y part",
            Self::Z => "equation's z part",
        }
    }
}

impl Display for Axis {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        })
    }
}

impl Display for TypedFormula {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match &self.kind {
            FormulaKind::Number { text, .. } | FormulaKind::Degrees { text, .. } => f.write_str(text),
            FormulaKind::Pi => f.write_str("PI"),
            FormulaKind::Name(name) => write!(f, "{name}"),
            FormulaKind::Negate(of) => write!(f, "-{of}"),
            FormulaKind::Sum { first, rest } | FormulaKind::Product { first, rest } => {
                write!(f, "{first}")?;
                rest.iter()
                    .try_for_each(|operation| write!(f, " {} {}", operation.operator.symbol(), operation.formula))
            }
            FormulaKind::Call {
                callee,
                arguments,
                method,
            } => call(f, callee.name(), arguments, *method, None),
            FormulaKind::Power { base, exponent, method } => {
                call(f, "powi", std::slice::from_ref(&**base), *method, Some(*exponent))
            }
            FormulaKind::Part { of, axis } => write!(f, "{of}.{axis}"),
            FormulaKind::Parenthesis(inner) => write!(f, "({inner})"),
        }
    }
}

fn call(
    f: &mut Formatter<'_>,
    name: &str,
    arguments: &[TypedFormula],
    method: bool,
    exponent: Option<i32>,
) -> fmt::Result {
    let mut inside: Vec<String> = arguments.iter().map(TypedFormula::to_string).collect();
    inside.extend(exponent.map(|n| n.to_string()));
    if method && !inside.is_empty() {
        let receiver = inside.remove(0);
        write!(f, "{receiver}.")?;
    }
    write!(f, "{name}({})", inside.join(", "))
}

impl Display for EquationStatement {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{} == {}", self.left, self.right)
    }
}

impl RangeClause {
    /// `e > 0`, `gamma in 0.0..=PI`
    pub(crate) fn text(&self, unknown: &str) -> String {
        match &self.kind {
            RangeKind::Comparison { comparison, bound, .. } => format!("{unknown} {} {bound}", comparison.symbol()),
            RangeKind::Between { low, high, closed } => {
                let dots = if *closed { "..=" } else { ".." };
                format!("{unknown} in {low}{dots}{high}")
            }
        }
    }
}
