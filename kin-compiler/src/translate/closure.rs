//! The residuals of the equations, for verification.

use super::formula::difference;
use super::names::Names;
use super::tree::{Local, Sheet};
use crate::syntax::{Declaration, Statement};

/// The method `closure`: the left side minus the right side of each equation, part by part.
pub(super) fn sheet(declaration: &Declaration, names: &Names) -> Sheet {
    let equations = declaration.statements.iter().filter_map(|statement| match statement {
        Statement::Equation(equation) => Some(equation),
        _ => None,
    });
    let residuals = equations.map(|equation| difference(names.formula(&equation.left), names.formula(&equation.right)));
    names.sheet_of_parts(residuals, Local::Equation)
}
