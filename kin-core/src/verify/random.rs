//! Scattered numbers, the same in every run.

/// `SplitMix64` (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014).
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
    /// A sequence of its own for each seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// A number in `low..high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        #[expect(clippy::cast_precision_loss, reason = "53 bits fit")]
        let fraction = ((z ^ (z >> 31)) >> 11) as f64 / 9_007_199_254_740_992.0;
        low + (high - low) * fraction
    }

    /// A size, its logarithm uniform over the decade about 1.
    pub(super) fn size(&mut self) -> f64 {
        10.0_f64.powf(self.between(-0.5, 0.5))
    }

    /// A size of either sign.
    pub(super) fn signed_size(&mut self) -> f64 {
        let size = self.size();
        if self.between(-1.0, 1.0) < 0.0 { -size } else { size }
    }
}
