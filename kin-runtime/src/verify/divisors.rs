//! Numbers that remember how fast the divisors of a formula change.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::gauge;
use crate::number::Number;
use crate::number::series::Series;
use crate::solve::Scalar;

/// A function of time with the largest rate of all divisors that it has been computed with.
///
/// The n-th derivative of a/b has terms of the size (b'/b)ⁿ, however slowly the quotient itself changes. So have the
/// functions whose derivatives are quotients: a root, an angle of a vector, a logarithm. Near a zero of the divisor
/// these terms are large and cancel, and their rounding errors remain.
#[derive(Clone, Copy, Debug)]
pub struct Divided {
    /// The function itself.
    pub(super) value: Series<5>,
    /// The largest |b⁽ᵏ⁾/b|^(1/k) over all divisors b and orders k.
    pub(super) frequency: f64,
}

impl Divided {
    /// A number that has not been computed.
    pub(super) const fn given(value: Series<5>) -> Self {
        Self { value, frequency: 0.0 }
    }

    const fn new(value: Series<5>, frequency: f64) -> Self {
        Self { value, frequency }
    }

    /// A function of the number whose derivatives divide by nothing.
    fn smooth(self, function: impl Fn(Series<5>) -> Series<5>) -> Self {
        Self::new(function(self.value), self.frequency)
    }

    /// A function of the number whose derivatives divide by another function of the number.
    fn divided(self, value: Series<5>, divisor: Series<5>) -> Self {
        Self::new(value, self.frequency.max(frequency(divisor)))
    }
}

/// How fast a divisor changes, relative to itself.
fn frequency(divisor: Series<5>) -> f64 {
    gauge::frequency(&divisor.derivatives(), divisor.real().abs())
}

fn one() -> Series<5> {
    Number::constant(1.0)
}

impl Add for Divided {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.frequency.max(other.frequency))
    }
}

impl Sub for Divided {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, self.frequency.max(other.frequency))
    }
}

impl Mul for Divided {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self::new(self.value * other.value, self.frequency.max(other.frequency))
    }
}

impl Div for Divided {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let known = self.frequency.max(other.frequency);
        Self::new(self.value / other.value, known.max(frequency(other.value)))
    }
}

impl Neg for Divided {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.value, self.frequency)
    }
}

impl Number for Divided {
    const EPSILON: f64 = f64::EPSILON;
    const ORDER: usize = <Series<5> as Number>::ORDER;

    fn constant(value: f64) -> Self {
        Self::given(Number::constant(value))
    }

    fn real(self) -> f64 {
        self.value.real()
    }

    fn is_finite(self) -> bool {
        self.value.is_finite() && self.frequency.is_finite()
    }

    fn sqrt(self) -> Self {
        self.divided(self.value.sqrt(), self.value)
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (Self::new(sine, self.frequency), Self::new(cosine, self.frequency))
    }

    fn asin(self) -> Self {
        self.divided(self.value.asin(), (one() - self.value) * (one() + self.value))
    }

    fn acos(self) -> Self {
        self.divided(self.value.acos(), (one() - self.value) * (one() + self.value))
    }

    fn atan(self) -> Self {
        self.divided(self.value.atan(), one() + self.value * self.value)
    }

    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        let known = self.frequency.max(x.frequency);
        Self::new(self.value.atan2(x.value), known.max(frequency(square)))
    }

    fn sinh(self) -> Self {
        self.smooth(Number::sinh)
    }

    fn cosh(self) -> Self {
        self.smooth(Number::cosh)
    }

    fn tanh(self) -> Self {
        self.smooth(Number::tanh)
    }

    fn asinh(self) -> Self {
        self.divided(self.value.asinh(), one() + self.value * self.value)
    }

    fn acosh(self) -> Self {
        self.divided(self.value.acosh(), (self.value - one()) * (self.value + one()))
    }

    fn atanh(self) -> Self {
        self.divided(self.value.atanh(), (one() - self.value) * (one() + self.value))
    }

    fn exp(self) -> Self {
        self.smooth(Number::exp)
    }

    fn ln(self) -> Self {
        self.divided(self.value.ln(), self.value)
    }
}

impl Scalar for Divided {}

#[cfg(test)]
mod tests {
    use core::f64::consts::FRAC_PI_2;

    use super::Divided;
    use crate::number::Number;
    use crate::number::series::Series;

    /// At a distance δ from a zero of the divisor, the n-th derivative of a function is that of the singularity: it
    /// grows with 1/δⁿ, and so does the power of the rate. Without a zero nearby, nothing divides by anything small.
    #[test]
    fn divisors_are_as_fast_as_the_singularity_is_near() {
        fn rate(at: f64, function: impl Fn(Divided) -> Divided) -> f64 {
            function(Divided::given(Series::from_coefficients([at, 1.0, 0.0, 0.0, 0.0]))).frequency
        }
        fn check(name: &str, singularity: f64, function: impl Fn(Divided) -> Divided) {
            for distance in [1e-3, 1e-5] {
                let near = rate(singularity + distance, &function) * distance;
                assert!((0.5..4.0).contains(&near), "{name}, {distance} away: {near}");
            }
            let far = rate(singularity + 0.5, &function);
            assert!(far < 10.0, "{name}, far away: {far}");
        }
        let one = Divided::constant(1.0);
        check("quotient", 0.0, |x| one / x);
        check("negative power", 0.0, |x| x.powi(-3));
        check("square root", 0.0, Number::sqrt);
        check("logarithm", 0.0, Number::ln);
        check("arc sine", -1.0, Number::asin);
        check("arc cosine", -1.0, Number::acos);
        check("area hyperbolic cosine", 1.0, Number::acosh);
        check("area hyperbolic tangent", -1.0, Number::atanh);
        check("angle of a short vector", 0.0, |x| x.atan2(x));
        check("tangent", FRAC_PI_2, Number::tan);
        check("what was divided before", 0.0, |x| (one - -(one / x)).sinh() + x * x);
    }

    #[test]
    fn smooth_functions_divide_by_nothing() {
        let x = Divided::given(Series::from_coefficients([1e-6, 1.0, 2.0, 3.0, 4.0]));
        let (sine, cosine) = x.sin_cos();
        for value in [x * x, x.powi(7), sine, cosine, x.exp(), x.sinh(), x.cosh(), x.tanh()] {
            assert_eq!(value.frequency, 0.0);
        }
        for value in [x.atan(), x.asinh()] {
            assert!(value.frequency > 0.0 && value.frequency < 5.0, "{value:?}");
        }
    }
}
