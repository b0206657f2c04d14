//! The work of a compilation, counted where it is done, so that it is the same in every run on every machine.
//!
//! A budget may bound it. Once it is spent, the loops that count end early, and what they leave is thrown away. Nothing
//! unwinds, because not every target can.

use std::cell::Cell;

/// The work done so far.
#[derive(Clone, Copy, Default, Debug)]
pub(crate) struct Work {
    /// Expressions looked up in a graph.
    pub(crate) look_ups: usize,
    /// Iterations of the other loops that might grow faster than a declaration.
    pub(crate) iterations: usize,
}

impl Work {
    pub(crate) const fn total(self) -> usize {
        self.look_ups.saturating_add(self.iterations)
    }
}

thread_local! {
    static DONE: Cell<Work> = const { Cell::new(Work { look_ups: 0, iterations: 0 }) };
    /// The total above which the budget is spent.
    static MOST: Cell<usize> = const { Cell::new(usize::MAX) };
}

/// The amount of work of one kind on one thread that counts as endless.
#[cfg(test)]
pub(crate) const ENDLESS: usize = 100_000_000;

/// Counts a look-up.
pub(crate) fn look_up() {
    let Work { look_ups, iterations } = DONE.get();
    #[cfg(test)]
    assert!(look_ups < ENDLESS, "the look-ups have no end");
    DONE.set(Work {
        look_ups: look_ups + 1,
        iterations,
    });
}

/// Counts an iteration of another loop.
pub(crate) fn iteration() {
    iterations(1);
}

/// Counts several iterations.
pub(crate) fn iterations(count: usize) {
    let Work { look_ups, iterations } = DONE.get();
    #[cfg(test)]
    assert!(iterations < ENDLESS, "the iterations have no end");
    DONE.set(Work {
        look_ups,
        iterations: iterations.saturating_add(count),
    });
}

/// Whether more work has been done than the budget allows.
pub(crate) fn is_spent() -> bool {
    DONE.get().total() > MOST.get()
}

/// What is left of the budget.
pub(crate) fn left() -> usize {
    MOST.get().saturating_sub(DONE.get().total())
}

/// The result of a function that has a budget, and the work that the function does on this thread.
pub(crate) fn within<T>(budget: usize, function: impl FnOnce() -> T) -> (T, Work) {
    let before = DONE.get();
    let others = MOST.replace(before.total().saturating_add(budget));
    let result = function();
    MOST.set(others);
    let after = DONE.get();
    let work = Work {
        look_ups: after.look_ups - before.look_ups,
        iterations: after.iterations - before.iterations,
    };
    (result, work)
}

/// The result of a function, and the work that the function does on this thread.
#[cfg(test)]
pub(crate) fn of<T>(function: impl FnOnce() -> T) -> (T, Work) {
    within(left(), function)
}

/// Adds the work of another thread.
pub(crate) fn add(work: Work) {
    let done = DONE.get();
    DONE.set(Work {
        look_ups: done.look_ups + work.look_ups,
        iterations: done.iterations.saturating_add(work.iterations),
    });
}
