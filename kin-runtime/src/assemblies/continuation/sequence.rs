//! Pseudorandom numbers in general position.

use core::f64::consts::TAU;

use super::complex::Complex;
use crate::number::scatter::{INCREMENT, fraction, mix};

/// A fixed sequence of numbers that is unrelated to the mechanism.
#[derive(Clone, Debug)]
pub(super) struct FixedSequence {
    state: u64,
}

impl FixedSequence {
    /// The sequence with the given number.
    pub(super) const fn new(number: u64) -> Self {
        Self {
            state: number.wrapping_mul(0xD1B5_4A32_D192_ED03),
        }
    }

    /// The next 64 bits.
    pub(super) fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(INCREMENT);
        mix(self.state)
    }

    /// A number uniformly distributed between 0 and 1.
    pub(super) fn fraction(&mut self) -> f64 {
        self.state = self.state.wrapping_add(INCREMENT);
        fraction(self.state)
    }

    /// A complex number of modulus between 1/2 and 3/2.
    pub(super) fn complex(&mut self) -> Complex {
        self.unit().scale(0.5 + self.fraction())
    }

    /// A complex number of modulus one.
    pub(super) fn unit(&mut self) -> Complex {
        Complex::unit(TAU * self.fraction())
    }
}

/// A complex coefficient of one of several forms, with parts between -1 and 1.
#[inline]
pub(super) fn entry(number: u64, form: u8, index: usize) -> Complex {
    // A usize has at most 64 bits.
    let index = (index as u64).wrapping_mul(256).wrapping_add(u64::from(form));
    let at = number.wrapping_add(index.wrapping_mul(2).wrapping_mul(INCREMENT));
    Complex::new(
        2.0 * fraction(at) - 1.0,
        2.0 * fraction(at.wrapping_add(INCREMENT)) - 1.0,
    )
}

#[cfg(test)]
mod tests {
    use super::FixedSequence;

    #[test]
    fn evenly_distributed_and_always_the_same() {
        let mut sequence = FixedSequence::new(1);
        let values: [f64; 1000] = core::array::from_fn(|_| sequence.fraction());
        let mean = values.iter().sum::<f64>() / 1000.0;
        // The tolerance is five standard deviations of the mean of a thousand numbers.
        assert!((mean - 0.5).abs() < 5.0 * (1.0 / 12_000.0_f64).sqrt());
        assert_eq!(values[0], FixedSequence::new(1).fraction());
        assert_ne!(values[0], FixedSequence::new(2).fraction());
        assert!((sequence.unit().norm() - 1.0).abs() < 1e-15);
    }
}
