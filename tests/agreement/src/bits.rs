//! The number types in which methods are compared, bit by bit.

use kin_core::Scalar;
use kin_core::series::Series;

use crate::random::Random;

/// A number that can be drawn, and whose bits can be seen.
pub(crate) trait Bits: Scalar {
    fn drawn(random: &mut Random) -> Self;

    /// The bits of each part. All that are no numbers are alike, because processors do not agree on their bits.
    fn bits(self) -> Vec<u64>;
}

fn bits_of(value: f64) -> u64 {
    if value.is_nan() {
        f64::NAN.to_bits()
    } else {
        value.to_bits()
    }
}

impl Bits for f64 {
    fn drawn(random: &mut Random) -> Self {
        random.number()
    }

    fn bits(self) -> Vec<u64> {
        vec![bits_of(self)]
    }
}

impl Bits for f32 {
    #[expect(clippy::cast_possible_truncation, reason = "any number will do")]
    fn drawn(random: &mut Random) -> Self {
        random.number() as f32
    }

    fn bits(self) -> Vec<u64> {
        vec![bits_of(f64::from(self))]
    }
}

impl<const N: usize> Bits for Series<N> {
    fn drawn(random: &mut Random) -> Self {
        Self::from_coefficients(std::array::from_fn(|_| random.number()))
    }

    fn bits(self) -> Vec<u64> {
        self.coefficients().map(bits_of).to_vec()
    }
}
