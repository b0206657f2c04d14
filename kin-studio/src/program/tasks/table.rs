//! `kin table`: a table that is exact between its rows.

use kin_core::exact::Precision;
use kin_core::{RATES, in_small_letters};

use super::super::command::{ExactTable, Form};
use super::super::progress::watched;
use super::super::text::{self, Column};
use super::print;
use crate::case::fault::Fault;
use crate::case::file::Settings;
use crate::case::subject::Subject;
use crate::tables::ExactJson as _;

pub(super) fn run(subject: &Subject, options: &ExactTable, settings: &Settings) -> Result<(), Fault> {
    let case = options.setup.typed(settings).case(subject)?;
    if case.loads.is_some() {
        eprintln!("note: the table holds no efforts: `sweep` and `peaks` find them");
    }
    let mut precision = Precision::from(options.tolerance);
    if let Some(order) = options.order {
        precision = precision.up_to(order.into());
    }
    let table = watched("refining the table", 1, |_| subject.exact_table(&case, precision))?;
    let ending = match options.form {
        Form::Binary => "kin-table",
        Form::Json => "json",
    };
    let path = options
        .output
        .clone()
        .unwrap_or_else(|| format!("{}.{ending}", in_small_letters(subject.description().name, '_')).into());
    let bytes = match options.form {
        Form::Binary => table.as_bytes().to_vec(),
        Form::Json => table.to_json().into_bytes(),
    };
    std::fs::write(&path, &bytes)
        .map_err(|error| Fault::wrong(format!("{} cannot be written: {error}", path.display())))?;
    let mut columns = vec![Column::words(
        "column",
        table.columns().map(|column| column.name().to_owned()).collect(),
    )];
    let orders = std::iter::once("value").chain(RATES);
    for (order, name) in orders.enumerate().take(table.order() + 1) {
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
