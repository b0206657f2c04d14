//! Numbers that are the same in every run.

/// A sequence of numbers between -4 and 4.
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn number(&mut self) -> f64 {
        // splitmix64
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        bits ^= bits >> 31;
        let [high, low] = [bits >> 32, bits & 0xFFFF_FFFF].map(|half| u32::try_from(half).expect("it has 32 bits"));
        (f64::from(high) + f64::from(low) * 2_f64.powi(-32)) * 2_f64.powi(-29) - 4.0
    }
}
