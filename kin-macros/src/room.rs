//! Room on the stack for what follows expressions by recursion.
//!
//! The depth of expressions is the user's: abbreviations of abbreviations lie within each other as deep as there are any, and a sum is
//! worked off term by term. The stack of the compiler is not made for that, so these passes run on one of their own. What belongs to
//! the compiler, tokens and their places, cannot go there; the types see to it.

use std::panic::resume_unwind;
use std::thread::{Builder, ScopedJoinHandle, scope};

use crate::work;

/// The size of the stack, in bytes. An eighth is enough for the longest declarations that are allowed, and without optimisation. It is address
/// space only: memory is taken as far down as the stack is used.
const SIZE: usize = 256 << 20;

/// Does some work where the stack is large; right here if there is no such place to be had.
pub(crate) fn with_room<Outcome: Send>(work: impl FnOnce() -> Outcome + Send) -> Outcome {
    let mut work = Some(work);
    let mut outcome = None;
    let ended = scope(|scope| {
        let thread = Builder::new().name("kin".to_owned()).stack_size(SIZE);
        let thread = thread.spawn_scoped(scope, || outcome = work.take().map(work::of));
        thread.map_or(Ok(()), ScopedJoinHandle::join)
    });
    if let Err(panic) = ended {
        resume_unwind(panic);
    }
    match outcome {
        Some((outcome, done)) => {
            // work is counted thread by thread
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
