//! Scattered numbers, the same in every run.

/// `SplitMix64` (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014).
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

    /// A motion through snap about a value, with rates of mixed size and sign.
    pub fn motion(&mut self, value: f64) -> [f64; 5] {
        [
            value,
            self.between(-10.0, 10.0),
            self.between(-20.0, 20.0),
            self.between(-50.0, 50.0),
            self.between(-100.0, 100.0),
        ]
    }
}
