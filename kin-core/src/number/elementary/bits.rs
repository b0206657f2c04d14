//! The bits of double-precision numbers.

/// The sign bit.
pub(super) const SIGN: u64 = 1 << 63;

/// The bits of 1.
pub(super) const ONE: u64 = 1.0_f64.to_bits();

/// The number, with its sign flipped if the highest bit of `bits` is set.
#[inline(always)]
pub(crate) fn turned_round(number: f64, bits: u64) -> f64 {
    f64::from_bits(number.to_bits() ^ bits & SIGN)
}
