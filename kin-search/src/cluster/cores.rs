//! The cores of executors that are free, counted anew for each distribution of tasks.
//!
//! Ballista 55 frees the cores of a task when the task reports its end, and looks the task up to see how many cores it
//! had. Ballista does not find tasks that it has taken back: those of a stage that reads rows of a lost executor, and
//! those of a job that has ended. Their cores would stay taken for ever, and an executor of one core would never work
//! again.

use std::collections::HashMap;

use ballista_core::JobId;
use ballista_scheduler::cluster::{BoundTask, ExecutorSlot};
use ballista_scheduler::state::task_manager::JobInfoCache;

/// The cores of an executor.
#[derive(Clone, Copy, Debug)]
struct Cores {
    all: u32,
    free: u32,
}

/// The cores of all executors.
#[derive(Debug, Default)]
pub(super) struct FreeCores {
    /// By their names.
    executors: HashMap<String, Cores>,
    /// Whether an executor has ever joined.
    joined: bool,
}

impl FreeCores {
    pub(super) fn join(&mut self, executor: &str, all: u32, free: u32) {
        self.joined = true;
        self.executors.insert(executor.to_owned(), Cores { all, free });
    }

    /// Returns whether the executor was there.
    pub(super) fn leave(&mut self, executor: &str) -> bool {
        self.executors.remove(executor).is_some()
    }

    /// Whether all executors have left.
    pub(super) fn are_lost(&self) -> bool {
        self.joined && self.executors.is_empty()
    }

    pub(super) fn an_executor(&self) -> Option<String> {
        self.executors.keys().next().cloned()
    }

    pub(super) fn give_back(&mut self, slots: &[ExecutorSlot]) {
        for (executor, count) in slots {
            if let Some(cores) = self.executors.get_mut(executor) {
                cores.free += count;
            }
        }
    }

    pub(super) fn take(&mut self, tasks: &[BoundTask]) {
        for (executor, task) in tasks {
            if let Some(cores) = self.executors.get_mut(executor) {
                cores.free = cores.free.saturating_sub(task.vcores_consumed);
            }
        }
    }

    /// The cores that are neither free nor busy. They are free from now on.
    pub(super) fn forgotten(&mut self, busy: &HashMap<String, u32>) -> Vec<ExecutorSlot> {
        let mut forgotten = Vec::new();
        for (executor, cores) in &mut self.executors {
            let busy = busy.get(executor).copied().unwrap_or(0);
            let lost = cores.all.saturating_sub(cores.free.saturating_add(busy));
            if lost > 0 {
                cores.free += lost;
                forgotten.push((executor.clone(), lost));
            }
        }
        forgotten
    }
}

/// The cores that the tasks of all jobs take, for each executor.
pub(super) async fn busy(jobs: &HashMap<JobId, JobInfoCache>) -> HashMap<String, u32> {
    let mut busy = HashMap::new();
    for job in jobs.values() {
        let graph = job.execution_graph.read().await;
        for task in graph.running_tasks() {
            *busy.entry(task.executor_id).or_insert(0) += graph.task_vcores(task.stage_id, task.task_id).unwrap_or(1);
        }
    }
    busy
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cores_of_tasks_that_were_taken_back_are_free_again() {
        let mut cores = FreeCores::default();
        assert!(!cores.are_lost());
        cores.join("one", 4, 4);
        cores.join("two", 1, 0);
        // `two` has a task, which is taken back
        let busy = HashMap::from([("two".to_owned(), 1)]);
        assert_eq!(cores.forgotten(&busy), []);
        assert_eq!(cores.forgotten(&HashMap::new()), [("two".to_owned(), 1)]);
        // what is free stays free
        assert_eq!(cores.forgotten(&HashMap::new()), []);
        assert!(cores.leave("two") && !cores.leave("two") && !cores.are_lost());
        cores.give_back(&[("two".to_owned(), 1)]);
        assert_eq!(cores.forgotten(&HashMap::new()), []);
        assert!(cores.leave("one") && cores.are_lost());
    }
}
