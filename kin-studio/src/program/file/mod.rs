//! `kin run`: mechanisms of people who write no Rust.

mod read;

use std::path::Path;

use super::fault::Fault;
use super::subject::Subject;
use read::KinFile;

/// What a file says besides the declaration.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Told {
    /// Dimensions and inputs that stand.
    pub(super) set: Vec<String>,
    /// Motions of inputs.
    pub(super) over: Vec<String>,
    /// The assembly.
    pub(super) assembly: Option<String>,
    /// The doc comment of the mechanism.
    pub(super) documentation: String,
    /// The declaration as it was typed.
    pub(super) declaration: String,
}

/// Reads a file, and compiles its declaration.
fn compiled(path: &Path) -> Result<KinFile, Fault> {
    crate::file::read(path, KinFile::read).map_err(Fault::wrong)
}

/// The mechanism of a file, and what the file says of it.
pub(super) fn read(path: &Path) -> Result<(Subject, Told), Fault> {
    let file = compiled(path)?;
    let told = Told {
        set: file.set,
        over: file.over,
        assembly: file.assembly,
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
