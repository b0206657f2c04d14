//! The outputs for any values of inputs and unknowns.

use super::formula::lifted;
use super::names::Names;
use super::tree::{Local, Sheet};
use crate::syntax::{Declaration, Statement};

/// The method `outputs_at` of the trait of all mechanisms: each output, part by part.
pub(super) fn sheet(declaration: &Declaration, names: &Names) -> Sheet {
    let outputs = declaration.statements.iter().filter_map(|statement| match statement {
        Statement::Output(output) => Some(output),
        _ => None,
    });
    let values = outputs.map(|output| lifted(names.formula(&output.value), output.dimension.shape()));
    names.sheet_of_parts(values, Local::Output)
}
