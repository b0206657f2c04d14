//! Numbers in double precision by their bits.

/// The bit of the sign.
pub(super) const SIGN: u64 = 1 << 63;

/// The bits of 1.
pub(super) const ONE: u64 = 1.0_f64.to_bits();

/// A number, with its sign turned round if the highest of some bits is set.
#[inline(always)]
pub(crate) fn turned_round(number: f64, bits: u64) -> f64 {
    f64::from_bits(number.to_bits() ^ bits & SIGN)
}
