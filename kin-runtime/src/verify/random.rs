//! Random dimensions and motions, the same in every run.

use crate::number::scatter::{INCREMENT, fraction};

/// Pseudorandom numbers by `SplitMix64` (Steele, Lea and Flood, "Fast splittable pseudorandom number generators",
/// OOPSLA 2014).
///
/// ```
/// use kin_core::verify::Random;
///
/// let mut random = Random::new(1);
/// let drawn = random.between(-2.0, 3.0);
/// assert!((-2.0..3.0).contains(&drawn));
/// assert_eq!(Random::new(1).between(-2.0, 3.0), drawn);
/// ```
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The sequence that belongs to a seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next number in `low..high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(INCREMENT);
        low + (high - low) * fraction(self.0)
    }

    /// A random size, log-uniform over the decade around 1.
    pub(super) fn size(&mut self) -> f64 {
        10.0_f64.powf(self.between(-0.5, 0.5))
    }

    /// A random size with a random sign.
    pub(super) fn signed_size(&mut self) -> f64 {
        let size = self.size();
        if self.between(-1.0, 1.0) < 0.0 { -size } else { size }
    }
}
