//! `.kin` files: mechanisms of people who write no Rust.

mod assemblies;
mod joints;
mod json;
mod loads;
mod numbers;
mod read;

use std::path::Path;

use super::fault::Fault;
use super::loads::Loads;
use super::subject::Subject;
use super::typed::Typed;
use crate::file::format;
use crate::file::{Mistake, Part, Sections, shown, text_of, tokens};
use numbers::Number;
use read::KinFile;

/// What a file says besides the declaration.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Settings {
    /// Dimensions and inputs that stand.
    pub(crate) set: Vec<String>,
    /// Motions of inputs.
    pub(crate) over: Vec<String>,
    /// The assembly, or several.
    pub(crate) assembly: Option<String>,
    /// The columns to print.
    pub(crate) columns: Vec<String>,
    /// The loads.
    pub(crate) loads: Loads,
    /// The doc comment of the mechanism.
    pub(crate) documentation: String,
    /// The declaration as it was typed.
    pub(crate) declaration: String,
}

impl Settings {
    /// The case that the file asks for.
    pub(crate) fn typed(&self) -> Typed {
        Typed {
            set: self.set.clone(),
            set_by_file: self.set.len(),
            over: self.over.clone(),
            assembly: self.assembly.clone(),
            loads: self.loads.clone(),
            ..Typed::default()
        }
    }
}

/// Reads the text of a file of this name, and compiles its declaration. The error holds every mistake with its line.
fn compiled(text: &str, name: &str) -> Result<KinFile, String> {
    KinFile::read(text).map_err(|mistakes| shown(&mistakes, name, text))
}

/// The text of a file in one form. Files whose statements cannot be told apart are mistakes.
pub(crate) fn formatted(text: &str, name: &str) -> Result<String, String> {
    let tokens = |text: &str| tokens(text).map_err(|mistakes| shown(&mistakes, name, text));
    let before = tokens(text)?;
    let formatted = format::formatted(text, &before);
    let is_same = format::is_same((text, &before), (&formatted, &tokens(&formatted)?));
    let changed = || format!("{name} cannot be formatted, so it is left alone");
    is_same.then_some(formatted).ok_or_else(changed)
}

/// The mechanism of a file that was read, what the file says of it, and where.
fn asked(file: KinFile) -> (Subject, Settings, Sections) {
    let text = |part: &Part| part.text.clone();
    let settings = Settings {
        set: file.set.iter().map(Number::setting).collect(),
        over: file.over,
        assembly: file.sections.assembly.as_ref().map(text),
        columns: file.sections.columns.iter().map(text).collect(),
        loads: file.loads,
        documentation: file.mechanism.declaration().documentation().to_owned(),
        declaration: file.declaration,
    };
    (Subject::new(file.mechanism), settings, file.sections)
}

/// The mechanism of a text, and what the text says of it. The name of the file stands in its mistakes.
pub(crate) fn of_text(text: &str, name: &str) -> Result<(Subject, Settings), String> {
    let (subject, settings, _) = asked(compiled(text, name)?);
    Ok((subject, settings))
}

/// The mechanism of a file, and what the file says of it.
pub(crate) fn read(path: &Path) -> Result<(Subject, Settings), Fault> {
    let text = text_of(path).map_err(Fault::wrong)?;
    of_text(&text, &path.display().to_string()).map_err(Fault::wrong)
}

/// What is said of a file without mistakes: its mechanism, and the steps of its solvers where they are wanted.
pub(crate) fn check(path: &Path, steps: bool) -> Result<String, Fault> {
    let text = text_of(path).map_err(Fault::wrong)?;
    let file = compiled(&text, &path.display().to_string()).map_err(Fault::wrong)?;
    let declaration = file.mechanism.declaration();
    let said = format!("{}: {} has no mistakes\n", path.display(), declaration.name());
    let steps = if steps { declaration.printout() } else { "" };
    let said = said + steps;
    let (subject, settings, sections) = asked(file);
    match slip(&sections, &subject, &settings) {
        Some(mistake) => Err(Fault::wrong(shown(&[mistake], &path.display().to_string(), &text))),
        None => Ok(said),
    }
}

/// A contact whose bodies slip on each other, at its name in the section of loads. A file without all numbers of the
/// motion is not looked at.
fn slip(sections: &Sections, subject: &Subject, settings: &Settings) -> Option<Mistake> {
    let (name, error) = subject.slip(&settings.typed().case(subject).ok()?)?;
    Some(Mistake::new(error.to_string(), sections.named("loads", &name)))
}

/// What a check finds.
pub(crate) struct Checked {
    /// The object for an editor.
    pub(crate) object: String,
    /// The number of mistakes in it.
    pub(crate) mistakes: usize,
    /// The mechanism, if it was compiled. It moves with a contact that slips, which is a mistake all the same.
    pub(crate) asked: Option<(Subject, Settings)>,
}

/// Checks a text.
pub(crate) fn checked(text: &str, name: &str) -> Checked {
    json::checked(name, text, KinFile::read(text))
}
