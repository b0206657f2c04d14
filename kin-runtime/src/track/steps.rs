//! The number of steps of a track.

/// The largest number of steps of one [`track`](crate::track()), including rejected ones.
///
/// A revolution of a crank takes about 15 steps. A path through positions that rounding makes difficult takes a
/// thousand at most. A track that needs more steps than this limit makes thousands of revolutions, and can be divided,
/// or thousands of waves.
#[doc(hidden)]
pub const MOST_TRACK_STEPS: u32 = 100_000;

/// The number of steps taken.
pub(super) struct Steps(u32);

impl Steps {
    pub(super) const NONE: Self = Self(0);

    /// Counts another step; returns false if the limit is reached.
    pub(super) const fn take(&mut self) -> bool {
        let is_left = self.0 < MOST_TRACK_STEPS;
        if is_left {
            self.0 += 1;
        }
        is_left
    }

    pub(super) const fn taken(&self) -> u32 {
        self.0
    }
}
