//! The jobs that executors work for, so that these are called off when an executor is lost.
//!
//! Ballista 55 gives the tasks of a lost executor to other executors, and makes the rows that it held again. Once in
//! about a hundred times a query then ended without its rows, and without an error. A job that is called off and begins
//! anew has no lost parts.

use std::collections::{HashMap, HashSet};

use ballista_core::JobId;
use ballista_scheduler::cluster::BoundTask;

/// The jobs of which an executor has had a task, by the names of the executors.
#[derive(Debug, Default)]
pub(super) struct Assigned(HashMap<String, HashSet<JobId>>);

impl Assigned {
    /// Forgets jobs that have ended.
    pub(super) fn keep(&mut self, is_active: impl Fn(&JobId) -> bool) {
        for jobs in self.0.values_mut() {
            jobs.retain(|job| is_active(job));
        }
    }

    pub(super) fn assign(&mut self, tasks: &[BoundTask]) {
        for (executor, task) in tasks {
            self.insert(executor, &task.key.job_id);
        }
    }

    fn insert(&mut self, executor: &str, job: &JobId) {
        self.0.entry(executor.to_owned()).or_default().insert(job.clone());
    }

    /// The jobs that lose tasks or rows with an executor.
    pub(super) fn leave(&mut self, executor: &str) -> HashSet<JobId> {
        self.0.remove(executor).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_executor_takes_the_jobs_with_it_that_have_not_ended() {
        let [ended, active, other] = ["ended", "active", "other"].map(JobId::from);
        let mut assigned = Assigned::default();
        for job in [&ended, &active] {
            assigned.insert("one", job);
        }
        assigned.insert("two", &other);
        assigned.keep(|job| *job != ended);
        assert_eq!(assigned.leave("one"), HashSet::from([active]));
        assert_eq!(assigned.leave("one"), HashSet::new());
        assert_eq!(assigned.leave("two"), HashSet::from([other]));
    }
}
