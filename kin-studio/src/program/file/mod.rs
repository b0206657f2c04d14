//! `kin run` and `kin check`: mechanisms of people who write no Rust.

mod assemblies;
mod joints;
mod json;
mod loads;
mod numbers;
mod read;

use std::path::Path;

use super::fault::Fault;
use super::format;
use super::loads::Loads;
use super::subject::Subject;
use crate::file::{Mistake, shown, text_of, tokens};
use read::KinFile;

/// What a file says besides the declaration.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Settings {
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

fn wrong(mistakes: &[Mistake], path: &Path, text: &str) -> Fault {
    Fault::wrong(shown(mistakes, path, text))
}

/// Reads a file, and compiles its declaration.
fn compiled(path: &Path) -> Result<KinFile, Fault> {
    let text = text_of(path).map_err(Fault::wrong)?;
    KinFile::read(&text).map_err(|mistakes| wrong(&mistakes, path, &text))
}

/// The text of a file in one form. Files whose statements cannot be told apart are mistakes.
pub(super) fn formatted(path: &Path, text: &str) -> Result<String, Fault> {
    let tokens = |text: &str| tokens(text).map_err(|mistakes| wrong(&mistakes, path, text));
    let before = tokens(text)?;
    let formatted = format::formatted(text, &before);
    let is_same = format::is_same((text, &before), (&formatted, &tokens(&formatted)?));
    let changed = || Fault::wrong(format!("{} cannot be formatted, so it is left alone", path.display()));
    is_same.then_some(formatted).ok_or_else(changed)
}

/// The mechanism of a file, and what the file says of it.
pub(super) fn read(path: &Path) -> Result<(Subject, Settings), Fault> {
    let file = compiled(path)?;
    let settings = Settings {
        set: file.set,
        over: file.over,
        assembly: file.assembly,
        columns: file.columns,
        loads: file.loads,
        documentation: file.mechanism.declaration().documentation().to_owned(),
        declaration: file.declaration,
    };
    Ok((Subject::new(file.mechanism), settings))
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
    let text = text_of(path).map_err(Fault::wrong)?;
    let read = KinFile::read(&text);
    let count = read.as_ref().err().map_or(0, Vec::len);
    Ok((json::checked(&path.display().to_string(), &text, read), count))
}
