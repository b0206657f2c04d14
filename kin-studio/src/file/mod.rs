//! `.kin` files: mechanisms of people who write no Rust.

mod mistake;
mod sections;

use std::path::Path;

pub(crate) use mistake::Mistake;
pub(crate) use sections::KinDeclaration;
#[cfg(feature = "program")]
pub(crate) use sections::{Entry, or_comment};

/// The declaration in a `.kin` file, as [`kin_live::Mechanism::declare`] takes it. The numbers of the file are not read.
///
/// # Errors
/// The reason why the file cannot be read, or every mistake of the declaration, each with its line and a mark below it.
pub fn declaration(path: &Path) -> Result<String, String> {
    read(path, KinDeclaration::read).map(|declaration| declaration.text)
}

/// Reads a file by a function, and shows its mistakes at their places.
pub(crate) fn read<F>(path: &Path, function: impl FnOnce(&str) -> Result<F, Vec<Mistake>>) -> Result<F, String> {
    let shown = path.display().to_string();
    let text = std::fs::read_to_string(path).map_err(|error| match error.kind() {
        std::io::ErrorKind::NotFound => format!("there is no file {shown}"),
        std::io::ErrorKind::InvalidData => format!("{shown} is no text in UTF-8"),
        _ => format!("{shown} cannot be read: {error}"),
    })?;
    // a byte order mark, and line ends of other systems
    let text = text.trim_start_matches('\u{feff}').replace("\r\n", "\n");
    function(&text).map_err(|mistakes| {
        let shown: Vec<String> = mistakes.iter().map(|mistake| mistake.shown(&shown, &text)).collect();
        shown.join("\n\n")
    })
}
