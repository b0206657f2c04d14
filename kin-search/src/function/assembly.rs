//! An assembly as text.

use datafusion::common::{Result, plan_err};
use kin_core::assembly_named;

/// The index of the assembly that a text names: its full name, or one word for all dyads.
pub(crate) fn index_of(names: &[String], text: &str) -> Result<usize> {
    if let Some(index) = assembly_named(names, text) {
        return Ok(index);
    }
    plan_err!("`{text}` is no assembly; write one of {}", listed(names))
}

/// The names in quotes.
pub(crate) fn listed(names: &[String]) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("'{name}'")).collect();
    quoted.join(", ")
}
