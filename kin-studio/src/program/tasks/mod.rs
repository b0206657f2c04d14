//! The commands, one file for each.

mod code;
mod cycle;
mod fit;
mod fmt;
mod forces;
mod import;
mod list;
mod peaks;
mod prove;
mod report;
mod serve;
mod show;
mod sweep;
mod table;
mod verify;
mod watch;

pub(super) use fmt::fmt;
pub(super) use import::import;
pub(super) use list::list;
pub(super) use watch::watch;

use std::path::Path;

use super::command::{Report, Setup, Task};
use crate::case::fault::Fault;
use crate::case::file::Settings;
use crate::case::subject::Subject;

/// Runs a command.
pub(super) fn run(subject: &Subject, task: &Task, settings: &Settings) -> Result<(), Fault> {
    if let Some(setup) = task.setup() {
        remark(subject, setup, settings);
    }
    let done = match task {
        Task::Show => show::run(subject, settings),
        Task::Sweep(options) => sweep::run(subject, options, settings),
        Task::Cycle(setup) => cycle::run(subject, setup, settings),
        Task::Peaks(options) => peaks::run(subject, options, settings),
        Task::Forces(options) => forces::run(subject, options, settings),
        Task::Verify(setup) => verify::run(subject, setup, settings),
        Task::Code(options) => code::run(subject, options, settings),
        Task::Fit(options) => fit::run(subject, options, settings),
        Task::Table(options) => table::run(subject, options, settings),
        Task::Report(options) => report::run(subject, options, settings),
        Task::Serve(options) => serve::run(subject, options, settings),
    };
    done.map_err(|fault| fault.map(|words| subject.named(words)))
}

/// The page of a mechanism. Its remarks are printed.
fn page(subject: &Subject, options: &Report, settings: &Settings) -> Result<String, Fault> {
    remark(subject, &options.setup, settings);
    report::page(subject, options, settings).map_err(|fault| fault.map(|words| subject.named(words)))
}

fn remark(subject: &Subject, setup: &Setup, settings: &Settings) {
    for (_, remark) in setup.typed(settings).remarks(subject) {
        eprintln!("note: {remark}");
    }
}

/// Writes to the output. A reader that has closed it, such as `head`, is no mistake.
pub(super) fn print(text: &str) -> Result<(), Fault> {
    use std::io::{ErrorKind, Write as _};
    let mut output = std::io::stdout().lock();
    let written = output.write_all(text.as_bytes()).and_then(|()| output.flush());
    match written {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(Fault::wrong(format!("the output cannot be written: {error}")))
        }
        _ => Ok(()),
    }
}

/// Writes a file, or to the output if its name is `-`.
fn write(path: &Path, text: &str) -> Result<(), Fault> {
    if path == Path::new("-") {
        return print(text);
    }
    std::fs::write(path, text)
        .map_err(|error| Fault::wrong(format!("{} cannot be written: {error}", path.display())))?;
    eprintln!("{}: {} bytes", path.display(), text.len());
    Ok(())
}
