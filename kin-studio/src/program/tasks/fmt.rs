//! `kin fmt`: `.kin` files in one form.

use std::path::Path;

use super::print;
use crate::case::fault::Fault;
use crate::case::file;

/// Formats a file in place, or from the input to the output if its name is `-`; or checks whether it is in form.
pub(crate) fn fmt(path: &Path, only_check: bool) -> Result<(), Fault> {
    let text = crate::file::text_of(path).map_err(Fault::wrong)?;
    let formatted = file::formatted(&text, &path.display().to_string()).map_err(Fault::wrong)?;
    if only_check && formatted != text {
        let message = format!(
            "{} is in another form: write `kin fmt` without `--check`",
            path.display()
        );
        return Err(Fault::failed(message));
    }
    if only_check {
        return Ok(());
    }
    if path == Path::new("-") {
        return print(&formatted);
    }
    if formatted == text {
        return Ok(());
    }
    std::fs::write(path, formatted)
        .map_err(|error| Fault::wrong(format!("{} cannot be written: {error}", path.display())))
}
