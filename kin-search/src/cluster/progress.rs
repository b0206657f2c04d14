//! The progress of a search, on the standard error stream.

use crate::say;
use std::io::{IsTerminal, Write};
use std::sync::Mutex;
use std::sync::atomic::{AtomicI64, Ordering};
use std::time::Instant;

/// The progress of a search. On a terminal one line changes; elsewhere each message is a line.
#[derive(Debug)]
pub(super) struct Progress {
    since: Instant,
    /// Ids of ranges that this search has to do, and those that are done.
    all: i64,
    done: AtomicI64,
    terminal: bool,
    has_line: Mutex<bool>,
}

impl Progress {
    pub(super) fn new(all: i64) -> Self {
        Self {
            since: Instant::now(),
            all,
            done: AtomicI64::new(0),
            terminal: std::io::stderr().is_terminal(),
            has_line: Mutex::new(false),
        }
    }

    /// A stage of a job is finished.
    pub(super) fn stage(&self, job: &str, stages: usize, rows: u64) {
        self.say(&format!("{job}: {stages} stages finished, the last with {rows} rows"));
    }

    /// All ids of a job are searched.
    pub(super) fn finished(&self, job: &str, ids: i64) {
        let done = self.done.fetch_add(ids, Ordering::Relaxed) + ids;
        self.say(&format!(
            "{job}: finished; {done} of {} ids, {:.0} ids/s",
            self.all,
            rate(done, self.since.elapsed().as_secs_f64())
        ));
    }

    fn say(&self, text: &str) {
        let mut has_line = self.has_line.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        if self.terminal {
            // The rest of a longer line is cleared.
            let mut stream = std::io::stderr();
            let _ = write!(stream, "\r\x1b[K{text}").and_then(|()| stream.flush());
            *has_line = true;
        } else {
            say(format_args!("{text}"));
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if *self.has_line.lock().unwrap_or_else(std::sync::PoisonError::into_inner) {
            say(format_args!(""));
        }
    }
}

#[expect(clippy::cast_precision_loss, reason = "it is printed in whole numbers")]
fn rate(ids: i64, seconds: f64) -> f64 {
    if seconds > 0.0 { ids as f64 / seconds } else { 0.0 }
}
