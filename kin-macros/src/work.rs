//! The work of an expansion, counted where it is done: the same numbers in every run, whatever the machine.

use std::cell::Cell;

/// What has been done.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Work {
    /// Expressions looked up in a graph.
    pub(crate) look_ups: usize,
    /// Turns of the other loops that might grow faster than a declaration.
    pub(crate) turns: usize,
}

thread_local! {
    static DONE: Cell<Work> = const { Cell::new(Work { look_ups: 0, turns: 0 }) };
}

/// So much work of one kind on one thread is taken to have no end.
#[cfg(test)]
pub(crate) const MOST: usize = 100_000_000;

/// Counts a look-up.
pub(crate) fn look_up() {
    let Work { look_ups, turns } = DONE.get();
    #[cfg(test)]
    assert!(look_ups < MOST, "the look-ups have no end");
    DONE.set(Work {
        look_ups: look_ups + 1,
        turns,
    });
}

/// Counts a turn of another loop.
pub(crate) fn turn() {
    let Work { look_ups, turns } = DONE.get();
    #[cfg(test)]
    assert!(turns < MOST, "the turns have no end");
    DONE.set(Work {
        look_ups,
        turns: turns + 1,
    });
}

/// The work of this thread that a function does.
pub(crate) fn of<T>(function: impl FnOnce() -> T) -> (T, Work) {
    let before = DONE.get();
    let result = function();
    let after = DONE.get();
    let work = Work {
        look_ups: after.look_ups - before.look_ups,
        turns: after.turns - before.turns,
    };
    (result, work)
}

/// Counts the work of another thread.
pub(crate) fn add(work: Work) {
    let done = DONE.get();
    DONE.set(Work {
        look_ups: done.look_ups + work.look_ups,
        turns: done.turns + work.turns,
    });
}
