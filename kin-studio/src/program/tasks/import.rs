//! `kin import`: files of other programs as `.kin` files.

use std::path::Path;

use kin_sketch::foreign;

use crate::case::fault::Fault;
use crate::case::file;

/// Reads the file of another program, or the address that it shares, and writes a `.kin` file.
pub(crate) fn import(from: &str, output: &Path) -> Result<(), Fault> {
    let is_address = from.contains("://");
    let text = if is_address {
        from.to_owned()
    } else {
        crate::file::text_of(Path::new(from)).map_err(Fault::wrong)?
    };
    let name = if is_address { "the address" } else { from };
    let told = |reason: &dyn std::fmt::Display| Fault::wrong(format!("{name}: {reason}"));
    let drawing = foreign::read(&text).map_err(|error| told(&error))?;
    let declared = drawing.sketch.declaration().map_err(|faults| {
        let faults: Vec<String> = faults.iter().map(ToString::to_string).collect();
        told(&faults.join("\n       "))
    })?;
    for note in &drawing.notes {
        eprintln!("note: {note}");
    }
    let written = drawing.kin_file(&declared);
    super::write(
        output,
        &file::formatted(&written, &output.display().to_string()).map_err(Fault::wrong)?,
    )
}
