//! The process that works.

use std::path::PathBuf;
use std::pin::pin;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::time::Duration;
use std::{fs, io};

use ballista_core::error::BallistaError;
use ballista_core::registry::BallistaFunctionRegistry;
use ballista_executor::executor_process::{ExecutorProcessConfig, start_executor_process};
use ballista_executor::executor_server::TERMINATING;
use datafusion::functions_nested::all_default_nested_functions;
use tokio::net::TcpStream;
use tokio::time::{sleep, timeout};

use crate::function::Functions;

use super::address::{Listen, announce};
use super::client::first_line;
use super::fault::Fault;
use super::identity::{Identity, executor_name};
use super::scheduler::settings;
use super::signals::Signals;

/// Between two attempts to reach the scheduler.
const PAUSE: Duration = Duration::from_millis(300);

/// How long an executor that was told to end may work on.
const GRACE: Duration = Duration::from_secs(5);

/// How an executor runs.
#[derive(Clone, Debug)]
pub struct Executor {
    /// Host and port of the scheduler.
    pub scheduler: (String, u16),
    /// Where it listens. The port is that of the results; orders come to a free port beside it.
    pub listen: Listen,
    /// How many tasks it works on at a time.
    pub cores: usize,
    /// Where it keeps results of stages until they are fetched; a folder of its own in that for temporary files if not given.
    pub folder: Option<PathBuf>,
}

impl Executor {
    /// Runs the executor until SIGINT or SIGTERM.
    ///
    /// It waits for the scheduler, prints `listening on ADDRESS`, and waits again if the scheduler is lost.
    ///
    /// # Errors
    ///
    /// [`Fault`], if the scheduler refuses the executor, or if Ballista reports an error.
    pub async fn run(self, functions: &Functions) -> Result<(), Fault> {
        if let Some(warning) = self.listen.warning() {
            eprintln!("{warning}");
        }
        let identity = Identity::of(functions);
        eprintln!("{identity}");
        let mut registry = BallistaFunctionRegistry::default();
        // Ballista's own registry lacks the functions of lists, with which ids are made.
        let nested = all_default_nested_functions();
        for function in functions.iter().chain(&nested) {
            registry
                .scalar_functions
                .insert(function.name().to_owned(), Arc::clone(function));
        }
        let registry = Arc::new(registry);
        let mut signals = Signals::listen().map_err(Fault::Signals)?;
        loop {
            tokio::select! {
                () = signals.come() => return Ok(()),
                () = self.reach() => {}
            }
            let name = executor_name(&identity);
            let folder = Folder::new(self.folder.clone(), &name)?;
            let port = match self.listen.0.port() {
                0 => self.listen.free_port(),
                port => Ok(port),
            };
            let orders = self.listen.free_port();
            let (port, orders) = (
                port.map_err(|error| Fault::Address(self.listen, error))?,
                orders.map_err(|error| Fault::Address(self.listen, error))?,
            );
            let config = ExecutorProcessConfig {
                executor_id: name,
                bind_host: self.listen.ip().to_string(),
                port,
                grpc_port: orders,
                scheduler_host: self.scheduler.0.clone(),
                scheduler_port: self.scheduler.1,
                vcores: self.cores,
                work_dir: Some(folder.0.display().to_string()),
                executor_heartbeat_interval_seconds: 1,
                override_function_registry: Some(Arc::clone(&registry)),
                override_config_producer: Some(Arc::new(settings)),
                ..ExecutorProcessConfig::default()
            };
            announce((self.listen.ip(), port).into());
            TERMINATING.store(false, Ordering::Release);
            let mut work = pin!(start_executor_process(Arc::new(config)));
            let worked = tokio::select! {
                worked = &mut work => worked,
                () = signals.come() => {
                    // The executor has heard the same signal: it tells the scheduler, and finishes its tasks.
                    let _ = timeout(GRACE, work).await;
                    return Ok(());
                }
            };
            match worked {
                // The scheduler was lost.
                Ok(()) | Err(BallistaError::GrpcConnectionError(_) | BallistaError::TonicError(_)) => {
                    eprintln!(
                        "the scheduler at {}:{} is lost; waiting for it",
                        self.scheduler.0, self.scheduler.1
                    );
                }
                // Another process took one of the ports.
                Err(BallistaError::IoError(error)) if error.kind() == io::ErrorKind::AddrInUse => {}
                Err(error) => return Err(refused(&identity, error)),
            }
            sleep(PAUSE).await;
        }
    }

    /// Waits for the scheduler.
    async fn reach(&self) {
        let (host, port) = (self.scheduler.0.as_str(), self.scheduler.1);
        let mut said = false;
        while TcpStream::connect((host, port)).await.is_err() {
            if !said {
                eprintln!("waiting for the scheduler at {host}:{port}");
                said = true;
            }
            sleep(PAUSE).await;
        }
    }
}

/// The scheduler's refusal with both identities; any other error as it is.
fn refused(identity: &Identity, error: BallistaError) -> Fault {
    let text = error.to_string();
    match text.find("refused: ") {
        Some(at) => Fault::Refused {
            here: identity.to_string(),
            there: first_line(&text[at..]),
        },
        None => error.into(),
    }
}

/// A folder of the executor's own, which ends with it.
struct Folder(PathBuf);

impl Folder {
    fn new(parent: Option<PathBuf>, name: &str) -> Result<Self, Fault> {
        let folder = parent
            .unwrap_or_else(std::env::temp_dir)
            .join(format!("kin-search-{name}"));
        fs::create_dir_all(&folder).map_err(|error| Fault::File(folder.clone(), error))?;
        Ok(Self(folder))
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // A folder that cannot be removed is no reason to fail.
        let _ = fs::remove_dir_all(&self.0);
    }
}
