//! The process that distributes a search.

use std::sync::Arc;
use std::time::Duration;

use ballista_core::extension::SessionConfigExt;
use ballista_core::serde::protobuf::scheduler_grpc_server::SchedulerGrpc;
use ballista_core::serde::protobuf::{ExecutorStoppedParams, UpdateTaskStatusParams};
use ballista_scheduler::cluster::memory::InMemoryJobState;
use ballista_scheduler::cluster::{BallistaCluster, ClusterState};
use ballista_scheduler::config::SchedulerConfig;
use ballista_scheduler::scheduler_process::{create_scheduler, start_grpc_service_with_listener};
use ballista_scheduler::scheduler_server::SchedulerServer;
use datafusion::common::plan_err;
use datafusion::prelude::SessionConfig;
use datafusion_proto::protobuf::{LogicalPlanNode, PhysicalPlanNode};
use tokio::time::sleep;
use tonic::Request;

use crate::function::{Functions, Settings};
use crate::session::{self, Options, Signals};

use super::address::{Listen, announce};
use super::admission::Admission;
use super::codec::{Codec, PhysicalCodec};
use super::fault::Fault;
use super::identity::Identity;
use super::options::Caller;
use crate::say;

/// The settings of a scheduler.
#[derive(Clone, Debug)]
pub struct Scheduler {
    /// The address on which the scheduler listens.
    pub listen: Listen,
    /// The host name or address by which executors reach it, if it is not that on which it listens.
    pub host: Option<String>,
    /// The number of seconds without a sign of life after which an executor is given up, and others do its work.
    pub patience: u64,
}

impl Default for Scheduler {
    fn default() -> Self {
        Self {
            listen: Listen::default(),
            host: None,
            patience: 10,
        }
    }
}

impl Scheduler {
    /// Runs the scheduler until SIGINT or SIGTERM, and prints `listening on ADDRESS` when executors and clients can
    /// come.
    ///
    /// # Errors
    ///
    /// [`Fault`], if the address cannot be had, or if Ballista reports an error.
    pub async fn run(self, functions: &Functions) -> Result<(), Fault> {
        if let Some(warning) = self.listen.warning() {
            say(format_args!("{warning}"));
        }
        if self.host.is_none() && self.listen.ip().is_unspecified() {
            return Err(Fault::Nameless(self.listen));
        }
        let mut signals = Signals::listen().map_err(Fault::Signals)?;
        let identity = Identity::of(functions);
        let listener = self
            .listen
            .bind()
            .await
            .map_err(|error| Fault::Address(self.listen, error))?;
        let address = listener
            .local_addr()
            .map_err(|error| Fault::Address(self.listen, error))?;
        let config_producer: ballista_core::ConfigProducer = Arc::new(settings);
        let session_builder = sessions(identity.clone(), functions.clone());
        let config = SchedulerConfig {
            external_host: self.host.unwrap_or_else(|| address.ip().to_string()),
            bind_host: address.ip().to_string(),
            bind_port: address.port(),
            executor_timeout_seconds: self.patience,
            no_executors_grace_period_seconds: self.patience.max(60),
            expire_dead_executor_interval_seconds: 1,
            finished_job_data_clean_up_interval_seconds: 60,
            override_config_producer: Some(Arc::clone(&config_producer)),
            override_session_builder: Some(Arc::clone(&session_builder)),
            override_logical_codec: Some(Arc::new(Codec::default())),
            override_physical_codec: Some(Arc::new(PhysicalCodec::default())),
            ..SchedulerConfig::default()
        };
        config.validate()?;
        let jobs = InMemoryJobState::new(&config.scheduler_id, session_builder, config_producer);
        let admission = Arc::new(Admission::new(identity.clone()));
        let executors: Arc<dyn ClusterState> = Arc::clone(&admission) as _;
        let cluster = BallistaCluster::new(executors, Arc::new(jobs));
        let scheduler = create_scheduler::<LogicalPlanNode, PhysicalPlanNode>(cluster, Arc::new(config)).await?;
        admission.serve(scheduler.clone());
        say(format_args!("{identity}"));
        announce(address);
        tokio::select! {
            () = signals.come() => Ok(()),
            () = distribute(scheduler.clone(), &admission) => Ok(()),
            served = start_grpc_service_with_listener(listener, scheduler) => Ok(served?),
        }
    }
}

/// The pause between two distributions of tasks.
const PAUSE: Duration = Duration::from_secs(1);

/// Lets the scheduler distribute tasks from time to time, without an end.
///
/// Ballista 55 distributes tasks when a task ends. If the last task of an executor was taken back, because the rows
/// that the task reads were lost with another executor, no task ends. A report without tasks has the effect of an end.
///
/// If all executors are lost, Ballista fails the jobs of that time after a minute, unless an executor comes. Jobs that
/// come later would wait for ever. The loss of an executor that was never there begins another minute, in which
/// Ballista sees them.
async fn distribute(scheduler: SchedulerServer<LogicalPlanNode, PhysicalPlanNode>, admission: &Admission) {
    loop {
        sleep(PAUSE).await;
        if let Some(executor_id) = admission.an_executor() {
            let report = UpdateTaskStatusParams {
                executor_id,
                task_status: Vec::new(),
            };
            // The next one comes in a second.
            let _ = SchedulerGrpc::update_task_status(&scheduler, Request::new(report)).await;
        } else if admission.has_lost_all() && scheduler.running_job_number() > 0 {
            let loss = ExecutorStoppedParams {
                executor_id: "nobody".to_owned(),
                reason: "all executors are lost".to_owned(),
            };
            let _ = SchedulerGrpc::executor_stopped(&scheduler, Request::new(loss)).await;
        }
    }
}

/// The settings from which a session begins, on the scheduler and on executors.
pub(super) fn settings() -> SessionConfig {
    SessionConfig::new_with_ballista()
        .with_option_extension(Settings::default())
        .with_option_extension(Caller::default())
}

/// Sessions with the functions, for clients with the same identity.
fn sessions(identity: Identity, functions: Functions) -> ballista_scheduler::SessionBuilder {
    Arc::new(move |config| {
        let caller = config
            .options()
            .extensions
            .get::<Caller>()
            .map_or("", |caller| caller.identity.as_str());
        if caller != identity.tag() {
            return plan_err!(
                "refused: the client is {caller}, and the scheduler is {} = {identity}",
                identity.tag()
            );
        }
        session::state(&functions, config, &Options::default())
    })
}
