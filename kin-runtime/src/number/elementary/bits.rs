//! The bits of plain numbers.

use num_traits::{Float, PrimInt, WrappingAdd, WrappingNeg};

/// A plain number with its bits: `f64` or `f32`.
pub trait Binary: Float + 'static {
    /// The bits as an integer.
    type Bits: PrimInt + WrappingAdd + WrappingNeg;

    /// The sign bit.
    const SIGN: Self::Bits;

    /// The bits of 1.
    const ONE: Self::Bits;

    /// The distance from the second lowest bit to the sign bit.
    const FROM_SECOND_TO_SIGN: usize;

    /// The number that is known in single precision.
    fn from_single(number: f32) -> Self;

    /// The bits of the number.
    fn bits(self) -> Self::Bits;

    /// The number with these bits.
    fn of_bits(bits: Self::Bits) -> Self;

    /// The number without its sign. In contrast to `Float::abs`, it is never a call.
    fn size(self) -> Self;

    /// The number with the sign of another one.
    fn signed_as(self, other: Self) -> Self;
}

macro_rules! binary {
    ($float:ty, $bits:ty) => {
        impl Binary for $float {
            type Bits = $bits;
            const SIGN: $bits = 1 << (<$bits>::BITS - 1);
            const ONE: $bits = <$float>::to_bits(1.0);
            const FROM_SECOND_TO_SIGN: usize = <$bits>::BITS as usize - 2;

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn from_single(number: f32) -> Self {
                Self::from(number)
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn bits(self) -> $bits {
                self.to_bits()
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn of_bits(bits: $bits) -> Self {
                Self::from_bits(bits)
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn size(self) -> Self {
                <$float>::abs(self)
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn signed_as(self, other: Self) -> Self {
                <$float>::copysign(self, other)
            }
        }
    };
}

binary!(f64, u64);
binary!(f32, u32);

/// The number, with its sign flipped if the highest bit of `bits` is set.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn sign_flipped<E: Binary>(number: E, bits: E::Bits) -> E {
    E::of_bits(number.bits() ^ (bits & E::SIGN))
}
