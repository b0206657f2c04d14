//! The process that asks.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use ballista_core::extension::{SessionConfigExt, SessionStateExt};
use datafusion::arrow::array::RecordBatch;
use datafusion::catalog::MemoryCatalogProviderList;
use datafusion::common::plan_err;
use datafusion::common::tree_node::TreeNodeRecursion;
use datafusion::datasource::listing::ListingTable;
use datafusion::datasource::source_as_provider;
use datafusion::execution::{SessionState, SessionStateBuilder};
use datafusion::logical_expr::{DdlStatement, LogicalPlan};
use datafusion::prelude::SessionContext;
use futures::{StreamExt, TryStreamExt, stream};
use kin_core::batch::Vectors;
use tokio::net::TcpStream;
use tokio::sync::watch;
use tokio::time::sleep;

use crate::function::Settings;

use super::codec::Codec;
use super::cut::{Cut, named, rows_as};
use super::fault::Fault;
use super::identity::Identity;
use super::ids::{self, Ids};
use super::job::{self, End};
use super::options::Caller;
use super::parts::Parts;
use super::progress::Progress;
use super::signals::Signals;
use super::tables;

/// How often a range is tried whose rows were lost with an executor.
const ATTEMPTS: usize = 3;

/// How a client searches.
#[derive(Clone, Debug)]
pub struct Client {
    /// Host and port of the scheduler.
    pub scheduler: (String, u16),
    /// Where finished ranges are kept, so that the same search goes on where it stopped.
    pub parts: Option<PathBuf>,
    /// How many ids a range has.
    pub range: u64,
    /// How many ranges are searched at a time: while the last tasks of one are finished, executors begin the next.
    pub at_once: usize,
    /// Into how many tasks a range is divided.
    pub tasks: usize,
}

impl Client {
    /// A client of a scheduler: ranges of a million ids in 16 tasks, two at a time, and nothing kept.
    #[must_use]
    pub fn new(scheduler: (String, u16)) -> Self {
        Self {
            scheduler,
            parts: None,
            range: 1_000_000,
            at_once: 2,
            tasks: 16,
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
        let (host, port) = (self.scheduler.0.clone(), self.scheduler.1);
        let mut said = false;
        while TcpStream::connect((host.as_str(), port)).await.is_err() {
            if !said {
                eprintln!("waiting for the scheduler at {host}:{port}");
                said = true;
            }
            tokio::select! {
                _ = interrupted.wait_for(|stop| *stop) => {
                    return Err(Fault::Interrupted { advice: String::new() });
                }
                () = sleep(Duration::from_millis(300)) => {}
            }
        }
        Ok(Connection {
            client: self,
            identity,
            stopped,
        })
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
    /// Does on the cluster what a statement reads there, and gives what is left of it for this process.
    ///
    /// What reads ids or files is done on the cluster, and nothing else. `create table … as` and `copy … to` fetch their
    /// rows from the cluster; the table or the file is made in this process.
    ///
    /// # Errors
    ///
    /// [`Fault`]: the scheduler is lost or refuses this process, the query fails, or the program is interrupted.
    pub async fn plan(&self, session: &SessionContext, statement: LogicalPlan) -> Result<LogicalPlan, Fault> {
        let input = match &statement {
            LogicalPlan::Ddl(DdlStatement::CreateMemoryTable(create)) => &create.input,
            LogicalPlan::Copy(copy) => &copy.input,
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
        let all = all_ids(&optimized);
        eprintln!("searching {all} ids in one query");
        let progress = Progress::new(all);
        let rows = self.job(&remote, &optimized, "query", &progress, None).await?;
        progress.finished("query", all);
        Ok(rows_as(&optimized, &rows)?)
    }

    /// The rows of all ranges, in their order.
    async fn search(&self, remote: &SessionState, cut: &Cut) -> Result<Vec<RecordBatch>, Fault> {
        let parts = match &self.client.parts {
            Some(folder) => Some(Parts::open(
                folder,
                &format!("{}\n{}\n{}", self.identity.tag(), vectors(remote), cut.text()),
            )?),
            None => None,
        };
        let length = i64::try_from(self.client.range).unwrap_or(i64::MAX);
        let ranges: Vec<_> = cut.ids.pieces(length).collect();
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
            eprintln!(
                "{kept} of {} ranges were finished before, in {}",
                ranges.len(),
                parts.folder().display()
            );
        }
        let columns = cut.columns();
        let left = ranges.iter().zip(&found).filter(|(_, found)| found.is_none());
        let progress = Progress::new(left.map(|(range, _)| range.count()).sum());
        let count = ranges.len();
        eprintln!("searching {} ids in {count} ranges", cut.ids.count());
        let searches = ranges
            .into_iter()
            .zip(found)
            .enumerate()
            .map(|(number, (range, found))| {
                let (parts, columns, progress) = (parts.as_ref(), &columns, &progress);
                async move {
                    if let Some(rows) = found {
                        return Ok(rows);
                    }
                    let name = format!("range {} of {count}", number + 1);
                    let rows = self
                        .job(remote, &cut.query(range)?, &name, progress, parts)
                        .await?
                        .into_iter()
                        .map(|rows| named(columns, &rows))
                        .collect::<Result<Vec<_>, _>>()?;
                    if let Some(parts) = parts {
                        parts.write(range, columns, &rows)?;
                    }
                    progress.finished(&name, range.count());
                    Ok::<_, Fault>(rows)
                }
            });
        let rows: Vec<Vec<RecordBatch>> = stream::iter(searches)
            .buffered(self.client.at_once.max(1))
            .try_collect()
            .await?;
        Ok(rows.into_iter().flatten().collect())
    }

    /// One query on the cluster; again, if its rows were lost with an executor.
    async fn job(
        &self,
        remote: &SessionState,
        query: &LogicalPlan,
        name: &str,
        progress: &Progress,
        parts: Option<&Parts>,
    ) -> Result<Vec<RecordBatch>, Fault> {
        let mut attempt = 1;
        loop {
            let end = match job::run(remote, query, &self.url(), name, progress, self.stopped.clone()).await {
                Ok(rows) => return Ok(rows),
                Err(end) => end,
            };
            let error = match end {
                End::Interrupted => return Err(Fault::Interrupted { advice: advice(parts) }),
                End::Lost(report) => {
                    return Err(Fault::Lost {
                        scheduler: format!("{}:{}", self.client.scheduler.0, self.client.scheduler.1),
                        report,
                        advice: advice(parts),
                    });
                }
                End::Gone(_) if attempt < ATTEMPTS => {
                    attempt += 1;
                    eprintln!("{name}: its rows were lost with an executor; it is searched again");
                    continue;
                }
                End::Gone(error) | End::Failed(error) => error,
            };
            let text = error.to_string();
            return Err(match text.find("refused: ") {
                Some(at) => Fault::Refused {
                    here: self.identity.to_string(),
                    there: first_line(&text[at..]),
                },
                None => error.into(),
            });
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
            .with_target_partitions(self.client.tasks.max(1));
        // Ballista replaces a catalog in the list that its state holds. It gets a list of its own, so that the local tables stay.
        let state = SessionStateBuilder::new_from_existing(state)
            .with_config(config)
            .with_catalog_list(Arc::new(MemoryCatalogProviderList::new()))
            .build();
        Ok(state.upgrade_for_ballista(self.url())?)
    }

    fn url(&self) -> String {
        format!("http://{}:{}", self.client.scheduler.0, self.client.scheduler.1)
    }
}

/// What a process has said, without what the errors around it add: these quote it.
pub(super) fn first_line(text: &str) -> String {
    text.split(['"', '\\', '\n']).next().unwrap_or_default().to_owned()
}

/// The kind of vectors that a query fixes.
fn vectors(remote: &SessionState) -> &str {
    let caller = remote.config().options().extensions.get::<Caller>();
    caller.map_or("", |caller| &caller.vectors)
}

/// How an unfinished search goes on.
fn advice(parts: Option<&Parts>) -> String {
    match parts {
        Some(parts) => format!(
            "Finished ranges are kept in {}: the same command goes on from there.",
            parts.folder().display()
        ),
        None => "Nothing is kept; with `--parts FOLDER` the same command goes on where it stopped.".to_owned(),
    }
}

/// Whether a query reads ids or files, which executors can read as well. Small tables of this process go with the query, and large ones
/// are refused.
fn crosses(query: &LogicalPlan) -> Result<bool, Fault> {
    let (mut there, mut only_here) = (false, None);
    query.apply_with_subqueries(|node| {
        if let LogicalPlan::TableScan(scan) = node {
            let provider = source_as_provider(&scan.source)?;
            let table: &dyn std::any::Any = provider.as_ref();
            if table.is::<Ids>() || table.is::<ListingTable>() {
                there = true;
            } else if provider.get_logical_plan().is_none() && !tables::is_small(provider.as_ref()) {
                only_here = Some(scan.table_name.to_string());
            }
        }
        Ok(TreeNodeRecursion::Continue)
    })?;
    match only_here {
        Some(table) if there => Ok(plan_err!(
            "the table {table} is in this process only, is too large to go with a query, and the query reads others on the cluster; write it as Parquet with `copy`, and read the file"
        )?),
        _ => Ok(there),
    }
}

/// All ids that a query reads.
fn all_ids(query: &LogicalPlan) -> i64 {
    let mut count = 0;
    // The closure does not fail.
    let _ = query.apply_with_subqueries(|node| {
        count += ids::scanned(node).map_or(0, Ids::count);
        Ok(TreeNodeRecursion::Continue)
    });
    count
}
