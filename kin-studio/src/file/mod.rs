//! `.kin` files: mechanisms of people who write no Rust.

#[cfg_attr(not(feature = "case"), allow(dead_code, reason = "the program formats files"))]
mod declaration;
#[cfg(feature = "case")]
pub(crate) mod format;
mod mistake;
#[cfg_attr(
    not(feature = "case"),
    allow(dead_code, reason = "the program reads the numbers of sections")
)]
mod sections;

use std::path::Path;

#[cfg(feature = "case")]
pub(crate) use declaration::tokens;
pub(crate) use declaration::{KinDeclaration, in_order};
pub(crate) use mistake::Mistake;
#[cfg(feature = "case")]
pub(crate) use sections::{Entry, Part, Sections, is_ident, is_punct, parts, range_of};

/// The declaration in a `.kin` file, in the form that [`kin_live::Mechanism::declare`] takes. The numbers of the file
/// are not read.
///
/// # Errors
/// The reason why the file cannot be read, or every mistake of the declaration, each with its line and a mark below it.
pub fn declaration(path: &Path) -> Result<String, String> {
    let text = text_of(path)?;
    let file = KinDeclaration::read(&text).and_then(|file| match file.sections.mistakes.as_slice() {
        [] => Ok(file.text),
        mistakes => Err(mistakes.to_vec()),
    });
    file.map_err(|mistakes| shown(&in_order(mistakes, &text), &path.display().to_string(), &text))
}

/// A mistake of a declaration as people read it: the message, and the line with a mark below the tokens at fault. The
/// text, which has this name, is the one that was declared.
///
/// ```
/// let text = "
///     struct Crank { r: Length }
///     input theta: Angle;
///     unknown x: Length;
///     x == q * cos(theta);
/// ";
/// let Err(kin_live::DeclareError::Mistakes(mistakes)) = kin_live::Mechanism::declare(text) else { panic!() };
/// let shown = kin_studio::file::marked(&mistakes[0], "crank", text);
/// assert!(shown.contains("--> crank:5:10"), "{shown}");
/// assert!(shown.ends_with("  |          ^"), "{shown}");
/// ```
#[must_use]
pub fn marked(mistake: &kin_live::Mistake, name: &str, text: &str) -> String {
    Mistake::new(mistake.message.as_str(), mistake.bytes.clone()).shown(name, text)
}

/// The text of a file, or of the input if its name is `-`, without a byte order mark and line ends of other systems.
pub(crate) fn text_of(path: &Path) -> Result<String, String> {
    let shown = path.display();
    let text = if path == Path::new("-") {
        std::io::read_to_string(std::io::stdin())
    } else {
        std::fs::read_to_string(path)
    };
    let text = text.map_err(|error| match error.kind() {
        std::io::ErrorKind::NotFound => format!("there is no file {shown}"),
        std::io::ErrorKind::InvalidData => format!("{shown} is no text in UTF-8"),
        _ => format!("{shown} cannot be read: {error}"),
    })?;
    Ok(text.trim_start_matches('\u{feff}').replace("\r\n", "\n"))
}

/// The mistakes in the text of a file of this name, each with its line and a mark.
pub(crate) fn shown(mistakes: &[Mistake], name: &str, text: &str) -> String {
    let shown: Vec<String> = mistakes.iter().map(|mistake| mistake.shown(name, text)).collect();
    shown.join("\n\n")
}
