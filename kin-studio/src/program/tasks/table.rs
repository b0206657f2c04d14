//! `kin table`: a table that is exact between its rows.

use kin_core::Dimension;
use kin_core::exact::{ExactParts, Precision};
use serde_json::{Value, json};

use super::super::command::{ExactTable, Form};
use super::super::fault::Fault;
use super::super::file::Told;
use super::super::progress::watched;
use super::super::snake;
use super::super::subject::Subject;
use super::super::text::{self, Column};
use super::print;

pub(super) fn run(subject: &dyn Subject, options: &ExactTable, told: &Told) -> Result<(), Fault> {
    let case = options.setup.typed(told).case(subject)?;
    let mut precision = Precision::from(options.tolerance);
    if let Some(order) = options.order {
        precision = precision.up_to(order);
    }
    let table = watched("refining the table", 1, |_| subject.exact_table(&case, precision))?;
    let ending = match options.form {
        Form::Binary => "kin-table",
        Form::Json => "json",
    };
    let path = options
        .output
        .clone()
        .unwrap_or_else(|| format!("{}.{ending}", snake(subject.description().name)).into());
    let bytes = match options.form {
        Form::Binary => table.as_bytes().to_vec(),
        Form::Json => json(&table.parts()).to_string().into_bytes(),
    };
    std::fs::write(&path, &bytes)
        .map_err(|error| Fault::wrong(format!("{} cannot be written: {error}", path.display())))?;
    let mut columns = vec![Column::words(
        "column",
        table.columns().map(|column| column.name().to_owned()).collect(),
    )];
    let orders = ["value", "velocity", "acceleration", "jerk", "snap"];
    for (order, name) in orders.into_iter().enumerate().take(table.order() + 1) {
        let errors = table.columns().map(|column| match column.errors().nth(order) {
            Some(error) => format!("{error:.1e}"),
            None => "-".to_owned(),
        });
        columns.push(Column::numbers(name, errors.collect()));
    }
    print(&format!(
        "{}: {} rows, {} bytes; the measured errors, per radian or unit of the input:\n{}",
        path.display(),
        table.rows(),
        bytes.len(),
        text::table(&columns)
    ))
}

/// One object: the name, the parameter, and the columns and rows as `ExactParts` has them.
fn json(parts: &ExactParts) -> Value {
    let dimension = |dimension: Dimension| match dimension {
        Dimension::Length => "length",
        Dimension::Angle => "angle",
        Dimension::Scalar => "number",
    };
    let columns: Vec<Value> = parts
        .columns
        .iter()
        .map(|column| {
            json!({
                "name": column.name,
                "dimension": dimension(column.dimension),
                "turn": column.turn,
                "errors": column.errors,
            })
        })
        .collect();
    json!({
        "name": parts.name,
        "parameter": { "name": parts.parameter.0, "dimension": dimension(parts.parameter.1) },
        "order": parts.order,
        "is_closed": parts.is_closed,
        "columns": columns,
        "rows": parts.rows,
    })
}
