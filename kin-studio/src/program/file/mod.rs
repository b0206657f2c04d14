//! `kin run` and `kin check`: mechanisms of people who write no Rust.

mod assemblies;
mod json;
mod loads;
mod numbers;
mod place;
mod read;
mod sections;

use std::path::Path;

use super::fault::Fault;
use super::format;
use super::loads::Loads;
use super::subject::Subject;
use place::Mistake;
use read::KinFile;

/// What a file says besides the declaration.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Told {
    /// Dimensions and inputs that stand.
    pub(super) set: Vec<String>,
    /// Motions of inputs.
    pub(super) over: Vec<String>,
    /// The assembly, or several.
    pub(super) assembly: Option<String>,
    /// The columns to print.
    pub(super) columns: Vec<String>,
    /// The loads.
    pub(super) loads: Loads,
    /// The doc comment of the mechanism.
    pub(super) documentation: String,
    /// The declaration as it was typed.
    pub(super) declaration: String,
}

/// The text of a file, or of the input if its name is `-`, without a byte order mark and line ends of other systems.
pub(super) fn text_of(path: &Path) -> Result<String, Fault> {
    let shown = path.display();
    let text = if path == Path::new("-") {
        std::io::read_to_string(std::io::stdin())
    } else {
        std::fs::read_to_string(path)
    };
    let text = text.map_err(|error| {
        Fault::wrong(match error.kind() {
            std::io::ErrorKind::NotFound => format!("there is no file {shown}"),
            std::io::ErrorKind::InvalidData => format!("{shown} is no text in UTF-8"),
            _ => format!("{shown} cannot be read: {error}"),
        })
    })?;
    Ok(text.trim_start_matches('\u{feff}').replace("\r\n", "\n"))
}

/// The mistakes in a text, each at its place.
fn shown(mistakes: &[Mistake], path: &Path, text: &str) -> Fault {
    let file = path.display().to_string();
    let shown: Vec<String> = mistakes.iter().map(|mistake| mistake.shown(&file, text)).collect();
    Fault::wrong(shown.join("\n\n"))
}

/// Reads a file, and compiles its declaration.
fn compiled(path: &Path) -> Result<KinFile, Fault> {
    let text = text_of(path)?;
    KinFile::read(&text).map_err(|mistakes| shown(&mistakes, path, &text))
}

/// The text of a file in one form. Files whose statements cannot be told apart are mistakes.
pub(super) fn formatted(path: &Path, text: &str) -> Result<String, Fault> {
    let tokens = |text: &str| KinFile::tokens(text).map_err(|mistakes| shown(&mistakes, path, text));
    let before = tokens(text)?;
    let formatted = format::formatted(text, &before);
    let is_same = format::is_same((text, &before), (&formatted, &tokens(&formatted)?));
    let changed = || Fault::wrong(format!("{} cannot be formatted, so it is left alone", path.display()));
    is_same.then_some(formatted).ok_or_else(changed)
}

/// The mechanism of a file, and what the file says of it.
pub(super) fn read(path: &Path) -> Result<(Subject, Told), Fault> {
    let file = compiled(path)?;
    let told = Told {
        set: file.set,
        over: file.over,
        assembly: file.assembly,
        columns: file.columns,
        loads: file.loads,
        documentation: file.mechanism.declaration().documentation().to_owned(),
        declaration: file.declaration,
    };
    Ok((Subject::new(file.mechanism), told))
}

/// What is said of a file without mistakes: its mechanism, and the steps of its solvers where they are wanted.
pub(super) fn check(path: &Path, steps: bool) -> Result<String, Fault> {
    let file = compiled(path)?;
    let declaration = file.mechanism.declaration();
    let said = format!("{}: {} has no mistakes\n", path.display(), declaration.name());
    let steps = if steps { declaration.printout() } else { "" };
    Ok(said + steps)
}

/// The mistakes of a file for an editor, and how many there are.
pub(super) fn check_as_json(path: &Path) -> Result<(String, usize), Fault> {
    let text = text_of(path)?;
    let read = KinFile::read(&text);
    let count = read.as_ref().err().map_or(0, Vec::len);
    Ok((json::checked(&path.display().to_string(), &text, read), count))
}
