//! Scattered motions, the same in every run.

use kin_core::verify;

/// Random numbers and motions through snap.
pub struct Random(verify::Random);

impl Random {
    /// A sequence of its own for each seed.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self(verify::Random::new(seed))
    }

    /// A number in `low..high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0.between(low, high)
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
