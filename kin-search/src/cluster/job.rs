//! One query on the cluster, from its submission to its rows.

use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;

use ballista_core::execution_plans::DistributedQueryExec;
use ballista_core::serde::protobuf::scheduler_grpc_client::SchedulerGrpcClient;
use ballista_core::serde::protobuf::{
    CancelJobParams, CleanJobDataParams, GetJobMetricsParams, GetJobStatusParams, job_status, operator_metric,
};
use datafusion::arrow::array::RecordBatch;
use datafusion::error::DataFusionError;
use datafusion::execution::SessionState;
use datafusion::logical_expr::LogicalPlan;
use datafusion::physical_plan::{ExecutionPlan, collect};
use datafusion_proto::protobuf::LogicalPlanNode;
use tokio::time::{MissedTickBehavior, interval, sleep, timeout};
use tonic::Code;

use super::progress::Progress;
use super::stop::Stop;

/// The pause between two questions for the stages of a job.
const GLANCE: Duration = Duration::from_millis(500);

/// The time after which a scheduler that does not answer counts as lost.
const ANSWER: Duration = Duration::from_secs(10);

/// The error of a job that was called off.
const CALLED_OFF: &str = "Cancelled";

/// The reason why a query on the cluster ended without rows.
#[derive(Debug)]
pub(super) enum End {
    /// It was interrupted, and called off.
    Interrupted,
    /// The scheduler does not answer.
    Lost(String),
    /// The scheduler does not know the query: it was started again.
    Restarted,
    /// An executor was lost, and the scheduler called the query off.
    CalledOff,
    /// The query is finished, and its rows are not there: the executor that has them was lost.
    Gone(DataFusionError),
    /// The process that answers is no scheduler.
    Another,
    /// The query failed.
    Failed(DataFusionError),
}

/// Runs a query, and shows its stages.
pub(super) async fn run(
    state: &SessionState,
    query: &LogicalPlan,
    scheduler: &str,
    name: &str,
    progress: &Progress,
    mut stop: Stop,
) -> Result<Vec<RecordBatch>, End> {
    if stop.has_come() {
        return Err(End::Interrupted);
    }
    let plan = state.create_physical_plan(query).await.map_err(End::Failed)?;
    let mut rows = pin!(collect(Arc::clone(&plan), state.task_ctx()));
    let mut glances = interval(GLANCE);
    glances.set_missed_tick_behavior(MissedTickBehavior::Delay);
    let mut stages = 0;
    let collected = loop {
        tokio::select! {
            collected = &mut rows => break collected,
            () = stop.come() => {
                // The job may not have its number yet.
                for _ in 0..100 {
                    if number(&plan).is_some() {
                        break;
                    }
                    tokio::select! {
                        _ = &mut rows => break,
                        () = sleep(Duration::from_millis(50)) => {}
                    }
                }
                if let Some(job) = number(&plan) {
                    cancel(scheduler, job).await;
                }
                return Err(End::Interrupted);
            }
            _ = glances.tick() => {
                if let Some(job) = number(&plan)
                    && let Some((finished, last)) = finished_stages(scheduler, job).await
                    && finished > stages
                {
                    stages = finished;
                    progress.stage(name, finished, last);
                }
            }
        }
    };
    let job = number(&plan);
    match collected {
        Ok(rows) => {
            if let Some(job) = job {
                clean(scheduler, job).await;
            }
            Ok(rows)
        }
        Err(error) => Err(reason(scheduler, job, error).await),
    }
}

/// The number of the job of a query, once the scheduler has given it one.
fn number(plan: &Arc<dyn ExecutionPlan>) -> Option<String> {
    plan.downcast_ref::<DistributedQueryExec<LogicalPlanNode>>()?
        .job_id()
        .map(|job| job.to_string())
}

/// The meaning of an error of a query.
async fn reason(scheduler: &str, job: Option<String>, error: DataFusionError) -> End {
    let asked = timeout(ANSWER, async {
        let mut client = SchedulerGrpcClient::connect(scheduler.to_owned()).await.ok()?;
        let Some(job_id) = job else {
            // It was refused before it was given a number, unless the scheduler ended while it was asked.
            let asked = client.get_job_status(GetJobStatusParams::default()).await;
            return match asked.map_or_else(|status| status.code(), |_| Code::Ok) {
                Code::Unknown | Code::Unavailable => None,
                Code::Unimplemented => Some(Err(End::Another)),
                _ => Some(Ok(None)),
            };
        };
        let status = client.get_job_status(GetJobStatusParams { job_id }).await.ok()?;
        Some(Ok(Some(status.into_inner().status.and_then(|status| status.status))))
    })
    .await;
    match asked {
        Err(_) | Ok(None) => End::Lost(brief(&error)),
        Ok(Some(Err(end))) => end,
        Ok(Some(Ok(None))) => End::Failed(error),
        Ok(Some(Ok(Some(None)))) => End::Restarted,
        Ok(Some(Ok(Some(Some(job_status::Status::Successful(_)))))) => End::Gone(error),
        Ok(Some(Ok(Some(Some(job_status::Status::Failed(failed)))))) if failed.error == CALLED_OFF => End::CalledOff,
        Ok(Some(Ok(Some(Some(_))))) => End::Failed(error),
    }
}

/// The first line of an error, which can be a page.
fn brief(error: &DataFusionError) -> String {
    error
        .to_string()
        .lines()
        .next()
        .unwrap_or_default()
        .chars()
        .take(200)
        .collect()
}

/// Calls a job off. A scheduler that does not answer has no job.
async fn cancel(scheduler: &str, job_id: String) {
    let _ = timeout(ANSWER, async {
        let mut client = SchedulerGrpcClient::connect(scheduler.to_owned()).await.ok()?;
        client.cancel_job(CancelJobParams { job_id }).await.ok()
    })
    .await;
}

/// Lets executors remove the files of a job whose rows have arrived. They remove them later if this fails.
async fn clean(scheduler: &str, job_id: String) {
    let _ = timeout(ANSWER, async {
        let mut client = SchedulerGrpcClient::connect(scheduler.to_owned()).await.ok()?;
        let params = CleanJobDataParams {
            job_id,
            ..CleanJobDataParams::default()
        };
        client.clean_job_data(params).await.ok()
    })
    .await;
}

/// The number of finished stages of a job, and the number of rows that the last finished stage has written.
async fn finished_stages(scheduler: &str, job_id: String) -> Option<(usize, u64)> {
    timeout(GLANCE, async {
        let mut client = SchedulerGrpcClient::connect(scheduler.to_owned()).await.ok()?;
        let metrics = client.get_job_metrics(GetJobMetricsParams { job_id }).await.ok()?;
        let stages = metrics.into_inner().stages;
        let rows = stages
            .iter()
            .max_by_key(|stage| stage.stage_id)?
            .operators
            .first()?
            .metrics
            .iter()
            .filter_map(|metric| match metric.metric {
                Some(operator_metric::Metric::OutputRows(rows)) => Some(rows),
                _ => None,
            })
            .sum();
        Some((stages.len(), rows))
    })
    .await
    .ok()?
}
