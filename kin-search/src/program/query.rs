//! `query`: the statements of a file, one after the other.

use std::fs;
use std::future::pending;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use datafusion::arrow::array::RecordBatch;
use datafusion::dataframe::{DataFrame, DataFrameWriteOptions};
use datafusion::datasource::MemTable;
use datafusion::logical_expr::LogicalPlan;
use datafusion::prelude::SessionContext;
use kin_search::session::{Drafts, Signals, plan, rows, statements};
use kin_search::{Functions, Options, say, session};
use url::Url;

use super::declared::DeclaredArguments;
use super::fault::{Fault, INTERRUPTED};
use super::memory::bytes;
use super::print::to_output;
use super::table::write_table;

/// The options of `query`.
#[derive(Debug, clap::Args)]
pub(crate) struct QueryArguments {
    /// The file of SQL; several statements are separated by semicolons
    file: PathBuf,
    /// Write the rows of the last statement to this file, by its ending: .parquet, .csv or .json
    #[arg(long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// The memory that a query may take in this process, as in 512MB or 4GB
    #[arg(long, value_parser = bytes)]
    memory: Option<usize>,
    /// How many cores of this machine work; all if not given. Executors of a cluster have a limit of their own
    #[arg(long, value_parser = clap::builder::RangedU64ValueParser::<usize>::new().range(1..))]
    cores: Option<usize>,
    #[command(flatten)]
    declared: DeclaredArguments,
    #[cfg(feature = "refine")]
    #[command(flatten)]
    pages: super::pages::PagesArguments,
    #[cfg(feature = "cluster")]
    #[command(flatten)]
    cluster: super::cluster::ClusterArguments,
}

/// The form of a file of rows.
#[derive(Clone, Copy, Debug)]
enum Form {
    Parquet,
    Csv,
    Json,
}

impl Form {
    fn of(path: &Path) -> Result<Self, Fault> {
        match path.extension().and_then(|ending| ending.to_str()) {
            Some("parquet") => Ok(Self::Parquet),
            Some("csv") => Ok(Self::Csv),
            Some("json") => Ok(Self::Json),
            _ => Err(Fault::Wrong(format!(
                "{} does not end with .parquet, .csv or .json, so its form is not known",
                path.display()
            ))),
        }
    }
}

/// Answers the queries, unless Ctrl-C is pressed or SIGTERM comes before. Files that are not whole are removed.
pub(crate) async fn run(arguments: QueryArguments, functions: &Functions) -> Result<(), Fault> {
    let options = Options {
        memory: arguments.memory,
        partitions: arguments.cores,
    };
    let functions = &arguments.declared.join(functions)?;
    let session = session(functions, &options)?;
    let drafts = Drafts::of(&session);
    let mut signals = Signals::listen().map_err(|error| Fault::Wrong(format!("cannot listen for signals: {error}")))?;
    let begun = Arc::clone(&drafts);
    // A search on a cluster hears the first signal itself, and calls the work of the executors off. The second one does
    // not wait for that.
    #[cfg(feature = "cluster")]
    let is_first_heard = arguments.cluster.is_given();
    #[cfg(not(feature = "cluster"))]
    let is_first_heard = false;
    // A task of its own hears the signal while the query keeps this thread busy. The process ends at once: nobody waits
    // for rows that are not wanted any more.
    tokio::spawn(async move {
        signals.come().await;
        if is_first_heard {
            signals.come().await;
        } else {
            say(format_args!("{}", Fault::Interrupted));
        }
        begun.discard();
        std::process::exit(INTERRUPTED.into());
    });
    let answered = answer(&arguments, functions, &session, &drafts).await;
    if answered.is_err() {
        drafts.discard();
    }
    answered
}

#[cfg_attr(
    not(feature = "cluster"),
    expect(unused_variables, reason = "the processes of a cluster compare their functions")
)]
async fn answer(
    arguments: &QueryArguments,
    functions: &Functions,
    session: &SessionContext,
    drafts: &Drafts,
) -> Result<(), Fault> {
    let form = arguments.output.as_deref().map(Form::of).transpose()?;
    let sql = fs::read_to_string(&arguments.file)
        .map_err(|error| Fault::Wrong(format!("{} cannot be read: {error}", arguments.file.display())))?;
    #[cfg(feature = "cluster")]
    let cluster = arguments.cluster.connect(functions).await?;
    let mut statements = statements(&sql)?;
    if statements.is_empty() {
        return Err(Fault::Wrong(format!("{} has no statement", arguments.file.display())));
    }
    while let Some(statement) = statements.pop_front() {
        let plan = plan(session, statement).await?;
        #[cfg(feature = "cluster")]
        let plan = match &cluster {
            Some(cluster) => cluster.plan(session, plan).await?,
            None => plan,
        };
        #[cfg(feature = "cluster")]
        let interrupted = async {
            match &cluster {
                Some(cluster) => cluster.interrupted().await,
                None => pending().await,
            }
        };
        #[cfg(not(feature = "cluster"))]
        let interrupted = pending::<()>();
        tokio::select! {
            done = finish(session, drafts, plan, arguments, form, statements.is_empty()) => done?,
            () = interrupted => return Err(Fault::Interrupted),
        }
    }
    Ok(())
}

/// Runs the rest of a statement in this process. The rows of the last statement go to the file and the pages that are
/// wanted.
async fn finish(
    session: &SessionContext,
    drafts: &Drafts,
    plan: LogicalPlan,
    arguments: &QueryArguments,
    form: Option<Form>,
    is_last: bool,
) -> Result<(), Fault> {
    let start = Instant::now();
    let frame = session.execute_logical_plan(with_address(plan)?).await?;
    let output = arguments.output.as_deref().zip(form).filter(|_| is_last);
    #[cfg(feature = "refine")]
    let has_pages = arguments.pages.are_wanted() && is_last;
    #[cfg(not(feature = "refine"))]
    let has_pages = false;
    let seconds = || start.elapsed().as_secs_f64();
    match output {
        Some((path, form)) if !has_pages => {
            write(frame, path, form).await?;
            publish(drafts)?;
            say(format_args!("{} is written in {:.2} s", path.display(), seconds()));
        }
        _ => {
            let schema = Arc::clone(frame.schema().inner());
            let rows = rows(frame).await?;
            publish(drafts)?;
            if let Some((path, form)) = output {
                let table = MemTable::try_new(schema, vec![rows.clone()])?;
                write(session.read_table(Arc::new(table))?, path, form).await?;
                publish(drafts)?;
                say(format_args!("{} is written in {:.2} s", path.display(), seconds()));
            } else if !schema.fields().is_empty() {
                to_output(|output| write_table(output, &schema, &rows))?;
                let count: usize = rows.iter().map(RecordBatch::num_rows).sum();
                say(format_args!("{count} rows in {:.2} s", seconds()));
            }
            #[cfg(feature = "refine")]
            if has_pages {
                arguments.pages.write(&rows, &arguments.declared)?;
            }
        }
    }
    Ok(())
}

/// Gives the files of a statement their names.
fn publish(drafts: &Drafts) -> Result<(), Fault> {
    drafts
        .publish()
        .map_err(|(path, error)| Fault::Wrong(format!("{} cannot be written: {error}", path.display())))
}

/// Writes rows to a file, which is a draft until it is [published](publish).
async fn write(frame: DataFrame, path: &Path, form: Form) -> Result<(), Fault> {
    let address = address(path)?;
    let options = DataFrameWriteOptions::new().with_single_file_output(true);
    match form {
        Form::Parquet => frame.write_parquet(address.as_str(), options, None).await,
        Form::Csv => frame.write_csv(address.as_str(), options, None).await,
        Form::Json => frame.write_json(address.as_str(), options, None).await,
    }?;
    Ok(())
}

/// The address of a file. The engine takes some letters of a path for patterns, and does not in an address.
fn address(path: &Path) -> Result<Url, Fault> {
    let address = std::path::absolute(path)
        .ok()
        .and_then(|path| Url::from_file_path(path).ok());
    address.ok_or_else(|| Fault::Wrong(format!("{} is no path of a file", path.display())))
}

/// A statement with the address of the file to which it copies, if the path has letters of patterns.
fn with_address(plan: LogicalPlan) -> Result<LogicalPlan, Fault> {
    Ok(match plan {
        LogicalPlan::Copy(mut copy)
            if copy.output_url.contains(['?', '*', '[']) && Url::parse(&copy.output_url).is_err() =>
        {
            copy.output_url = address(Path::new(&copy.output_url))?.into();
            LogicalPlan::Copy(copy)
        }
        other => other,
    })
}
