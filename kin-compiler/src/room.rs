//! A large stack for passes that follow expressions by recursion.
//!
//! The depth of expressions is up to the user: abbreviations can be nested as deep as there are abbreviations, and a
//! sum is processed term by term. The compiler's stack is too small for this, so these passes run on a stack of their
//! own. Tokens and their positions belong to the compiler and cannot be moved to another thread; the types enforce
//! this.

use std::panic::resume_unwind;
use std::thread::{Builder, ScopedJoinHandle, scope};

use crate::work;

/// The size of the stack, in bytes. One eighth of it is enough for the longest allowed declarations, even without
/// optimisation. The size is address space only: memory is used as far as the stack grows.
const SIZE: usize = 256 << 20;

/// Runs `work` on a large stack, or on the current one if no thread can be started. WebAssembly has no threads;
/// declarations that are nested too deep for its stack are refused there.
pub(crate) fn with_room<Outcome: Send>(work: impl FnOnce() -> Outcome + Send) -> Outcome {
    let mut work = Some(work);
    let mut outcome = None;
    let budget = work::left();
    let ended = scope(|scope| {
        let thread = Builder::new().name("kin".to_owned()).stack_size(SIZE);
        let thread = thread.spawn_scoped(scope, || outcome = work.take().map(|work| work::within(budget, work)));
        thread.map_or(Ok(()), ScopedJoinHandle::join)
    });
    if let Err(panic) = ended {
        resume_unwind(panic);
    }
    match outcome {
        Some((outcome, done)) => {
            // work is counted by thread, as its budget is
            work::add(done);
            outcome
        }
        None => (work.take().expect("without a thread it has not been done"))(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn depth_of(levels: usize) -> usize {
        let frame = std::hint::black_box([levels; 64]);
        if levels == 0 {
            0
        } else {
            depth_of(levels - 1) + frame[0] / levels
        }
    }

    #[test]
    fn there_is_room_for_deep_recursion() {
        assert_eq!(with_room(|| depth_of(200_000)), 200_000);
    }

    #[test]
    #[should_panic(expected = "as it was")]
    fn a_panic_is_handed_on() {
        with_room(|| panic!("as it was"));
    }
}
