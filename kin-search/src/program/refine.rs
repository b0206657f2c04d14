//! `refine`: the best candidates of a query, polished and checked.

use std::fmt::Display;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

use datafusion::parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use kin_core::Mechanism;
use kin_core::any::Of;
use kin_fit::{Job, polish};
use kin_search::pages::write_pages;
use kin_search::say;

use super::fault::Fault;
use super::mechanisms::of_mechanism;
use super::print::{print, separated};

/// What `refine` takes.
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
}

/// Prints the results as comma-separated values, and what was dropped to the standard error.
pub(crate) fn run(arguments: &RefineArguments) -> Result<(), Fault> {
    let job = Job::read(&text(&arguments.job)?).map_err(wrong)?;
    let candidates = table(&arguments.candidates)?;
    of_mechanism!(&job.mechanism, |M| refined::<M>(arguments, &job, &candidates))
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

fn refined<M: Mechanism<Scalar = f64>>(arguments: &RefineArguments, job: &Job, candidates: &str) -> Result<(), Fault> {
    let functions = Of::<M>::FUNCTIONS;
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
        for path in write_pages::<M>(&found, &objective, folder).map_err(wrong)? {
            say(format_args!("{}", path.display()));
        }
    }
    Ok(())
}
