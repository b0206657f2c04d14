//! The commands, one file for each.

mod code;
mod cycle;
mod fit;
mod fmt;
mod forces;
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
pub(super) use list::list;
pub(super) use watch::watch;

use std::path::Path;

use super::command::{Report, Setup, Task};
use super::fault::Fault;
use super::file::Told;
use super::subject::Subject;

/// Runs a command.
pub(super) fn run(subject: &Subject, task: &Task, told: &Told) -> Result<(), Fault> {
    if let Some(setup) = task.setup() {
        remark(subject, setup, told);
    }
    let done = match task {
        Task::Show => show::run(subject, told),
        Task::Sweep(options) => sweep::run(subject, options, told),
        Task::Cycle(setup) => cycle::run(subject, setup, told),
        Task::Peaks(options) => peaks::run(subject, options, told),
        Task::Forces(options) => forces::run(subject, options, told),
        Task::Verify(setup) => verify::run(subject, setup, told),
        Task::Code(options) => code::run(subject, options, told),
        Task::Fit(options) => fit::run(subject, options, told),
        Task::Table(options) => table::run(subject, options, told),
        Task::Report(options) => report::run(subject, options, told),
        Task::Serve(options) => serve::run(subject, options, told),
    };
    done.map_err(|fault| fault.map(|words| subject.named(words)))
}

/// The page of a mechanism. Its remarks are printed.
fn page(subject: &Subject, options: &Report, told: &Told) -> Result<String, Fault> {
    remark(subject, &options.setup, told);
    report::page(subject, options, told).map_err(|fault| fault.map(|words| subject.named(words)))
}

fn remark(subject: &Subject, setup: &Setup, told: &Told) {
    for (_, remark) in setup.typed(told).remarks(subject) {
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
