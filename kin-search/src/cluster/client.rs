//! The process that runs queries.

use std::path::PathBuf;
use std::sync::Arc;

use ballista_core::config::BALLISTA_CLIENT_PULL;
use ballista_core::extension::{SessionConfigExt, SessionStateExt};
use datafusion::arrow::array::RecordBatch;
use datafusion::catalog::MemoryCatalogProviderList;
use datafusion::common::plan_err;
use datafusion::common::tree_node::TreeNodeRecursion;
use datafusion::datasource::listing::ListingTable;
use datafusion::datasource::source_as_provider;
use datafusion::execution::{SessionState, SessionStateBuilder};
use datafusion::functions_table::generate_series::GenerateSeriesTable;
use datafusion::logical_expr::{DdlStatement, LogicalPlan};
use datafusion::prelude::SessionContext;
use futures::{StreamExt, stream};
use kin_core::batch::Vectors;
use tokio::sync::watch;

use crate::function::Settings;
use crate::session::Signals;

use super::address::Endpoint;
use super::codec::Codec;
use super::cut::{Cut, named, rows_as};
use super::fault::Fault;
use super::identity::Identity;
use super::ids::{self, Ids};
use super::job::{self, End};
use super::options::Caller;
use super::parts::Parts;
use super::progress::Progress;
use super::stop::{Stop, reached};
use super::tables;
use crate::say;

/// The number of attempts of a query whose rows were lost with an executor after the query was finished.
const ATTEMPTS: usize = 5;

/// The number of executors that a running query may lose. One machine can fail. A query that loses a second executor
/// may itself be the cause.
const MOST_LOST: usize = 1;

/// The most ranges of a search. The scheduler keeps something of each.
const MOST_RANGES: i64 = 1_000_000;

/// The settings of a client.
#[derive(Clone, Debug)]
pub struct Client {
    /// The address of the scheduler.
    pub scheduler: Endpoint,
    /// The folder of finished ranges, by which the same search goes on where it stopped.
    pub parts: Option<PathBuf>,
    /// The number of ids of a range.
    pub range: u64,
    /// The number of ranges that are searched at a time: executors begin the next range while the last tasks of the
    /// range before are finished.
    pub at_once: usize,
    /// The number of tasks of a range.
    pub tasks: usize,
}

impl Client {
    /// The usual number of ids of a range.
    pub const RANGE: u64 = 1_000_000;
    /// The usual number of tasks of a range.
    pub const TASKS: u16 = 16;

    /// A client of a scheduler: ranges of a million ids in 16 tasks, two at a time, and nothing kept.
    #[must_use]
    pub fn new(scheduler: Endpoint) -> Self {
        Self {
            scheduler,
            parts: None,
            range: Self::RANGE,
            at_once: 2,
            tasks: usize::from(Self::TASKS),
        }
    }

    /// Waits for the scheduler.
    ///
    /// # Errors
    ///
    /// [`Fault`], if the program is interrupted before the scheduler is there.
    pub async fn connect(self, identity: Identity) -> Result<Connection, Fault> {
        let mut signals = Signals::listen().map_err(Fault::Signals)?;
        let (stop, stopped) = watch::channel(false);
        tokio::spawn(async move {
            signals.come().await;
            let _ = stop.send(true);
            // Receivers that come later see it too, as long as the channel is open.
            stop.closed().await;
        });
        let mut interrupted = stopped.clone();
        tokio::select! {
            () = reached(&mut interrupted) => Err(Fault::Interrupted { advice: String::new() }),
            () = self.scheduler.reach() => Ok(Connection {
                client: self,
                identity,
                stopped,
            }),
        }
    }
}

/// A client that has found its scheduler.
#[derive(Debug)]
pub struct Connection {
    client: Client,
    identity: Identity,
    stopped: watch::Receiver<bool>,
}

impl Connection {
    /// Runs on the cluster the part of a statement that reads ids or files, and returns the rest for this process.
    ///
    /// `create table … as`, `insert into` and `copy … to` fetch their rows from the cluster; the table or the file is
    /// in this process.
    ///
    /// # Errors
    ///
    /// [`Fault`]: the scheduler is lost or refuses this process, the query fails, or the program is interrupted.
    pub async fn plan(&self, session: &SessionContext, statement: LogicalPlan) -> Result<LogicalPlan, Fault> {
        let input = match &statement {
            LogicalPlan::Ddl(DdlStatement::CreateMemoryTable(create)) => &create.input,
            LogicalPlan::Copy(copy) => &copy.input,
            LogicalPlan::Dml(write) => &write.input,
            LogicalPlan::Ddl(_) | LogicalPlan::Statement(_) | LogicalPlan::Explain(_) | LogicalPlan::Analyze(_) => {
                return Ok(statement);
            }
            query => return self.query(session, query).await,
        };
        let input = self.query(session, input).await?;
        Ok(statement.with_new_exprs(statement.expressions(), vec![input])?)
    }

    async fn query(&self, session: &SessionContext, query: &LogicalPlan) -> Result<LogicalPlan, Fault> {
        let state = session.state();
        let query = ids::carry(query.clone())?;
        if !crosses(&query)? {
            return Ok(query);
        }
        let optimized = state.optimize(&query)?;
        let remote = self.remote(state)?;
        if let Some(cut) = Cut::of(&optimized) {
            return Ok(cut.join(&self.search(&remote, &cut).await?)?);
        }
        let all = all_ids(&optimized)?;
        say(format_args!("searching {all} ids in one query"));
        let progress = Progress::new(all);
        let stop = Stop {
            interrupted: self.stopped.clone(),
            search: None,
        };
        let rows = self.job(&remote, &optimized, "query", &progress, None, stop).await?;
        progress.finished("query", all);
        Ok(rows_as(&optimized, &rows)?)
    }

    /// The rows of all ranges, in their order.
    async fn search(&self, remote: &SessionState, cut: &Cut) -> Result<Vec<RecordBatch>, Fault> {
        let parts = match &self.client.parts {
            Some(folder) => Some(Parts::open(
                folder,
                &format!("{}\n{}\n{}", self.identity.tag(), vectors(remote), cut.text()?),
            )?),
            None => None,
        };
        let length = i64::try_from(self.client.range).unwrap_or(i64::MAX);
        let count = cut.ids.count_of_pieces(length);
        if count > MOST_RANGES {
            return Ok(plan_err!(
                "the {} ids of the search are {count} ranges of {length}, and a cluster searches {MOST_RANGES} ranges \
                 at most; make them larger with `--range`, or search fewer ids",
                cut.ids.count()
            )?);
        }
        let ranges: Vec<_> = cut.ids.pieces(length).collect();
        ranges.iter().try_for_each(|range| range.check())?;
        let mut found = Vec::with_capacity(ranges.len());
        for range in &ranges {
            found.push(match &parts {
                Some(parts) => parts.read(*range)?,
                None => None,
            });
        }
        let kept = found.iter().flatten().count();
        if let Some(parts) = &parts
            && kept > 0
        {
            say(format_args!(
                "{kept} of {} ranges were finished before, in {}",
                ranges.len(),
                parts.folder().display()
            ));
        }
        let columns = cut.columns();
        let left = ranges.iter().zip(&found).filter(|(_, found)| found.is_none());
        let progress = Progress::new(left.map(|(range, _)| range.count()).sum());
        let count = ranges.len();
        say(format_args!("searching {} ids in {count} ranges", cut.ids.count()));
        let (fail, failed) = watch::channel(false);
        let searches = ranges
            .into_iter()
            .zip(found)
            .enumerate()
            .map(|(number, (range, found))| {
                let (parts, columns, progress, fail) = (parts.as_ref(), &columns, &progress, &fail);
                let stop = Stop {
                    interrupted: self.stopped.clone(),
                    search: Some(failed.clone()),
                };
                let search = async move {
                    if let Some(rows) = found {
                        return Ok(rows);
                    }
                    let name = format!("range {} of {count}", number + 1);
                    let rows = self
                        .job(remote, &cut.query(range)?, &name, progress, parts, stop)
                        .await?
                        .into_iter()
                        .map(|rows| named(columns, &rows))
                        .collect::<Result<Vec<_>, _>>()?;
                    if let Some(parts) = parts {
                        parts.write(range, columns, &rows)?;
                    }
                    progress.finished(&name, range.count());
                    Ok::<_, Fault>(rows)
                };
                async move {
                    let rows = search.await;
                    if rows.is_err() {
                        // The other ranges are called off.
                        fail.send_replace(true);
                    }
                    rows
                }
            });
        // Every range that has begun is waited for: it calls its work off.
        let ranges: Vec<Result<Vec<RecordBatch>, Fault>> = stream::iter(searches)
            .buffered(self.client.at_once.max(1))
            .collect()
            .await;
        all_rows(ranges)
    }

    /// Waits until the process is interrupted.
    pub async fn interrupted(&self) {
        reached(&mut self.stopped.clone()).await;
    }

    /// One query on the cluster; again, if an executor was lost.
    async fn job(
        &self,
        remote: &SessionState,
        query: &LogicalPlan,
        name: &str,
        progress: &Progress,
        parts: Option<&Parts>,
        stop: Stop,
    ) -> Result<Vec<RecordBatch>, Fault> {
        let (mut attempt, mut lost) = (1, 0);
        loop {
            let end = match job::run(remote, query, &self.url(), name, progress, stop.clone()).await {
                Ok(rows) => return Ok(rows),
                Err(end) => end,
            };
            let error = match end {
                End::Interrupted => return Err(Fault::Interrupted { advice: advice(parts) }),
                End::Lost(report) => {
                    return Err(Fault::Lost {
                        scheduler: self.client.scheduler.clone(),
                        report,
                        advice: advice(parts),
                    });
                }
                End::Restarted => {
                    return Err(Fault::Restarted {
                        scheduler: self.client.scheduler.clone(),
                        advice: advice(parts),
                    });
                }
                End::Another => return Err(Fault::Another(self.client.scheduler.clone())),
                End::CalledOff if lost == MOST_LOST => {
                    return Err(Fault::Executors {
                        name: name.to_owned(),
                        count: lost + 1,
                        advice: advice(parts),
                    });
                }
                End::CalledOff => {
                    lost += 1;
                    say(format_args!("{name}: an executor was lost; it is searched again"));
                    continue;
                }
                End::Gone(_) if attempt < ATTEMPTS => {
                    attempt += 1;
                    say(format_args!(
                        "{name}: its rows were lost with an executor; it is searched again"
                    ));
                    continue;
                }
                End::Gone(error) | End::Failed(error) => error,
            };
            let text = error.to_string();
            let known = Fault::refusal(&self.identity, &text).or_else(|| Fault::memory(&text));
            return Err(known.unwrap_or_else(|| error.into()));
        }
    }

    /// The session's state, for queries on the cluster.
    fn remote(&self, state: SessionState) -> Result<SessionState, Fault> {
        let settings = state.config().options().extensions.get::<Settings>();
        let vectors = match settings.map(|settings| settings.vectors.as_str()) {
            // All executors round as this machine does.
            None | Some("widest") => format!("{:?}", Vectors::widest()).to_lowercase(),
            Some(vectors) => vectors.to_owned(),
        };
        let caller = Caller {
            identity: self.identity.tag().to_owned(),
            vectors,
        };
        let config = state
            .config()
            .clone()
            .with_option_extension(caller)
            .with_ballista_logical_extension_codec(Arc::new(Codec::default()))
            // Ballista's own settings come first: it leaves them out if one of them is there.
            .upgrade_for_ballista()
            // The adaptive planner of Ballista 55 does not end a stage whose rows were lost with an executor, and made
            // again.
            .with_ballista_adaptive_query_planner(false)
            // The client asks for the state of its job. It would learn the job's number with the first change of this
            // state otherwise, too late to call the job off.
            .set_bool(BALLISTA_CLIENT_PULL, true)
            .with_target_partitions(self.client.tasks.max(1));
        // Ballista replaces a catalog in the list that its state holds. It gets a list of its own, so that the local
        // tables stay.
        let state = SessionStateBuilder::new_from_existing(state)
            .with_config(config)
            .with_catalog_list(Arc::new(MemoryCatalogProviderList::new()))
            .build();
        Ok(state.upgrade_for_ballista(self.url())?)
    }

    fn url(&self) -> String {
        format!("http://{}", self.client.scheduler)
    }
}

/// The rows of all ranges, or the error for which the search ended. Ranges that were called off because of this error
/// do not report it.
fn all_rows(ranges: Vec<Result<Vec<RecordBatch>, Fault>>) -> Result<Vec<RecordBatch>, Fault> {
    let mut rows = Vec::new();
    let mut called_off = None;
    for range in ranges {
        match range {
            Ok(found) => rows.extend(found),
            Err(fault @ Fault::Interrupted { .. }) => called_off = Some(fault),
            Err(fault) => return Err(fault),
        }
    }
    called_off.map_or(Ok(rows), Err)
}

/// The kind of vectors that a query fixes.
fn vectors(remote: &SessionState) -> &str {
    let caller = remote.config().options().extensions.get::<Caller>();
    caller.map_or("", |caller| &caller.vectors)
}

/// The advice on how an unfinished search goes on.
fn advice(parts: Option<&Parts>) -> String {
    match parts {
        Some(parts) => format!(
            "Finished ranges are kept in {}: the same command goes on from there.",
            parts.folder().display()
        ),
        None => "Nothing is kept; with `--parts FOLDER` the same command goes on where it stopped.".to_owned(),
    }
}

/// Whether a query reads ids or files, which executors can read as well. Small tables of this process go with the
/// query, and large ones are refused.
fn crosses(query: &LogicalPlan) -> Result<bool, Fault> {
    let (mut there, mut only_here, mut series) = (false, None, false);
    query.apply_with_subqueries(|node| {
        if let LogicalPlan::TableScan(scan) = node {
            let provider = source_as_provider(&scan.source)?;
            let table: &dyn std::any::Any = provider.as_ref();
            if table.is::<Ids>() || table.is::<ListingTable>() {
                there = true;
            } else if table.is::<GenerateSeriesTable>() {
                series = true;
            } else if provider.get_logical_plan().is_none() && !tables::is_small(provider.as_ref()) {
                only_here = Some(scan.table_name.to_string());
            }
        }
        Ok(TreeNodeRecursion::Continue)
    })?;
    match only_here {
        Some(table) if there => Ok(plan_err!(
            "The table {table} is only in this process. It is too large to go with the query. Write it as Parquet with \
             `copy`, and read the file."
        )?),
        _ if there && series => Ok(plan_err!(
            "a range with another step than 1 does not go to a cluster; write range(first, end) and calculate with its \
             value"
        )?),
        _ => Ok(there),
    }
}

/// All ids that a query reads, if they are no more than executors can list.
fn all_ids(query: &LogicalPlan) -> Result<i64, Fault> {
    let mut count = 0_i64;
    query.apply_with_subqueries(|node| {
        if let Some(ids) = ids::scanned(node) {
            ids.check()?;
            count = count.saturating_add(ids.count());
        }
        Ok(TreeNodeRecursion::Continue)
    })?;
    Ok(count)
}
