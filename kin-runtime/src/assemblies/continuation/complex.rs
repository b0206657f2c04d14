//! Complex numbers, as far as path tracking needs them.

use core::ops::{Add, AddAssign, Mul, Neg, Sub};

use num_traits::Float;

/// A complex number in double precision.
///
/// All tracked numbers are of moderate size, so nothing needs a guard against overflow. Real results stay exactly real:
/// sums, products and inverses of real numbers have the imaginary part zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Complex {
    pub(super) re: f64,
    pub(super) im: f64,
}

impl Complex {
    pub(super) const ZERO: Self = Self::real(0.0);
    pub(super) const ONE: Self = Self::real(1.0);

    #[inline]
    pub(super) const fn new(re: f64, im: f64) -> Self {
        Self { re, im }
    }

    #[inline]
    pub(super) const fn real(re: f64) -> Self {
        Self { re, im: 0.0 }
    }

    /// The number of modulus one at a given angle.
    pub(super) fn unit(angle: f64) -> Self {
        let (im, re) = Float::sin_cos(angle);
        Self { re, im }
    }

    #[inline]
    pub(super) fn scale(self, factor: f64) -> Self {
        Self::new(self.re * factor, self.im * factor)
    }

    #[inline]
    pub(super) fn norm_squared(self) -> f64 {
        self.re * self.re + self.im * self.im
    }

    #[inline]
    pub(super) fn norm(self) -> f64 {
        Float::sqrt(self.norm_squared())
    }

    #[inline]
    pub(super) fn inverse(self) -> Self {
        let factor = 1.0 / self.norm_squared();
        Self::new(self.re * factor, -(self.im * factor))
    }

    /// The power with a non-negative integer exponent.
    #[inline]
    pub(super) fn power(self, exponent: u8) -> Self {
        match exponent {
            0 => Self::ONE,
            1 => self,
            2 => self * self,
            _ => (2..exponent).fold(self * self, |product, _| product * self),
        }
    }
}

impl Add for Complex {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.re + other.re, self.im + other.im)
    }
}

impl AddAssign for Complex {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Complex {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.re - other.re, self.im - other.im)
    }
}

impl Mul for Complex {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(
            self.re * other.re - self.im * other.im,
            self.re * other.im + self.im * other.re,
        )
    }
}

impl Neg for Complex {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.re, -self.im)
    }
}

/// The largest modulus.
#[inline]
pub(super) fn largest(values: &[Complex]) -> f64 {
    Float::sqrt(
        values
            .iter()
            .map(|value| value.norm_squared())
            // `f64::max` would ignore NaN.
            .fold(
                0.0,
                |most: f64, next| if next <= most || most.is_nan() { most } else { next },
            ),
    )
}

#[cfg(test)]
mod tests {
    use super::{Complex, largest};

    #[test]
    fn powers_and_inverses() {
        let z = Complex::new(1.0, 2.0);
        assert_eq!(z.power(0), Complex::ONE);
        assert_eq!(z.power(1), z);
        assert_eq!(z.power(2), Complex::new(-3.0, 4.0));
        assert_eq!(z.power(4), Complex::new(-7.0, -24.0));
        assert_eq!(Complex::new(0.0, 2.0).inverse(), Complex::new(0.0, -0.5));
        assert_eq!(Complex::real(4.0).inverse(), Complex::real(0.25));
    }

    #[test]
    fn what_is_not_a_number_is_the_largest() {
        let odd = [Complex::ONE, Complex::real(f64::NAN), Complex::real(3.0)];
        assert!(largest(&odd).is_nan());
        assert_eq!(largest(&odd[..1]), 1.0);
    }
}
