//! `kin run`: mechanisms of people who write no Rust.

mod build;
pub(super) mod cache;
mod place;
mod read;
mod watch;

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use serde::{Deserialize, Serialize};

use super::fault::Fault;
use build::Builder;
use read::KinFile;
pub(super) use watch::watch;

/// What a program that was built from a file is told before its command.
#[derive(Clone, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
pub(super) struct Told {
    /// What the person typed up to the command.
    pub(super) program: String,
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

/// A file with its text. Its mistakes are found before anything is built.
fn read(path: &Path) -> Result<(KinFile, String), Fault> {
    let shown = path.display().to_string();
    let text = std::fs::read_to_string(path).map_err(|error| {
        Fault::wrong(match error.kind() {
            std::io::ErrorKind::NotFound => format!("there is no file {shown}"),
            std::io::ErrorKind::InvalidData => format!("{shown} is no text in UTF-8"),
            _ => format!("{shown} cannot be read: {error}"),
        })
    })?;
    // a byte order mark, and line ends of other systems
    let text = text.trim_start_matches('\u{feff}').replace("\r\n", "\n");
    let file = KinFile::read(&text).map_err(|mistakes| {
        let shown: Vec<String> = mistakes.iter().map(|mistake| mistake.shown(&shown, &text)).collect();
        Fault::build(shown.join("\n\n"))
    })?;
    Ok((file, text))
}

/// What is said of a file without mistakes: its mechanism, and the steps of its solvers where they are wanted.
pub(super) fn check(path: &Path, steps: bool) -> Result<String, Fault> {
    let (file, _) = read(path)?;
    let said = format!("{}: {} has no mistakes\n", path.display(), file.name);
    let steps = if steps { file.compiled.printout() } else { "" };
    Ok(said + steps)
}

/// A file that is to be run.
#[derive(Clone, Debug)]
pub(super) struct Run {
    /// The path of the file.
    pub(super) path: PathBuf,
    builder: Builder,
}

impl Run {
    pub(super) fn new(path: &Path, source: Option<&Path>, fetches: bool) -> Result<Self, Fault> {
        Ok(Self {
            path: path.to_owned(),
            builder: Builder::new(source, fetches)?,
        })
    }

    /// The command of the built program, to which the arguments of the person are added.
    pub(super) fn command(&self) -> Result<Command, Fault> {
        let shown = self.path.display().to_string();
        let (file, text) = read(&self.path)?;
        let program = self.builder.program(&file, &shown, &text)?;
        let told = Told {
            program: format!("kin run {shown}"),
            set: file.set,
            over: file.over,
            assembly: file.assembly,
            documentation: file.documentation,
            declaration: file.declaration,
        };
        let told = serde_json::to_string(&told).map_err(Fault::build)?;
        let mut command = Command::new(program);
        command.arg(told);
        Ok(command)
    }

    /// Runs the program with the person's arguments, and returns its code.
    pub(super) fn run(&self, arguments: &[OsString]) -> Result<std::process::ExitCode, Fault> {
        let mut command = self.command()?;
        let status = command
            .args(arguments)
            .status()
            .map_err(|error| Fault::build(format!("what was built cannot be run: {error}")))?;
        let code = status.code().and_then(|code| u8::try_from(code).ok()).unwrap_or(3);
        Ok(code.into())
    }
}
