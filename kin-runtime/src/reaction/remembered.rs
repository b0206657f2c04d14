//! The solutions that several questions about the same places need.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;
#[cfg(not(feature = "std"))]
use core::cell::RefCell;
#[cfg(feature = "std")]
use std::sync::{Mutex, PoisonError};

use super::equations::Solution;
use super::{REACH, ReactionError};

/// So many solutions are remembered, more than a search for the extremes of all forces asks for.
const REMEMBERED: usize = 1 << 14;

type Solutions = BTreeMap<Vec<u64>, Solution<REACH>>;

/// The solutions at the last places, by all that they depend on. Threads share them.
#[derive(Default)]
pub(super) struct Remembered {
    #[cfg(feature = "std")]
    solutions: Mutex<Solutions>,
    // without threads
    #[cfg(not(feature = "std"))]
    solutions: RefCell<Solutions>,
}

impl Clone for Remembered {
    fn clone(&self) -> Self {
        let solutions = self.with(|solutions| solutions.clone());
        Self {
            solutions: solutions.into(),
        }
    }
}

impl Remembered {
    /// Reads the solution at a place, which is found if it is not remembered.
    pub(super) fn read<R>(
        &self,
        place: Vec<u64>,
        find: impl FnOnce() -> Result<Solution<REACH>, ReactionError>,
        read: impl Fn(&Solution<REACH>) -> R,
    ) -> Result<R, ReactionError> {
        if let Some(known) = self.with(|all| all.get(&place).map(&read)) {
            return Ok(known);
        }
        let found = find()?;
        let answer = read(&found);
        self.with(|all| {
            if all.len() == REMEMBERED {
                all.clear();
            }
            all.insert(place, found);
        });
        Ok(answer)
    }

    /// Forgets all solutions, because others belong to the same places now.
    pub(super) fn forget(&mut self) {
        self.with(BTreeMap::clear);
    }

    #[cfg(feature = "std")]
    fn with<R>(&self, act: impl FnOnce(&mut Solutions) -> R) -> R {
        // each solution is whole, whatever a thread did that has panicked
        act(&mut self.solutions.lock().unwrap_or_else(PoisonError::into_inner))
    }

    #[cfg(not(feature = "std"))]
    fn with<R>(&self, act: impl FnOnce(&mut Solutions) -> R) -> R {
        act(&mut self.solutions.borrow_mut())
    }
}
