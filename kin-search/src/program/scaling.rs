//! `scaling`: one search in this process, on one executor, and on several.

use std::io::{BufRead, BufReader};
use std::net::Ipv4Addr;
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::time::Instant;

use datafusion::arrow::array::{ArrayRef, RecordBatch};
use datafusion::arrow::compute::concat_batches;
use datafusion::arrow::datatypes::Schema;
use datafusion::prelude::SessionContext;
use kin_search::cluster::{Client, Connection, Endpoint, Identity};
use kin_search::{Functions, Options, session};

use super::fault::Fault;
use super::processor::{loopback_bytes, seconds};

/// The options of `scaling`.
#[derive(Debug, clap::Args)]
pub(crate) struct ScalingArguments {
    /// How many four-bars are searched, each over a revolution of the crank
    #[arg(long, default_value_t = 4_000_000)]
    pub(crate) ids: u64,
    /// The largest number of executors
    #[arg(long, default_value_t = 2)]
    pub(crate) executors: usize,
}

/// The cost of a search on executors.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cost {
    /// The ids for each second of an executor's processor.
    pub(crate) rate: f64,
    /// The ranges of ids that were searched.
    pub(crate) ranges: f64,
    /// The processor time of the scheduler.
    pub(crate) scheduler: f64,
    /// The bytes that have gone over the wire.
    pub(crate) bytes: f64,
}

impl ScalingArguments {
    pub(crate) async fn run(self, functions: &Functions) -> Result<(), Fault> {
        self.measure(functions).await.map(drop)
    }

    /// Prints a line for each number of executors, and gives the cost with all of them.
    pub(crate) async fn measure(&self, functions: &Functions) -> Result<Option<Cost>, Fault> {
        let query = query(self.ids);
        println!("{} ids, each with a revolution of 360 poses\n", self.ids);
        println!("                      seconds   processor s        ids/s   ids per processor second");
        let here = session(functions, &Options::default())?;
        let (began, spent) = (Instant::now(), seconds("self"));
        let rows = here.sql(&query).await?.collect().await?;
        let one = self.print("in process", began, since("self", spent));
        let mut cost = None;
        for executors in 1..=self.executors {
            let scheduler = Process::start(&["scheduler"])?;
            let workers = (0..executors)
                .map(|_| Process::start(&["executor", "--cores", "1", "--scheduler", &scheduler.address]))
                .collect::<Result<Vec<_>, _>>()?;
            let (_, port) = scheduler.address.rsplit_once(':').unwrap_or_default();
            let client = Client::new(Endpoint {
                host: Ipv4Addr::LOCALHOST.to_string(),
                port: port.parse().map_err(wrong)?,
            });
            let ranges = self.ids.div_ceil(client.range.max(1));
            let connection = client.connect(Identity::of(functions)).await?;
            let session = session(functions, &Options::default())?;
            // An executor is slow to begin with: the first query meets it while it joins.
            let began = Instant::now();
            answer(&session, &connection, &self::query(1)).await?;
            let first = began.elapsed();
            let before = workers.iter().map(Process::seconds).sum::<Option<f64>>();
            let (of_scheduler, bytes) = (scheduler.seconds(), loopback_bytes());
            let began = Instant::now();
            let found = answer(&session, &connection, &query).await?;
            let after = workers.iter().map(Process::seconds).sum::<Option<f64>>();
            let spent = after.zip(before).map(|(after, before)| after - before);
            let share = self.print(&format!("executors: {executors}"), began, spent);
            if let Some((one, share)) = one.zip(share) {
                println!(
                    "                      {:.2} of the ids per processor second of one process",
                    share / one
                );
            }
            println!(
                "                      first answer after {:.0} ms",
                first.as_secs_f64() * 1e3
            );
            let of_scheduler = since(&scheduler.child.id().to_string(), of_scheduler);
            let bytes = loopback_bytes().zip(bytes).map(|(after, before)| after - before);
            if let (Some(rate), Some(scheduler), Some(bytes)) = (share, of_scheduler, bytes) {
                let ranges = f64::from(u32::try_from(ranges).unwrap_or(u32::MAX));
                println!(
                    "                      {ranges} ranges, each with {:.0} ms of the scheduler and {:.0} kB over the \
                     wire",
                    1e3 * scheduler / ranges,
                    1e-3 * bytes / ranges
                );
                cost = Some(Cost {
                    rate,
                    ranges,
                    scheduler,
                    bytes,
                });
            }
            if columns(&found)? != columns(&rows)? {
                println!("                      the rows differ from those in process");
            }
        }
        Ok(cost)
    }

    /// Prints a line, and gives the ids per second of a processor.
    #[expect(clippy::cast_precision_loss, reason = "counts of ids are far below 2^53")]
    fn print(&self, name: &str, began: Instant, processor: Option<f64>) -> Option<f64> {
        let seconds = began.elapsed().as_secs_f64();
        let ids = self.ids as f64;
        let share = processor.filter(|spent| *spent > 0.0).map(|spent| ids / spent);
        let or_none =
            |value: Option<f64>, digits: usize| value.map_or("-".to_owned(), |value| format!("{value:.digits$}"));
        println!(
            "{name:<20} {seconds:>8.2} {:>13} {:>12.0} {:>26}",
            or_none(processor, 2),
            ids / seconds,
            or_none(share, 0)
        );
        share
    }
}

/// The processor time of a process since a time.
fn since(process: &str, before: Option<f64>) -> Option<f64> {
    seconds(process).zip(before).map(|(after, before)| after - before)
}

/// The rows of a query on a cluster.
async fn answer(session: &SessionContext, connection: &Connection, query: &str) -> Result<Vec<RecordBatch>, Fault> {
    let plan = session.state().create_logical_plan(query).await?;
    let plan = connection.plan(session, plan).await?;
    Ok(session.execute_logical_plan(plan).await?.collect().await?)
}

/// The columns of some rows.
fn columns(rows: &[RecordBatch]) -> Result<Vec<ArrayRef>, Fault> {
    let schema = rows
        .first()
        .map_or_else(|| Arc::new(Schema::empty()), RecordBatch::schema);
    let all = concat_batches(&schema, rows).map_err(wrong)?;
    Ok(all.columns().to_vec())
}

/// The five four-bars with the largest swing of the rocker among those whose crank makes full revolutions: a revolution
/// is solved for each id.
fn query(ids: u64) -> String {
    format!(
        "select id, turn['theta4_swing'] as swing from (
            select value as id, four_bar_turn(1.0, 0.1 + 0.4 * (value % 1009) / 1009.0,
                0.7 + 0.7 * (value % 997) / 997.0, 0.6 + 0.8 * (value % 991) / 991.0) as turn from range(0, {ids}))
        where turn['rotates'] order by swing desc, id limit 5"
    )
}

/// A process of this program, which ends with the value.
struct Process {
    child: Child,
    address: String,
}

impl Process {
    fn start(arguments: &[&str]) -> Result<Self, Fault> {
        let mut child = Command::new(std::env::current_exe().map_err(wrong)?)
            .args(arguments)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .map_err(wrong)?;
        let stream = child.stdout.take();
        let mut process = Self {
            child,
            address: String::new(),
        };
        let mut lines = stream.map(BufReader::new).into_iter().flat_map(BufRead::lines);
        for line in lines.by_ref() {
            if let Some(address) = line.map_err(wrong)?.strip_prefix("listening on ") {
                address.clone_into(&mut process.address);
                return Ok(process);
            }
        }
        Err(wrong(format!("`{}` has ended", arguments.join(" "))))
    }

    fn seconds(&self) -> Option<f64> {
        seconds(&self.child.id().to_string())
    }
}

fn wrong(error: impl std::fmt::Display) -> Fault {
    Fault::Wrong(error.to_string())
}

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
