//! `refine`: the best candidates of a query, polished and checked.

use std::fmt::Display;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

use datafusion::parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use kin_fit::{Job, polish};
use kin_search::pages::{RefinedFunctions, write_pages};
use kin_search::{Functions, say};

use super::declared::DeclaredArguments;
use super::fault::Fault;
use super::mechanisms::mechanism;
use super::print::{print, separated};

/// The options of `refine`.
#[derive(Debug, clap::Args)]
pub(crate) struct RefineArguments {
    /// The job: a file of JSON with the targets and the bounds
    job: PathBuf,
    /// The candidates: a file .csv or .parquet that `query --output` has written, the best ones first
    #[arg(long, value_name = "FILE")]
    candidates: PathBuf,
    /// Refine this many of the first rows, each in all its assemblies; all if not given
    #[arg(long, value_name = "COUNT")]
    best: Option<usize>,
    /// Write a page for each result into this folder
    #[arg(long, value_name = "FOLDER")]
    pages: Option<PathBuf>,
    /// How many threads work, which has no influence on the results; all cores if not given
    #[arg(long, value_name = "COUNT")]
    threads: Option<usize>,
    #[command(flatten)]
    declared: DeclaredArguments,
}

/// Prints the results as comma-separated values, and what was dropped to the standard error.
pub(crate) fn run(arguments: &RefineArguments, functions: &Functions) -> Result<(), Fault> {
    let job = Job::read(&text(&arguments.job)?).map_err(wrong)?;
    let candidates = table(&arguments.candidates)?;
    // names that are taken are refused as for a query
    arguments.declared.join(functions)?;
    let functions = mechanism(&job.mechanism, &arguments.declared)?;
    refined(arguments, functions, &job, &candidates)
}

fn text(path: &Path) -> Result<String, Fault> {
    fs::read_to_string(path).map_err(|error| Fault::Wrong(format!("{} cannot be read: {error}", path.display())))
}

/// A file of rows as comma-separated values.
fn table(path: &Path) -> Result<String, Fault> {
    if path.extension().is_none_or(|ending| ending != "parquet") {
        return text(path);
    }
    let unread = |error: &dyn Display| Fault::Wrong(format!("{} cannot be read: {error}", path.display()));
    let file = File::open(path).map_err(|error| unread(&error))?;
    let rows = ParquetRecordBatchReaderBuilder::try_new(file).and_then(ParquetRecordBatchReaderBuilder::build);
    let rows: Result<Vec<_>, _> = rows.map_err(|error| unread(&error))?.collect();
    separated(&rows.map_err(|error| unread(&error))?)
}

fn wrong(error: impl std::fmt::Display) -> Fault {
    Fault::Wrong(error.to_string())
}

fn refined(
    arguments: &RefineArguments,
    functions: &'static dyn RefinedFunctions,
    job: &Job,
    candidates: &str,
) -> Result<(), Fault> {
    let objective = job.objective(functions).map_err(wrong)?;
    let best = arguments.best.unwrap_or(usize::MAX);
    let candidates = job.candidates(functions, candidates, best).map_err(wrong)?;
    let found = polish(&objective, &candidates, &job.settings(arguments.threads.unwrap_or(0))).map_err(wrong)?;
    print(&found.table())?;
    say(format_args!(
        "{} candidates, {} kept",
        candidates.len(),
        found.results.len()
    ));
    for (kind, count) in found.counts() {
        say(format_args!("{count} dropped: {kind}"));
    }
    if let Some(folder) = &arguments.pages {
        for path in write_pages(functions, &found, &objective, folder).map_err(wrong)? {
            say(format_args!("{}", path.display()));
        }
    }
    Ok(())
}
