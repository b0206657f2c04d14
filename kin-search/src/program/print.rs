//! The standard output.

use std::io::{self, BufWriter, ErrorKind, Write};

#[cfg(feature = "refine")]
use datafusion::arrow::{array::RecordBatch, csv::Writer};

use super::fault::Fault;

/// Prints text.
pub(crate) fn print(text: &str) -> Result<(), Fault> {
    to_output(|output| output.write_all(text.as_bytes()))
}

/// Writes to the standard output. A reader that has gone away, as in `kin-search functions | head`, is no mistake.
pub(crate) fn to_output(write: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Fault> {
    let mut output = BufWriter::new(io::stdout().lock());
    match write(&mut output).and_then(|()| output.flush()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Fault::Wrong(format!("the standard output cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// Rows as comma-separated values, with the names of their columns.
#[cfg(feature = "refine")]
pub(crate) fn separated(rows: &[RecordBatch]) -> Result<String, Fault> {
    let mut table = Vec::new();
    let mut writer = Writer::new(&mut table);
    for rows in rows {
        writer.write(rows).map_err(|error| Fault::Wrong(error.to_string()))?;
    }
    drop(writer);
    String::from_utf8(table).map_err(|error| Fault::Wrong(error.to_string()))
}
