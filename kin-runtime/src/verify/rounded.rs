//! Bounds on the rounding errors of a formula.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::number::Number;
use crate::solve::Scalar;

/// A number with a bound on its rounding error, in units of ε, to first order: running error analysis (N. J. Higham,
/// *Accuracy and Stability of Numerical Algorithms*, 2nd edition, SIAM 2002, section 3.3).
///
/// Derivatives show how much an error in the data shifts a result, but not the errors of large terms that cancel on the
/// way. The bound includes those errors.
#[derive(Clone, Copy, Debug)]
pub struct Rounded {
    value: f64,
    /// The absolute error of the value.
    error: f64,
}

impl Rounded {
    /// A number without error.
    pub(super) const fn exactly(value: f64) -> Self {
        Self { value, error: 0.0 }
    }

    /// The bound on the absolute error, in units of ε.
    pub(super) const fn error(self) -> f64 {
        self.error
    }

    /// A result rounded to the nearest number, in addition to the errors passed on to it.
    fn nearest(value: f64, passed_on: f64) -> Self {
        Self {
            value,
            error: passed_on + value.abs() / 2.0,
        }
    }

    /// The result of a function with a given slope. The error of the function is at most one unit in the last place.
    fn function(self, value: f64, slope: f64) -> Self {
        Self {
            value,
            error: passed(slope, self.error) + value.abs(),
        }
    }
}

/// An error multiplied by a slope. Without an error there is none, however steep the slope.
fn passed(slope: f64, error: f64) -> f64 {
    if error == 0.0 { 0.0 } else { slope.abs() * error }
}

impl Add for Rounded {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::nearest(self.value + other.value, self.error + other.error)
    }
}

impl Sub for Rounded {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::nearest(self.value - other.value, self.error + other.error)
    }
}

impl Mul for Rounded {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let passed_on = passed(other.value, self.error) + passed(self.value, other.error);
        Self::nearest(self.value * other.value, passed_on)
    }
}

impl Div for Rounded {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let slope = 1.0 / other.value;
        Self::nearest(
            quotient,
            passed(slope, self.error) + passed(quotient * slope, other.error),
        )
    }
}

impl Neg for Rounded {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: -self.value,
            ..self
        }
    }
}

impl Number for Rounded {
    const EPSILON: f64 = f64::EPSILON;

    fn constant(value: f64) -> Self {
        Self::nearest(value, 0.0)
    }

    fn real(self) -> f64 {
        self.value
    }

    fn is_finite(self) -> bool {
        self.value.is_finite() && self.error.is_finite()
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        Self::nearest(root, passed(0.5 / root, self.error))
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (self.function(sine, cosine), self.function(cosine, sine))
    }

    fn asin(self) -> Self {
        self.function(self.value.asin(), 1.0 / (1.0 - self.value * self.value).sqrt())
    }

    fn acos(self) -> Self {
        self.function(self.value.acos(), 1.0 / (1.0 - self.value * self.value).sqrt())
    }

    fn atan(self) -> Self {
        self.function(self.value.atan(), 1.0 / (1.0 + self.value * self.value))
    }

    fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        let angle = self.value.atan2(x.value);
        Self {
            value: angle,
            error: passed(x.value / square, self.error) + passed(self.value / square, x.error) + angle.abs(),
        }
    }

    fn sinh(self) -> Self {
        self.function(Number::sinh(self.value), Number::cosh(self.value))
    }

    fn cosh(self) -> Self {
        self.function(Number::cosh(self.value), Number::sinh(self.value))
    }

    fn tanh(self) -> Self {
        let value = Number::tanh(self.value);
        self.function(value, (1.0 - value) * (1.0 + value))
    }

    fn asinh(self) -> Self {
        let slope = 1.0 / (1.0 + self.value * self.value).sqrt();
        self.function(Number::asinh(self.value), slope)
    }

    fn acosh(self) -> Self {
        let slope = 1.0 / ((self.value - 1.0) * (self.value + 1.0)).sqrt();
        self.function(Number::acosh(self.value), slope)
    }

    fn atanh(self) -> Self {
        let slope = 1.0 / ((1.0 - self.value) * (1.0 + self.value));
        self.function(Number::atanh(self.value), slope)
    }

    fn exp(self) -> Self {
        let power = self.value.exp();
        self.function(power, power)
    }

    fn ln(self) -> Self {
        self.function(self.value.ln(), 1.0 / self.value)
    }
}

impl Scalar for Rounded {}

#[cfg(test)]
mod tests {
    use super::Rounded;
    use crate::number::Number;

    /// The expression (1 + x)³ - 1 - 3x - 3x² - x³ consists of rounding error only, of the size of its terms.
    #[test]
    fn cancelled_terms_are_remembered() {
        let one = Rounded::exactly(1.0);
        for x in [0.1, 0.3, 7.7, 123.4] {
            let x = Rounded::exactly(x);
            let three = one + one + one;
            let sum = one + x;
            let left = sum * sum * sum - one - three * x - three * x * x - x * x * x;
            let largest = sum.real().powi(3);
            assert!(left.real().abs() <= left.error() * f64::EPSILON);
            assert!(left.error() >= largest && left.error() <= 20.0 * largest, "{left:?}");
        }
    }

    /// Each function with an argument that has an error of some ε, compared with the function at shifted arguments.
    #[test]
    fn errors_pass_through_functions() {
        fn check(name: &str, function: impl Fn(Rounded) -> Rounded) {
            // Far beyond the rounding of the function itself, and small enough for the slope to describe the change.
            const ERROR: f64 = 1e6;
            for value in [0.2, 0.6] {
                let error = function(Rounded { value, error: ERROR }).error();
                let beside = |step: f64| function(Rounded::exactly(value + step * ERROR * f64::EPSILON)).real();
                let change = (beside(1.0) - beside(-1.0)).abs() / (2.0 * f64::EPSILON);
                assert!((error / change - 1.0).abs() < 1e-4, "{name}: {error} against {change}");
            }
        }
        let two = Rounded::exactly(2.0);
        check("square root", Number::sqrt);
        check("sine", |x| x.sin_cos().0);
        check("cosine", |x| x.sin_cos().1);
        check("arc sine", Number::asin);
        check("arc cosine", Number::acos);
        check("arc tangent", Number::atan);
        check("angle of y", |x| x.atan2(two));
        check("angle of x", |x| two.atan2(x));
        check("hyperbolic sine", Number::sinh);
        check("hyperbolic cosine", Number::cosh);
        check("hyperbolic tangent", Number::tanh);
        check("area hyperbolic sine", Number::asinh);
        check("area hyperbolic cosine", |x| (x + two).acosh());
        check("area hyperbolic tangent", Number::atanh);
        check("exponential", Number::exp);
        check("logarithm", Number::ln);
        check("quotient", |x| two / x);
        check("quotient by", |x| x / two);
        check("product", |x| x * two);
        check("difference", |x| two - -x);
    }
}
