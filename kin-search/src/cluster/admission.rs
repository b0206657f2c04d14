//! Executors are admitted only with the identity of their scheduler.

use std::collections::{HashMap, HashSet};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use ballista_core::JobId;
use ballista_core::error::{BallistaError, Result};
use ballista_core::serde::protobuf::ExecutorHeartbeat;
use ballista_core::serde::scheduler::{ExecutorData, ExecutorMetadata};
use ballista_scheduler::cluster::memory::InMemoryClusterState;
use ballista_scheduler::cluster::{BoundTask, ClusterState, ClusterStateEventStream, ExecutorSlot};
use ballista_scheduler::config::TaskDistributionPolicy;
use ballista_scheduler::scheduler_server::SchedulerServer;
use ballista_scheduler::state::task_manager::JobInfoCache;
use datafusion_proto::protobuf::{LogicalPlanNode, PhysicalPlanNode};

use super::assigned::Assigned;
use super::cores::{FreeCores, busy};
use super::identity::{Identity, tag_of};
use crate::say;

/// The state of the cluster in memory, behind a door.
///
/// The test is made where executors enter the state, so no way leads around it: neither the first registration nor a
/// heartbeat that registers again with a scheduler that was restarted.
pub(super) struct Admission {
    state: InMemoryClusterState,
    identity: Identity,
    cores: Mutex<FreeCores>,
    assigned: Mutex<Assigned>,
    /// The scheduler that this state serves.
    scheduler: OnceLock<SchedulerServer<LogicalPlanNode, PhysicalPlanNode>>,
}

impl Admission {
    pub(super) fn new(identity: Identity) -> Self {
        Self {
            state: InMemoryClusterState::default(),
            identity,
            cores: Mutex::default(),
            assigned: Mutex::default(),
            scheduler: OnceLock::new(),
        }
    }

    /// Sets the scheduler whose jobs are called off when an executor is lost.
    pub(super) fn serve(&self, scheduler: SchedulerServer<LogicalPlanNode, PhysicalPlanNode>) {
        let _ = self.scheduler.set(scheduler);
    }

    /// The name of an executor, if there is one.
    pub(super) fn an_executor(&self) -> Option<String> {
        self.cores().an_executor()
    }

    /// Whether all executors have left.
    pub(super) fn has_lost_all(&self) -> bool {
        self.cores().are_lost()
    }

    fn cores(&self) -> MutexGuard<'_, FreeCores> {
        self.cores.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn assigned(&self) -> MutexGuard<'_, Assigned> {
        self.assigned.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn admit(&self, executor: &str) -> Result<()> {
        if tag_of(executor) == self.identity.tag() {
            return Ok(());
        }
        let refusal = format!(
            "refused: the executor is {}, and the scheduler is {} = {}",
            tag_of(executor),
            self.identity.tag(),
            self.identity
        );
        say(format_args!("executor {executor} {refusal}"));
        Err(BallistaError::Configuration(refusal))
    }
}

#[async_trait::async_trait]
impl ClusterState for Admission {
    async fn init(&self) -> Result<()> {
        self.state.init().await
    }

    async fn bind_schedulable_tasks(
        &self,
        distribution: TaskDistributionPolicy,
        active_jobs: Arc<HashMap<JobId, JobInfoCache>>,
        executors: Option<HashSet<String>>,
    ) -> Result<Vec<BoundTask>> {
        self.assigned().keep(|job| active_jobs.contains_key(job));
        let busy = busy(&active_jobs).await;
        let forgotten = self.cores().forgotten(&busy);
        self.state.unbind_tasks(forgotten).await?;
        let tasks = self
            .state
            .bind_schedulable_tasks(distribution, active_jobs, executors)
            .await?;
        self.cores().take(&tasks);
        self.assigned().assign(&tasks);
        Ok(tasks)
    }

    async fn unbind_tasks(&self, slots: Vec<ExecutorSlot>) -> Result<()> {
        self.cores().give_back(&slots);
        self.state.unbind_tasks(slots).await
    }

    async fn register_executor(&self, metadata: ExecutorMetadata, data: ExecutorData) -> Result<()> {
        self.admit(&metadata.id)?;
        let (name, all, free) = (metadata.id.clone(), data.total_vcores, data.available_vcores);
        self.state.register_executor(metadata, data).await?;
        self.cores().join(&name, all, free);
        say(format_args!("executor {name} joined with {all} cores"));
        Ok(())
    }

    async fn save_executor_metadata(&self, metadata: ExecutorMetadata) -> Result<()> {
        self.admit(&metadata.id)?;
        self.state.save_executor_metadata(metadata).await
    }

    async fn get_executor_metadata(&self, executor: &str) -> Result<ExecutorMetadata> {
        self.state.get_executor_metadata(executor).await
    }

    async fn registered_executor_metadata(&self) -> Vec<ExecutorMetadata> {
        self.state.registered_executor_metadata().await
    }

    async fn save_executor_heartbeat(&self, heartbeat: ExecutorHeartbeat) -> Result<()> {
        self.state.save_executor_heartbeat(heartbeat).await
    }

    /// Ballista begins to repair the jobs of the executor after this. Those that are called off here are not repaired.
    async fn remove_executor(&self, executor: &str) -> Result<()> {
        let jobs = self.assigned().leave(executor);
        if let Some(scheduler) = self.scheduler.get() {
            for job in jobs {
                scheduler.cancel_job(job).await?;
            }
        }
        self.state.remove_executor(executor).await?;
        if self.cores().leave(executor) {
            say(format_args!("executor {executor} left"));
        }
        Ok(())
    }

    fn executor_heartbeats(&self) -> HashMap<String, ExecutorHeartbeat> {
        self.state.executor_heartbeats()
    }

    fn get_executor_heartbeat(&self, executor: &str) -> Option<ExecutorHeartbeat> {
        self.state.get_executor_heartbeat(executor)
    }

    async fn cluster_state_events(&self) -> Result<ClusterStateEventStream> {
        self.state.cluster_state_events().await
    }
}
