//! Comma-separated values.

use std::fmt::Write as _;

use super::Columns;

pub(super) fn text(columns: &Columns<'_>) -> String {
    let table = columns.table;
    let mut text = String::new();
    for column in columns.of(table.columns()) {
        text.push_str(&quoted(&column.to_string()));
        text.push(',');
    }
    text.push_str("outcome,margin\n");
    let mut limits = table.limits().iter().peekable();
    for row in table.rows() {
        line(&mut text, columns.of(row.values()));
        text.push_str(super::outcome(row.outcome()));
        text.push(',');
        number(&mut text, table.margin(row.index()));
        text.push('\n');
        while let Some(limit) = limits.next_if(|limit| limit.row == row.index()) {
            line(&mut text, columns.of(table.values_at(limit)));
            text.push_str(&limit.kind.to_string());
            text.push_str(",\n");
        }
    }
    text
}

/// Numbers, each with a comma behind it.
fn line(text: &mut String, values: Vec<f64>) {
    for value in values {
        number(text, Some(value).filter(|value| !value.is_nan()));
        text.push(',');
    }
}

/// The shortest decimal that is read back as the same number.
fn number(text: &mut String, value: Option<f64>) {
    if let Some(value) = value {
        // a String never refuses what is written to it
        let _ = write!(text, "{value:?}");
    }
}

/// A text that holds a comma, a quotation mark or a line break stands in quotation marks, and those inside are doubled.
pub(crate) fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}
