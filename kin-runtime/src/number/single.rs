//! Rounding to single precision.

#[expect(
    clippy::cast_possible_truncation,
    reason = "rounding to the nearest single-precision number is the purpose"
)]
#[inline(always)]
pub(crate) fn single(value: f64) -> f32 {
    value as f32
}
