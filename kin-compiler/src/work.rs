//! The work of an expansion, counted where it is done. The numbers are the same in every run on every machine.

use std::cell::Cell;

/// The work done so far.
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

/// The amount of work of one kind on one thread that counts as endless.
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

/// The result of a function, and the work that the function does on this thread.
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

/// Adds the work of another thread.
pub(crate) fn add(work: Work) {
    let done = DONE.get();
    DONE.set(Work {
        look_ups: done.look_ups + work.look_ups,
        turns: done.turns + work.turns,
    });
}
