//! The solutions that several questions about the same places need.

use alloc::collections::BTreeMap;
use alloc::vec::Vec;
use core::cell::RefCell;

use super::equations::Solution;
use super::{REACH, ReactionError};

/// So many solutions are remembered, more than a search for the extremes of all forces asks for.
const REMEMBERED: usize = 1 << 14;

/// The solutions at the last places, by all that they depend on.
#[derive(Clone, Default)]
pub(super) struct Remembered(RefCell<BTreeMap<Vec<u64>, Solution<REACH>>>);

impl Remembered {
    /// Reads the solution at a place, which is found if it is not remembered.
    pub(super) fn read<R>(
        &self,
        place: Vec<u64>,
        find: impl FnOnce() -> Result<Solution<REACH>, ReactionError>,
        read: impl FnOnce(&Solution<REACH>) -> R,
    ) -> Result<R, ReactionError> {
        if let Some(known) = self.0.borrow().get(&place) {
            return Ok(read(known));
        }
        let found = find()?;
        let mut all = self.0.borrow_mut();
        if all.len() == REMEMBERED {
            all.clear();
        }
        Ok(read(all.entry(place).or_insert(found)))
    }

    /// Forgets all solutions, because others belong to the same places now.
    pub(super) fn forget(&mut self) {
        self.0.take();
    }
}
