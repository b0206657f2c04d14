//! Rows as a table of text.

use std::io::{self, Write};

use datafusion::arrow::array::RecordBatch;
use datafusion::arrow::datatypes::Schema;
use datafusion::arrow::error::ArrowError;
use datafusion::arrow::util::display::{ArrayFormatter, FormatOptions};

/// Writes rows as a table. Each cell is made twice, to know the widths of the columns before the first line: the texts
/// of all cells together would be far larger than the rows.
pub(crate) fn write_table(output: &mut dyn Write, schema: &Schema, rows: &[RecordBatch]) -> io::Result<()> {
    let names: Vec<String> = schema.fields().iter().map(|field| field.name().clone()).collect();
    let mut widths: Vec<usize> = names.iter().map(|name| width(name)).collect();
    each_row(rows, |cells| {
        for (widest, cell) in widths.iter_mut().zip(cells) {
            *widest = (*widest).max(width(cell));
        }
        Ok(())
    })?;
    let lines: Vec<String> = widths.iter().map(|width| "-".repeat(width + 2)).collect();
    let line = format!("+{}+", lines.join("+"));
    writeln!(output, "{line}")?;
    write_row(output, &names, &widths)?;
    writeln!(output, "{line}")?;
    each_row(rows, |cells| write_row(output, cells, &widths))?;
    writeln!(output, "{line}")
}

/// Calls `then` with the texts of each row.
fn each_row(rows: &[RecordBatch], mut then: impl FnMut(&[String]) -> io::Result<()>) -> io::Result<()> {
    let options = FormatOptions::default().with_display_error(true);
    for batch in rows {
        let columns = batch
            .columns()
            .iter()
            .map(|column| ArrayFormatter::try_new(column, &options));
        let columns = columns
            .collect::<Result<Vec<_>, ArrowError>>()
            .map_err(io::Error::other)?;
        for row in 0..batch.num_rows() {
            let cells: Vec<String> = columns.iter().map(|column| column.value(row).to_string()).collect();
            then(&cells)?;
        }
    }
    Ok(())
}

/// The width of a cell, which may have several lines.
fn width(cell: &str) -> usize {
    cell.lines().map(|line| line.chars().count()).max().unwrap_or(0)
}

/// Writes a row with as many lines as its highest cell.
fn write_row(output: &mut dyn Write, cells: &[String], widths: &[usize]) -> io::Result<()> {
    let height = cells.iter().map(|cell| cell.lines().count()).max().unwrap_or(0).max(1);
    for line in 0..height {
        for (cell, width) in cells.iter().zip(widths) {
            write!(output, "| {:<width$} ", cell.lines().nth(line).unwrap_or(""))?;
        }
        writeln!(output, "|")?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use datafusion::arrow::array::{Float64Array, StringArray};
    use datafusion::arrow::datatypes::{DataType, Field};
    use datafusion::arrow::util::pretty::pretty_format_batches;

    use super::*;

    #[test]
    fn a_table_is_that_of_the_engine() {
        let fields = vec![
            Field::new("θ₄", DataType::Float64, true),
            Field::new("plan of a query", DataType::Utf8, true),
        ];
        let schema = Arc::new(Schema::new(fields));
        let batch = |angles: Vec<Option<f64>>, texts: Vec<Option<&str>>| {
            let columns = vec![
                Arc::new(Float64Array::from(angles)) as _,
                Arc::new(StringArray::from(texts)) as _,
            ];
            RecordBatch::try_new(Arc::clone(&schema), columns).unwrap()
        };
        let rows = [
            batch(
                vec![Some(0.1), None],
                vec![Some("one\nlonger than the name\n  three"), Some("")],
            ),
            batch(vec![Some(-1e300)], vec![None]),
        ];
        let mut table = Vec::new();
        write_table(&mut table, &schema, &rows).unwrap();
        let wanted = pretty_format_batches(&rows).unwrap().to_string();
        assert_eq!(String::from_utf8(table).unwrap().trim_end(), wanted);
        // A query without rows still has columns.
        let mut table = Vec::new();
        write_table(&mut table, &schema, &[]).unwrap();
        assert!(String::from_utf8(table).unwrap().contains("| θ₄ | plan of a query |"));
    }
}
