//! Dual numbers nested in each other, as nested differentiation is done by hand and by most libraries: of any number,
//! so that what they cost can be counted.

use core::ops::{Add, Div, Mul, Neg, Sub};

use kin_core::{Number, Scalar};

/// A number and its time derivative. Nested n times it carries the derivatives through the n-th, most of them several
/// times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nested<T> {
    /// The number.
    pub value: T,
    /// Its derivative.
    pub rate: T,
}

impl<T: Number> Nested<T> {
    /// A number with its derivative.
    #[must_use]
    pub const fn new(value: T, rate: T) -> Self {
        Self { value, rate }
    }

    /// A function's value, and its derivative by the number.
    fn chain(self, value: T, slope: T) -> Self {
        Self::new(value, slope * self.rate)
    }

    fn one() -> T {
        T::constant(1.0)
    }
}

impl<T: Number> Add for Nested<T> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.rate + other.rate)
    }
}

impl<T: Number> Sub for Nested<T> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, self.rate - other.rate)
    }
}

impl<T: Number> Neg for Nested<T> {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.value, -self.rate)
    }
}

impl<T: Number> Mul for Nested<T> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::new(
            self.value * other.value,
            self.rate * other.value + self.value * other.rate,
        )
    }
}

impl<T: Number> Div for Nested<T> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        Self::new(quotient, (self.rate - quotient * other.rate) / other.value)
    }
}

impl<T: Number> Number for Nested<T> {
    const EPSILON: f64 = T::EPSILON;
    const SMALLEST_DIVISOR: f64 = T::SMALLEST_DIVISOR;
    const ORDER: usize = T::ORDER + 1;

    fn constant(value: f64) -> Self {
        Self::new(T::constant(value), T::constant(0.0))
    }

    fn real(self) -> f64 {
        self.value.real()
    }

    fn is_finite(self) -> bool {
        self.value.is_finite() && self.rate.is_finite()
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self::new(root, self.rate / (root + root))
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (self.chain(sine, cosine), self.chain(cosine, -sine))
    }

    fn asin(self) -> Self {
        let slope = Self::one() / (Self::one() - self.value * self.value).sqrt();
        self.chain(self.value.asin(), slope)
    }

    fn acos(self) -> Self {
        let slope = -(Self::one() / (Self::one() - self.value * self.value).sqrt());
        self.chain(self.value.acos(), slope)
    }

    fn atan(self) -> Self {
        let slope = Self::one() / (Self::one() + self.value * self.value);
        self.chain(self.value.atan(), slope)
    }

    fn atan2(self, x: Self) -> Self {
        let square = x.value * x.value + self.value * self.value;
        let rate = (x.value * self.rate - self.value * x.rate) / square;
        Self::new(self.value.atan2(x.value), rate)
    }

    fn sinh(self) -> Self {
        self.chain(self.value.sinh(), self.value.cosh())
    }

    fn cosh(self) -> Self {
        self.chain(self.value.cosh(), self.value.sinh())
    }

    fn tanh(self) -> Self {
        let value = self.value.tanh();
        self.chain(value, Self::one() - value * value)
    }

    fn asinh(self) -> Self {
        let slope = Self::one() / (Self::one() + self.value * self.value).sqrt();
        self.chain(self.value.asinh(), slope)
    }

    fn acosh(self) -> Self {
        let slope = Self::one() / (self.value * self.value - Self::one()).sqrt();
        self.chain(self.value.acosh(), slope)
    }

    fn atanh(self) -> Self {
        let slope = Self::one() / (Self::one() - self.value * self.value);
        self.chain(self.value.atanh(), slope)
    }

    fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value)
    }

    fn ln(self) -> Self {
        Self::new(self.value.ln(), self.rate / self.value)
    }
}

impl<T: Scalar> Scalar for Nested<T> {}
