//! The commands and their options.

use std::path::PathBuf;

use clap::{Args, Subcommand, ValueEnum};

use crate::case::Typed;
use crate::case::file::Settings;
use crate::case::language::Language;

/// The command that takes a file instead of a mechanism of the library, which has no loads.
pub(crate) const FORCES: &str = "forces";

/// The commands for a mechanism.
#[derive(Clone, Debug, Subcommand)]
pub(crate) enum Task {
    /// Show the dimensions, inputs, unknowns, outputs and assemblies
    Show,
    /// Solve many poses over the motion, as a table, CSV or JSON
    Sweep(Sweep),
    /// Find all circuits and branches with their limits
    Cycle(Setup),
    /// Find the extremes of every quantity and its rates, between the rows and to rounding
    Peaks(Peaks),
    /// Find the forces in the joints of a .kin file, and the efforts of its drives
    Forces(Forces),
    /// Compare the solver with two independent oracles
    Verify(Setup),
    /// Write the solver in C, JavaScript or Python
    Code(Code),
    /// Fit dimensions to points of a path or to values of an unknown
    Fit(Fit),
    /// Write a table from which every position can be read, exact to a tolerance
    Table(ExactTable),
    /// Write a page on which the mechanism moves, one file without network
    Report(Report),
    /// Show that page in a browser on this machine
    Serve(Serve),
}

impl Task {
    /// The names of the commands that take a mechanism.
    pub(crate) const NAMES: [&'static str; 11] = [
        "show", "sweep", "cycle", "peaks", FORCES, "verify", "code", "fit", "table", "report", "serve",
    ];

    /// The dimensions, the motion and the assembly, where they are asked for.
    pub(crate) fn setup(&self) -> Option<&Setup> {
        match self {
            Self::Show | Self::Code(_) => None,
            Self::Sweep(Sweep { setup, .. })
            | Self::Peaks(Peaks { setup, .. })
            | Self::Forces(Forces { setup, .. })
            | Self::Fit(Fit { setup, .. })
            | Self::Table(ExactTable { setup, .. })
            | Self::Report(Report { setup, .. })
            | Self::Serve(Serve { setup, .. })
            | Self::Cycle(setup)
            | Self::Verify(setup) => Some(setup),
        }
    }
}

/// Dimensions, motion and assembly.
#[derive(Args, Clone, Debug, Default)]
pub(crate) struct Setup {
    /// A dimension, or an input that stands: `r1=90`, `r1=45mm`, `gamma=30deg`, `p=(1.4, 1.5)`
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    set: Vec<String>,
    /// The range of an input: `0..360deg`, `alpha=0..90deg`, `0..360deg at 60rpm`, `0..90deg by cycloidal in 0.4s`;
    /// parts have commas between them, as in `0..90deg at 60rpm, rest 0.1s`
    #[arg(long, value_name = "[NAME=]RANGE", allow_hyphen_values = true)]
    over: Vec<String>,
    /// The speed of the input that moves: `1500rpm`, `10rad/s`, `20mm/s` [default: 1 rad/s, or 1 by second]
    #[arg(long, conflicts_with = "law")]
    speed: Option<String>,
    /// A motion law from rest to rest: `cycloidal`, `modified-sine`, `3-4-5`, `4-5-6-7`, `5-6-7-8-9` …
    #[arg(long)]
    law: Option<String>,
    /// The time of the motion: `0.4s`, `400ms`
    #[arg(long, conflicts_with = "speed")]
    time: Option<String>,
    /// The assembly: `open`, `knee=open,foot=crossed`, or values of the unknowns nearby: `theta3=20deg,theta4=110deg`.
    /// Several have `or` between them: `open or crossed`, `all`
    #[arg(long, allow_hyphen_values = true)]
    assembly: Option<String>,
    /// The unit of lengths, if it is not that of the first length with a unit
    #[arg(long, value_name = "UNIT")]
    units: Option<String>,
    /// Show angles in radians instead of degrees
    #[arg(long)]
    radians: bool,
}

impl Setup {
    /// The typed case, in which options follow the statements of the file.
    pub(crate) fn typed(&self, settings: &Settings) -> Typed {
        let mut typed = settings.typed();
        typed.set.extend_from_slice(&self.set);
        typed.over.extend_from_slice(&self.over);
        Typed {
            speed: self.speed.clone(),
            law: self.law.clone(),
            time: self.time.clone(),
            assembly: self.assembly.clone().or(typed.assembly),
            units: self.units.clone(),
            radians: self.radians,
            ..typed
        }
    }
}

/// Options of `sweep`.
#[derive(Args, Clone, Debug)]
pub(crate) struct Sweep {
    #[command(flatten)]
    pub(crate) setup: Setup,
    /// The number of rows [default: 13 as text, 361 in a file]
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..=10_000_000))]
    pub(crate) rows: Option<u32>,
    /// The columns, such as `theta4,theta4_jerk`, or `all` [default: those of the file, or as text those that fit]
    #[arg(long, value_delimiter = ',', value_name = "NAMES")]
    pub(crate) columns: Vec<String>,
    /// Write CSV, to a file or to the output
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-")]
    pub(crate) csv: Option<PathBuf>,
    /// Write JSON, to a file or to the output
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-", conflicts_with = "csv")]
    pub(crate) json: Option<PathBuf>,
}

/// Options of `peaks`.
#[derive(Args, Clone, Debug)]
pub(crate) struct Peaks {
    #[command(flatten)]
    pub(crate) setup: Setup,
    /// The quantities, such as `theta4` or `theta4_jerk`, or `all` [default: the file's columns, or all]
    #[arg(long, value_delimiter = ',', value_name = "NAMES")]
    pub(crate) of: Vec<String>,
}

/// Options of `forces`.
#[derive(Args, Clone, Debug)]
pub(crate) struct Forces {
    #[command(flatten)]
    pub(crate) setup: Setup,
    /// Prove a limit of a force over all inputs, and not only in rows: `knee_force <= 3kN`, `theta_effort <= 50Nm`
    #[arg(long, value_name = "FORCE <= LIMIT", conflicts_with = "csv")]
    pub(crate) prove: Vec<String>,
    /// A tolerance of a dimension, up and down, over which limits are proved: `crank=0.1mm`
    #[arg(long, value_name = "NAME=VALUE", requires = "prove")]
    pub(crate) tolerance: Vec<String>,
    /// Write CSV, to a file or to the output
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-")]
    pub(crate) csv: Option<PathBuf>,
    /// Write JSON, to a file or to the output
    #[arg(long, value_name = "FILE", num_args = 0..=1, default_missing_value = "-", conflicts_with = "csv")]
    pub(crate) json: Option<PathBuf>,
}

/// Options of `code`.
#[derive(Args, Clone, Debug)]
pub(crate) struct Code {
    /// The language
    #[arg(value_enum)]
    pub(crate) language: Language,
    /// The folder of the files
    #[arg(long, short, default_value = ".")]
    pub(crate) output: PathBuf,
    /// The highest derivative: 0 is the position [default: that of the mechanism]
    #[arg(long)]
    pub(crate) order: Option<usize>,
    /// Find the joints of the skeleton as well
    #[arg(long)]
    pub(crate) skeleton: bool,
    /// Make the dimensions constants of the code
    #[arg(long)]
    pub(crate) constants: bool,
    /// A dimension, which makes all dimensions constants of the code
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub(crate) set: Vec<String>,
}

/// Options of `fit`.
#[derive(Args, Clone, Debug)]
pub(crate) struct Fit {
    #[command(flatten)]
    pub(crate) setup: Setup,
    /// CSV with a column for the input and columns for unknowns or outputs: `theta2 [deg],point.x,point.y`
    #[arg(long, value_name = "FILE")]
    pub(crate) data: PathBuf,
    /// The dimensions that may change [default: all]
    #[arg(long, value_delimiter = ',', value_name = "NAMES")]
    pub(crate) vary: Vec<String>,
    /// The bounds of a dimension, such as `r2=10..50` [default: a quarter to four times a length, ± half a turn]
    #[arg(long, value_name = "NAME=RANGE", allow_hyphen_values = true)]
    pub(crate) within: Vec<String>,
}

/// Options of `table`.
#[derive(Args, Clone, Debug)]
pub(crate) struct ExactTable {
    #[command(flatten)]
    pub(crate) setup: Setup,
    /// The largest error of every order, as a part of the size of the column in that order
    #[arg(long, default_value_t = 1e-6)]
    pub(crate) tolerance: f64,
    /// The highest derivative [default: that of the mechanism]
    #[arg(long, value_parser = clap::value_parser!(u8).range(1..=4))]
    pub(crate) order: Option<u8>,
    /// The form of the file
    #[arg(long, value_enum, default_value_t = Form::Binary)]
    pub(crate) form: Form,
    /// The file [default: the name of the mechanism]
    #[arg(long, short)]
    pub(crate) output: Option<PathBuf>,
}

/// The form of an exact table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Form {
    /// The bytes that `kin_core::exact` reads in place
    Binary,
    /// JSON
    Json,
}

/// Options of `report`.
#[derive(Args, Clone, Debug)]
pub(crate) struct Report {
    #[command(flatten)]
    pub(crate) setup: Setup,
    /// The file, `-` for the output [default: the name of the mechanism]
    #[arg(long, short)]
    pub(crate) output: Option<PathBuf>,
    /// The title [default: the name of the mechanism]
    #[arg(long)]
    pub(crate) title: Option<String>,
    /// The unknowns and outputs that are plotted at first [default: all]
    #[arg(long, value_delimiter = ',', value_name = "NAMES")]
    pub(crate) plots: Vec<String>,
}

/// Options of `serve`.
#[derive(Args, Clone, Debug)]
pub(crate) struct Serve {
    #[command(flatten)]
    setup: Setup,
    /// The title [default: the name of the mechanism]
    #[arg(long)]
    title: Option<String>,
    /// The unknowns and outputs that are plotted at first [default: all]
    #[arg(long, value_delimiter = ',', value_name = "NAMES")]
    plots: Vec<String>,
    /// The port on 127.0.0.1 [default: a free one]
    #[arg(long)]
    pub(crate) port: Option<u16>,
}

impl Serve {
    /// The page that is shown.
    pub(crate) fn page(&self) -> Report {
        Report {
            setup: self.setup.clone(),
            output: None,
            title: self.title.clone(),
            plots: self.plots.clone(),
        }
    }
}

/// The command of a mechanism, with examples under its help.
pub(crate) fn with_examples(command: clap::Command, program: &str, mechanism: &str) -> clap::Command {
    let mut command = command;
    for name in Task::NAMES {
        let lines = match name {
            "show" => &["show {m}"][..],
            "sweep" => &[
                "sweep {m} --over 0..360deg --speed 1500rpm",
                "sweep {m} --columns theta4,theta4_jerk --rows 25",
                "sweep {m} --over 0..90deg --law modified-sine --time 0.4s --csv turn.csv",
            ],
            "cycle" => &["cycle {m}", "cycle {m} --set r2=45mm"],
            "peaks" => &[
                "peaks {m} --speed 1500rpm",
                "peaks {m} --of theta4_jerk --over 0..180deg",
            ],
            FORCES => &[
                "forces {m}",
                "forces {m} --speed 300rpm --csv forces.csv",
                "forces {m} --prove 'knee_force <= 3kN' --tolerance crank=0.1mm",
            ],
            "verify" => &["verify {m}", "verify {m} --over -100..100deg"],
            "code" => &[
                "code {m} c -o firmware",
                "code {m} js --order 2",
                "code {m} python --skeleton",
            ],
            "table" => &[
                "table {m} --tolerance 1e-9",
                "table {m} --over 0..90deg --form json -o turn.json",
            ],
            "report" => &["report {m}", "report {m} --set r2=45mm --speed 1500rpm -o page.html"],
            "serve" => &["serve {m}", "serve {m} --set r2=45mm --port 8080"],
            _ => &[
                "fit {m} --data wanted.csv",
                "fit {m} --data wanted.csv --vary r2,r3 --within r2=10..50",
            ],
        };
        let examples: Vec<String> = lines
            .iter()
            .map(|line| {
                let mechanism = match (name, mechanism) {
                    (FORCES, arguments) if !arguments.is_empty() => "press.kin",
                    (_, arguments) => arguments,
                };
                let line = if mechanism.is_empty() {
                    line.replace(" {m}", "")
                } else {
                    line.replace("{m}", mechanism)
                };
                format!("  {program} {line}")
            })
            .collect();
        let text = format!("Examples:\n{}", examples.join("\n"));
        command = command.mut_subcommand(name, |subcommand| subcommand.after_help(text));
    }
    command
}

/// The text under the help of the program.
pub(crate) const EXIT_CODES: &str = "Exit codes:
  0  done
  1  the mechanism does not close somewhere it was asked for, or a fit ended before a minimum;
     what closes is printed or written; or `fmt --check` finds another form, or a limit is not proved
  2  something was typed wrong, or a file cannot be read or written";
