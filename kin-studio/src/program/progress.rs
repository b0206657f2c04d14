//! A progress bar for work that takes longer than a second, on a terminal only.

use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// The time after which a bar appears.
const PATIENCE: Duration = Duration::from_secs(1);

/// Does some work in a number of steps. The work calls what it is given after each step.
pub(crate) fn watched<R>(what: &str, steps: usize, work: impl FnOnce(&dyn Fn()) -> R) -> R {
    if !console::user_attended_stderr() {
        return work(&|| {});
    }
    let bar = ProgressBar::with_draw_target(Some(steps as u64), ProgressDrawTarget::hidden());
    let template = if steps > 1 {
        "{msg} {wide_bar} {pos}/{len} {elapsed}"
    } else {
        "{spinner} {msg} {elapsed}"
    };
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar.set_message(what.to_owned());
    let (done, wait) = mpsc::channel::<()>();
    thread::scope(|scope| {
        let shown = bar.clone();
        scope.spawn(move || {
            if wait.recv_timeout(PATIENCE) == Err(RecvTimeoutError::Timeout) {
                shown.set_draw_target(ProgressDrawTarget::stderr());
                shown.enable_steady_tick(Duration::from_millis(100));
                // until the work is done
                let _ = wait.recv();
            }
            shown.finish_and_clear();
        });
        let result = work(&|| bar.inc(1));
        drop(done);
        result
    })
}
