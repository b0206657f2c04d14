//! The process that runs tasks.

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
use tokio::time::{sleep, timeout};

use crate::function::Functions;
use crate::session::Signals;

use super::address::{Endpoint, Listen, PAUSE, announce};
use super::codec::PhysicalCodec;
use super::fault::Fault;
use super::identity::{Identity, executor_name};
use super::scheduler::settings;
use crate::say;

/// The longest time that an executor may work on after a signal to end.
const GRACE: Duration = Duration::from_secs(5);

/// The settings of an executor.
#[derive(Clone, Debug)]
pub struct Executor {
    /// The address of the scheduler.
    pub scheduler: Endpoint,
    /// The address on which the executor listens. The port is that of the results; orders come to another free port.
    pub listen: Listen,
    /// The number of tasks that the executor works on at a time.
    pub cores: usize,
    /// The memory that all tasks may take together, in bytes. By default it is [`SHARE`](Self::SHARE) of the machine's
    /// memory, reduced in proportion if the executor works on fewer tasks than the machine has cores.
    pub memory: Option<u64>,
    /// The folder for results of stages until they are fetched; by default a new folder among the temporary files.
    pub folder: Option<PathBuf>,
}

impl Executor {
    /// The share of the machine's memory for executors that use all its cores.
    pub const SHARE: f64 = 0.7;

    /// The share of the machine's memory for this executor. Executors that share the cores of a machine share its
    /// memory as well.
    fn share(&self) -> f64 {
        let all = std::thread::available_parallelism().map_or(1, usize::from);
        let count = |cores: usize| f64::from(u32::try_from(cores).unwrap_or(u32::MAX));
        Self::SHARE * (count(self.cores) / count(all)).clamp(f64::MIN_POSITIVE, 1.0)
    }

    /// Runs the executor until SIGINT or SIGTERM.
    ///
    /// It waits for the scheduler, prints `listening on ADDRESS`, and waits again if the scheduler is lost.
    ///
    /// # Errors
    ///
    /// [`Fault`], if the address cannot be listened on, the scheduler refuses the executor, or Ballista reports an
    /// error.
    pub async fn run(self, functions: &Functions) -> Result<(), Fault> {
        if let Some(warning) = self.listen.warning() {
            say(format_args!("{warning}"));
        }
        let identity = Identity::of(functions);
        say(format_args!("{identity}"));
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
                () = self.scheduler.reach() => {}
            }
            let name = executor_name(&identity);
            let folder = Folder::new(self.folder.clone(), &name)?;
            let taken = |error| Fault::Address(self.listen, error);
            let port = self.listen.port().map_err(taken)?;
            let orders = self.listen.beside().port().map_err(taken)?;
            let config = ExecutorProcessConfig {
                executor_id: name,
                bind_host: self.listen.ip().to_string(),
                port,
                grpc_port: orders,
                scheduler_host: self.scheduler.host.clone(),
                scheduler_port: self.scheduler.port,
                vcores: self.cores,
                memory_pool_size: self.memory,
                memory_pool_fraction: self.share(),
                work_dir: Some(folder.0.display().to_string()),
                executor_heartbeat_interval_seconds: 1,
                override_function_registry: Some(Arc::clone(&registry)),
                override_config_producer: Some(Arc::new(settings)),
                override_physical_codec: Some(Arc::new(PhysicalCodec::default())),
                ..ExecutorProcessConfig::default()
            };
            announce((self.listen.ip(), port).into());
            TERMINATING.store(false, Ordering::Release);
            let mut work = pin!(start_executor_process(Arc::new(config)));
            let worked = tokio::select! {
                worked = &mut work => worked,
                () = signals.come() => {
                    // The executor has heard the same signal: it reports to the scheduler, and finishes its tasks.
                    let _ = timeout(GRACE, work).await;
                    return Ok(());
                }
            };
            match worked {
                // The scheduler was lost.
                Ok(()) | Err(BallistaError::GrpcConnectionError(_) | BallistaError::TonicError(_)) => {
                    say(format_args!(
                        "the scheduler at {} is lost; waiting for it",
                        self.scheduler
                    ));
                }
                // Another process took one of the ports.
                Err(BallistaError::IoError(error)) if error.kind() == io::ErrorKind::AddrInUse => {}
                Err(error) => return Err(Fault::refusal(&identity, &error.to_string()).unwrap_or_else(|| error.into())),
            }
            sleep(PAUSE).await;
        }
    }
}

/// A folder of one executor, which ends with it.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn executors_that_share_cores_share_memory() {
        let all = std::thread::available_parallelism().map_or(1, usize::from);
        let share = |cores| {
            let executor = Executor {
                scheduler: Endpoint {
                    host: "localhost".to_owned(),
                    port: 1,
                },
                listen: Listen::default(),
                cores,
                memory: None,
                folder: None,
            };
            executor.share()
        };
        let together: f64 = (0..all).map(|_| share(1)).sum();
        assert!((together - Executor::SHARE).abs() < 1e-12, "{together}");
        assert_eq!(share(all), Executor::SHARE);
        assert_eq!(share(2 * all), Executor::SHARE);
    }
}
