//! The program: a mechanism's sweeps, cycles, peaks, code and pages from the command line.
//!
//! [`main`] makes a program of a declared mechanism, [`library()`] is the binary `kin`.

mod advice;
mod command;
mod progress;
mod server;
mod tasks;
mod text;

use crate::case::subject::Subject;

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::error::ErrorKind;
use clap::{Arg, ArgAction, Command, FromArgMatches, Subcommand};
use clap_complete::Shell;
use kin_core::{Mechanism, in_small_letters};

use crate::case::fault::{Fault, similar};
use crate::case::file::{self, Settings};
use command::{FORCES, Task};

use crate::library::DESIGNS;

/// A program of one mechanism: reads the arguments, does what they say, and returns the code to end with.
///
/// ```no_run
/// use kin_core::prelude::*;
///
/// mechanism! {
///     /// A slider-crank, driven at its slider.
///     pub struct Pump { pub crank: Length, pub rod: Length }
///     input s: Length;
///     unknown theta: Angle, phi: Angle;
///     crank * cis(theta) + rod * cis(phi) == vec2(s, 0);
/// }
///
/// fn main() -> std::process::ExitCode {
///     kin_studio::main::<Pump>()
/// }
/// ```
///
/// Then `cargo run -- sweep --set crank=30mm --set rod=80mm --over 60..100mm` prints a table, and `cargo run -- --help`
/// explains the rest.
#[must_use]
pub fn main<M: Mechanism<Scalar = f64>>() -> ExitCode {
    let subject = Subject::of::<M>();
    let arguments: Vec<OsString> = std::env::args_os().collect();
    let name = program_name(&arguments);
    let about = format!("The mechanism {}", subject.description().name);
    let done = task_of_one_mechanism(about, &name, &arguments).and_then(|task| match task {
        Some(task) => tasks::run(&subject, &task, &Settings::default()),
        None => Ok(()),
    });
    ended(done)
}

/// The program of the library's mechanisms. Each is called by its name in small letters, with or without underscores.
#[must_use]
pub fn library() -> ExitCode {
    let arguments: Vec<OsString> = std::env::args_os().collect();
    ended(run_library(&arguments))
}

/// Prints the reason why the program failed.
fn ended(result: Result<(), Fault>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!(
                "{} {fault}",
                console::Style::new().for_stderr().red().bold().apply_to("error:")
            );
            fault.code()
        }
    }
}

/// The command line that all programs have in common.
fn base(name: &str) -> Command {
    Command::new(name.to_owned())
        .version(env!("CARGO_PKG_VERSION"))
        .after_help(command::EXIT_CODES)
        .subcommand_required(true)
        .arg_required_else_help(true)
        .max_term_width(100)
}

/// The command that writes completions, after all others.
fn completed(command: Command, name: &str) -> Command {
    command.subcommand(
        Command::new("completions")
            .about("Write the completions of a shell")
            .arg(
                Arg::new("shell")
                    .required(true)
                    .value_parser(clap::value_parser!(Shell)),
            )
            .after_help(format!("Example:\n  {name} completions bash > completions.bash")),
    )
}

fn completions(command: &mut Command, name: &str, matches: &clap::ArgMatches) -> Result<(), Fault> {
    // the crate panics where it cannot write, so it writes into memory
    let mut script = Vec::new();
    if let Some(shell) = matches.get_one::<Shell>("shell") {
        clap_complete::generate(*shell, command, name, &mut script);
    }
    tasks::print(&String::from_utf8_lossy(&script))
}

/// Help and the version go to the output and are no mistake.
fn parsed(command: &Command, arguments: &[OsString], has_library: bool) -> Result<clap::ArgMatches, Fault> {
    command.clone().try_get_matches_from(arguments).or_else(|error| {
        let code = match error.kind() {
            ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => 0,
            _ => 2,
        };
        if code != 0
            && let Some(advice) = advice::advice(arguments, has_library)
        {
            return Err(Fault::wrong(advice));
        }
        // a closed output is no reason to fail
        let _ = error.print();
        std::process::exit(code)
    })
}

/// The name under which the program was called.
fn program_name(arguments: &[OsString]) -> String {
    let path = arguments.first().map(std::path::Path::new);
    let stem = path.and_then(|path| path.file_stem()).and_then(|stem| stem.to_str());
    stem.unwrap_or("kin").to_owned()
}

/// The task of a program of one mechanism, unless all is done already.
fn task_of_one_mechanism(about: String, name: &str, arguments: &[OsString]) -> Result<Option<Task>, Fault> {
    let command = completed(Task::augment_subcommands(base(name)).about(about), name);
    let mut command = command::with_examples(command, name, "").bin_name(name);
    let matches = parsed(&command, arguments, false)?;
    if let Some(("completions", matches)) = matches.subcommand() {
        return completions(&mut command, name, matches).map(|()| None);
    }
    Task::from_arg_matches(&matches).map(Some).map_err(Fault::wrong)
}

fn run_library(arguments: &[OsString]) -> Result<(), Fault> {
    let mut command = library_command();
    let matches = parsed(&command, arguments, true)?;
    match matches.subcommand() {
        Some(("completions", matches)) => completions(&mut command, "kin", matches),
        Some(("list", _)) => tasks::list(),
        Some(("check", given)) => {
            let path = given.get_one::<PathBuf>("file").cloned().unwrap_or_default();
            if !given.get_flag("json") {
                return tasks::print(&file::check(&path, given.get_flag("steps"))?);
            }
            let text = crate::file::text_of(&path).map_err(Fault::wrong)?;
            let checked = file::checked(&text, &path.display().to_string());
            tasks::print(&checked.object)?;
            match checked.mistakes {
                0 => Ok(()),
                1 => Err(Fault::wrong("there is a mistake")),
                count => Err(Fault::wrong(format!("there are {count} mistakes"))),
            }
        }
        Some(("fmt", given)) => {
            let path = given.get_one::<PathBuf>("file").cloned().unwrap_or_default();
            tasks::fmt(&path, given.get_flag("check"))
        }
        Some(("import", given)) => {
            let from = given.get_one::<String>("from").map_or("", String::as_str);
            let output = given.get_one::<PathBuf>("output").cloned();
            tasks::import(from, &output.unwrap_or_else(|| PathBuf::from("-")))
        }
        Some((name, given)) => {
            let wanted = given.get_one::<String>("mechanism").map_or("", String::as_str);
            let task = || Task::from_arg_matches(&matches).map_err(Fault::wrong);
            if advice::is_file(wanted) {
                return run_file(Path::new(wanted), &task()?);
            }
            if name == FORCES {
                return Err(Fault::wrong(
                    "forces follow from the loads of a file: write `kin forces FILE.kin`",
                ));
            }
            let subject = match (find(wanted), advice::advice(arguments, true)) {
                (Err(_), Some(advice)) => return Err(Fault::wrong(advice)),
                (found, _) => found?,
            };
            tasks::run(&subject, &task()?, &Settings::default())
        }
        None => Ok(()),
    }
}

fn library_command() -> Command {
    let about = "Sweeps, cycles, peaks, code and pages of mechanisms";
    let command = base("kin").subcommand(
        Command::new("list")
            .about("List the mechanisms of the library")
            .after_help("Example:\n  kin list"),
    );
    let mut command = completed(of_files(Task::augment_subcommands(command).about(about)), "kin");
    for name in Task::NAMES {
        command = command.mut_subcommand(name, |subcommand| {
            let subcommand = subcommand.arg(
                Arg::new("mechanism")
                    .required(true)
                    .index(1)
                    .help("The mechanism: a name of `kin list`, or a .kin file"),
            );
            if name == "code" {
                subcommand.mut_arg("language", |language| language.index(2))
            } else {
                subcommand
            }
        });
    }
    command::with_examples(command, "kin", "four_bar")
}

/// The name of a `.kin` file.
fn file_argument() -> Arg {
    Arg::new("file")
        .required(true)
        .value_name("FILE.kin")
        .value_parser(clap::value_parser!(PathBuf))
}

/// The commands that build `.kin` files.
fn of_files(command: Command) -> Command {
    command
        .subcommand(
            Command::new("check")
                .about("Find the mistakes of a .kin file")
                .arg(
                    Arg::new("steps")
                        .long("steps")
                        .action(ArgAction::SetTrue)
                        .help("Print the steps of the solvers with their costs"),
                )
                .arg(
                    Arg::new("json")
                        .long("json")
                        .action(ArgAction::SetTrue)
                        .conflicts_with("steps")
                        .help("Print the mistakes, or an outline, as one JSON object for editors"),
                )
                .arg(file_argument().help("The file, `-` for the input"))
                .after_help(
                    "Examples:\n  kin check pump.kin\n  kin check pump.kin --steps\n  kin check - --json < pump.kin",
                ),
        )
        .subcommand(
            Command::new("fmt")
                .about("Format a .kin file in place")
                .arg(
                    Arg::new("check")
                        .long("check")
                        .action(ArgAction::SetTrue)
                        .help("Change nothing, and end with code 1 if the file is in another form"),
                )
                .arg(file_argument().help("The file, or `-` for the input, which is formatted to the output"))
                .after_help("Examples:\n  kin fmt pump.kin\n  kin fmt --check pump.kin"),
        )
        .subcommand(
            Command::new("import")
                .about("Write a .kin file from a file of pylinkage, PMKS, PMKS+ or Linkage")
                .arg(
                    Arg::new("from")
                        .required(true)
                        .value_name("FILE")
                        .help("JSON of pylinkage 1.3, text of PMKS, `.linkage2`, or an address of PMKS+ in quotes"),
                )
                .arg(
                    Arg::new("output")
                        .short('o')
                        .long("output")
                        .value_name("FILE.kin")
                        .value_parser(clap::value_parser!(PathBuf))
                        .help("The file [default: the output]"),
                )
                .after_help(
                    "Examples:\n  kin import leg.json -o leg.kin\n  \
                     kin import 'https://app.pmksplus.com/?2P.Ay…' -o press.kin",
                ),
        )
}

fn run_file(path: &Path, task: &Task) -> Result<(), Fault> {
    if let Task::Serve(options) = task {
        return tasks::watch(path, options);
    }
    let (subject, settings) = file::read(path)?;
    tasks::run(&subject, task, &settings)
}

fn find(wanted: &str) -> Result<Subject, Fault> {
    let plain = |name: &str| name.replace(['_', '-', ' '], "").to_lowercase();
    if let Some(found) = DESIGNS.iter().find(|design| plain(design.name) == plain(wanted)) {
        return Subject::of_library(found);
    }
    let names = DESIGNS.iter().map(|design| in_small_letters(design.name, '_'));
    let names: Vec<String> = names.collect();
    let close = similar(wanted, names.iter().map(String::as_str));
    let hint = if Path::new(wanted).is_file() {
        "the name of a file ends in `.kin`".to_owned()
    } else if close.starts_with("did you mean") {
        close
    } else {
        "`kin list` shows all names".to_owned()
    };
    Err(Fault::wrong(format!("the library has no mechanism `{wanted}`; {hint}")))
}
