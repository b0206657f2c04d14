//! `scheduler`, `executor`, and the options of `query` for a cluster.

use std::net::{IpAddr, SocketAddr};
use std::path::PathBuf;

use kin_search::Functions;
use kin_search::cluster::{Client, Connection, Endpoint, Executor, Identity, Listen, Scheduler};

use super::fault::Fault;
use super::memory::bytes;

/// The options of `scheduler`.
#[derive(Debug, clap::Args)]
pub(crate) struct SchedulerArguments {
    /// Where to listen: an address of this machine, and a port after a colon, or a free port. Other machines reach only
    /// an address that they know; read the chapter on searches before you give one
    #[arg(long, value_name = "ADDRESS", value_parser = listen, default_value = "127.0.0.1")]
    listen: Listen,
    /// The name or address by which executors reach this machine, if it is not that on which it listens
    #[arg(long)]
    host: Option<String>,
    /// After how many seconds without a sign of life an executor is given up
    #[arg(long, default_value_t = Scheduler::default().patience)]
    patience: u64,
}

impl SchedulerArguments {
    pub(crate) async fn run(self, functions: &Functions) -> Result<(), Fault> {
        let scheduler = Scheduler {
            listen: self.listen,
            host: self.host,
            patience: self.patience,
        };
        Ok(scheduler.run(functions).await?)
    }
}

/// The options of `executor`.
#[derive(Debug, clap::Args)]
pub(crate) struct ExecutorArguments {
    /// The scheduler, as it has printed it
    #[arg(long, value_name = "HOST:PORT", value_parser = endpoint)]
    scheduler: Endpoint,
    /// Where to listen: an address of this machine, and a port after a colon, or a free port
    #[arg(long, value_name = "ADDRESS", value_parser = listen, default_value = "127.0.0.1")]
    listen: Listen,
    /// How many tasks are done at a time; one for each core of the machine if not given
    #[arg(long, value_parser = clap::builder::RangedU64ValueParser::<usize>::new().range(1..))]
    cores: Option<usize>,
    /// The memory that its tasks may take together, as in 512MB or 4GB. If not given, 70 % of the machine's memory for
    /// all cores, and as much less as it works on fewer tasks at a time
    #[arg(long, value_parser = bytes)]
    memory: Option<usize>,
    /// Where results of stages are kept until they are fetched; among the temporary files if not given
    #[arg(long, value_name = "FOLDER")]
    folder: Option<PathBuf>,
}

impl ExecutorArguments {
    pub(crate) async fn run(self, functions: &Functions) -> Result<(), Fault> {
        let executor = Executor {
            scheduler: self.scheduler,
            listen: self.listen,
            cores: self
                .cores
                .or_else(|| std::thread::available_parallelism().ok().map(usize::from))
                .unwrap_or(1)
                .max(1),
            memory: self.memory.map(|bytes| bytes as u64),
            folder: self.folder,
        };
        Ok(executor.run(functions).await?)
    }
}

/// The options of `query` for a cluster.
#[derive(Debug, clap::Args)]
pub(crate) struct ClusterArguments {
    /// Search on the cluster of this scheduler, and not in this process
    #[arg(long, value_name = "HOST:PORT", value_parser = endpoint)]
    cluster: Option<Endpoint>,
    /// Keep finished ranges of ids here: the same command goes on where it stopped
    #[arg(long, value_name = "FOLDER", requires = "cluster")]
    parts: Option<PathBuf>,
    /// How many ids a range has
    #[arg(long, value_name = "IDS", requires = "cluster", default_value_t = Client::RANGE)]
    #[arg(value_parser = clap::value_parser!(u64).range(1..))]
    range: u64,
    /// Into how many tasks a range is divided
    #[arg(long, requires = "cluster", default_value_t = Client::TASKS)]
    #[arg(value_parser = clap::value_parser!(u16).range(1..))]
    tasks: u16,
}

impl ClusterArguments {
    /// Whether there is to be a connection.
    pub(crate) fn is_given(&self) -> bool {
        self.cluster.is_some()
    }

    /// The connection to the cluster, if there is to be one.
    pub(crate) async fn connect(&self, functions: &Functions) -> Result<Option<Connection>, Fault> {
        let Some(scheduler) = self.cluster.clone() else {
            return Ok(None);
        };
        let client = Client {
            parts: self.parts.clone(),
            range: self.range,
            tasks: usize::from(self.tasks),
            ..Client::new(scheduler)
        };
        Ok(Some(client.connect(Identity::of(functions)).await?))
    }
}

/// `ADDRESS` or `ADDRESS:PORT`.
fn listen(text: &str) -> Result<Listen, String> {
    text.parse::<SocketAddr>()
        .or_else(|_| text.parse::<IpAddr>().map(|address| SocketAddr::new(address, 0)))
        .ok()
        .filter(SocketAddr::is_ipv4)
        .map(Listen)
        .ok_or_else(|| "write an address of IPv4 as `127.0.0.1`, or with a port as `127.0.0.1:50050`".to_owned())
}

/// `HOST:PORT`.
fn endpoint(text: &str) -> Result<Endpoint, String> {
    text.rsplit_once(':')
        .and_then(|(host, port)| {
            Some(Endpoint {
                host: host.to_owned(),
                port: port.parse().ok()?,
            })
        })
        .filter(|endpoint| !endpoint.host.is_empty() && !endpoint.host.contains(':'))
        .ok_or_else(|| "write it as `HOST:PORT`, for instance `127.0.0.1:50050`; IPv6 is not spoken".to_owned())
}
