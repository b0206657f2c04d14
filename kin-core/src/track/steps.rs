//! How many steps a track may take.

/// The most steps that one [`track`](crate::track()) takes, those that are tried in vain included.
///
/// A turn of a crank takes about 15, a way through places that rounding makes difficult a thousand at most. With this
/// many steps it is either a way of thousands of turns, which can be tracked in parts, or one of thousands of waves.
pub const MOST_TRACK_STEPS: u32 = 100_000;

/// The steps that have been taken.
pub(super) struct Steps(u32);

impl Steps {
    pub(super) const NONE: Self = Self(0);

    /// Counts another step; false if there are no more.
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
