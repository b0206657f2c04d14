//! Pseudorandom numbers, the same in every run.
//!
//! The generator is `SplitMix64` (G. Steele, D. Lea & C. Flood, "Fast splittable pseudorandom number generators",
//! OOPSLA 2014, figure 17): the state grows by a constant, and each number is a mixed state.

/// The increment of the state.
pub(crate) const INCREMENT: u64 = 0x9E37_79B9_7F4A_7C15;

/// The 64 random bits of a state.
#[inline]
pub(crate) fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// The random number in `0..1` of a state.
#[inline]
#[expect(
    clippy::cast_precision_loss,
    reason = "53 bits are kept, which is the precision of the type"
)]
pub(crate) fn fraction(state: u64) -> f64 {
    (mix(state) >> 11) as f64 / (1_u64 << 53) as f64
}
