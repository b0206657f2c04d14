//! Series that know how far rounding may have moved them.

use std::f64::consts::PI;
use std::ops::{Add, Div, Mul, Neg, Sub};

use kin_core::series::Series;
use kin_core::{Number, Scalar};

/// Coefficients that are kept: from the position through the snap.
pub(crate) const TERMS: usize = 5;

/// A series of `kin_core`, cut off after the term of the snap.
///
/// Beside each coefficient stands a bound on its error, in units of ε and to first order: what the errors of the leaves
/// and the rounding of every operation can add up to (N. J. Higham, *Accuracy and Stability of Numerical Algorithms*,
/// 2nd edition, SIAM 2002, section 3.3).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bounded {
    series: Series<TERMS>,
    /// The bound on the error of each coefficient, in units of ε.
    pub(crate) error: [f64; TERMS],
}

/// The error of rounding a number that is too small for all its digits, in units of ε.
const UNDERFLOW: f64 = f64::MIN_POSITIVE;

/// k as a number, for the few coefficients there are.
const NUMBER: [f64; TERMS] = [0.0, 1.0, 2.0, 3.0, 4.0];

/// The factorials.
pub(crate) const FACTORIAL: [f64; TERMS] = [1.0, 1.0, 2.0, 6.0, 24.0];

impl Bounded {
    const fn exact(series: Series<TERMS>) -> Self {
        Self {
            series,
            error: [0.0; TERMS],
        }
    }

    /// A number that is known exactly and moves at this rate.
    pub(crate) const fn moving(value: f64, rate: f64) -> Self {
        Self::exact(Series::from_coefficients([value, rate, 0.0, 0.0, 0.0]))
    }

    /// A number that does not move and is rounded.
    pub(crate) const fn rounded(value: f64) -> Self {
        Self {
            error: [value.abs(), 0.0, 0.0, 0.0, 0.0],
            ..Self::moving(value, 0.0)
        }
    }

    /// The series of given derivatives, each of which is rounded.
    pub(crate) fn from_derivatives(derivatives: [f64; TERMS]) -> Self {
        let series = Series::from_derivatives(derivatives);
        Self {
            error: series.coefficients().map(f64::abs),
            series,
        }
    }

    /// The coefficients in ascending powers of time.
    pub(crate) const fn value(&self) -> [f64; TERMS] {
        self.series.coefficients()
    }

    fn sum(self, other: Self) -> Self {
        let series = self.series + other.series;
        let rounded = series.coefficients();
        Self {
            series,
            error: std::array::from_fn(|k| self.error[k] + other.error[k] + rounded[k].abs() / 2.0),
        }
    }

    fn product(self, other: Self) -> Self {
        let (own, others) = (self.value(), other.value());
        let error = |k: usize| {
            let terms = (0..=k).map(|j| {
                let (a, b) = (own[j], others[k - j]);
                (a * b).abs() + self.error[j] * b.abs() + a.abs() * other.error[k - j]
            });
            terms.sum::<f64>() + UNDERFLOW
        };
        Self {
            series: self.series * other.series,
            error: std::array::from_fn(error),
        }
    }

    /// The error of the k-th coefficient of f, where f' = `slope` · g' and g is `self`.
    fn chained(self, k: usize, slope: Self) -> f64 {
        let (g, h) = (self.value(), slope.value());
        let terms = (1..=k).map(|j| {
            let (rate, other) = (NUMBER[j] * g[j], h[k - j]);
            (rate * other).abs() + NUMBER[j] * self.error[j] * other.abs() + rate.abs() * slope.error[k - j]
        });
        terms.sum::<f64>() / NUMBER[k] + UNDERFLOW
    }

    /// The function of given series of which `slope` is the derivative by `self`.
    fn composed(self, series: Series<TERMS>, slope: Self) -> Self {
        let error = std::array::from_fn(|k| match k {
            0 => slope.value()[0].abs() * self.error[0] + series.real().abs(),
            k => self.chained(k, slope),
        });
        Self { series, error }
    }

    /// Two functions of which each is the derivative of the other by `self`, but for its sign.
    fn mutual(self, one: Series<TERMS>, other: Series<TERMS>) -> (Self, Self) {
        let (mut one, mut other) = (Self::exact(one), Self::exact(other));
        let [first, second] = [one, other].map(|own| own.value()[0].abs());
        one.error[0] = second * self.error[0] + first;
        other.error[0] = first * self.error[0] + second;
        for k in 1..TERMS {
            one.error[k] = self.chained(k, other);
            other.error[k] = self.chained(k, one);
        }
        (one, other)
    }

    /// The other leg of a right triangle with this one and a hypotenuse of 1.
    fn other_leg(self) -> Self {
        let one = Self::constant(1.0);
        ((one - self) * (one + self)).sqrt()
    }
}

impl Add for Bounded {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.sum(other)
    }
}

impl Neg for Bounded {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            series: -self.series,
            ..self
        }
    }
}

impl Sub for Bounded {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Bounded {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        self.product(other)
    }
}

impl Div for Bounded {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let mut quotient = Self::exact(self.series / other.series);
        let (own, divisor, result) = (self.value(), other.value(), quotient.value());
        for k in 0..TERMS {
            let terms = (1..=k).map(|j| {
                let (a, b) = (divisor[j], result[k - j]);
                (a * b).abs() + other.error[j] * b.abs() + a.abs() * quotient.error[k - j]
            });
            let error = self.error[k] + own[k].abs() + terms.sum::<f64>() + other.error[0] * result[k].abs();
            quotient.error[k] = error / divisor[0].abs() + UNDERFLOW;
        }
        quotient
    }
}

impl Number for Bounded {
    const EPSILON: f64 = f64::EPSILON;

    /// Exact but for π.
    fn constant(value: f64) -> Self {
        if value.abs() == PI {
            Self::rounded(value)
        } else {
            Self::moving(value, 0.0)
        }
    }

    fn real(self) -> f64 {
        self.series.real()
    }

    fn is_finite(self) -> bool {
        self.series.is_finite()
    }

    fn sqrt(self) -> Self {
        let mut result = Self::exact(self.series.sqrt());
        let (own, root) = (self.value(), result.value());
        let double = 2.0 * root[0];
        // zero is known exactly where its square is
        result.error[0] = if self.error[0] == 0.0 {
            0.0
        } else {
            self.error[0] / double
        } + root[0];
        for k in 1..TERMS {
            let terms = (1..k).map(|j| (root[j] * root[k - j]).abs() + 2.0 * result.error[j] * root[k - j].abs());
            let error = self.error[k] + own[k].abs() + terms.sum::<f64>() + 2.0 * root[k].abs() * result.error[0];
            result.error[k] = error / double + UNDERFLOW;
        }
        result
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.series.sin_cos();
        self.mutual(sine, cosine)
    }

    fn asin(self) -> Self {
        self.composed(self.series.asin(), Self::constant(1.0) / self.other_leg())
    }

    fn acos(self) -> Self {
        self.composed(self.series.acos(), Self::constant(-1.0) / self.other_leg())
    }

    fn atan(self) -> Self {
        let one = Self::constant(1.0);
        self.composed(self.series.atan(), one / (one + self * self))
    }

    fn atan2(self, x: Self) -> Self {
        let square = x * x + self * self;
        let (along, across) = (x / square, self / square);
        let series = self.series.atan2(x.series);
        let error = std::array::from_fn(|k| match k {
            0 => along.real().abs() * self.error[0] + across.real().abs() * x.error[0] + series.real().abs(),
            k => self.chained(k, along) + x.chained(k, across),
        });
        Self { series, error }
    }

    fn sinh(self) -> Self {
        self.mutual(self.series.sinh(), self.series.cosh()).0
    }

    fn cosh(self) -> Self {
        self.mutual(self.series.sinh(), self.series.cosh()).1
    }

    fn tanh(self) -> Self {
        let cosine = self.cosh();
        self.composed(self.series.tanh(), Self::constant(1.0) / (cosine * cosine))
    }

    fn asinh(self) -> Self {
        let one = Self::constant(1.0);
        self.composed(self.series.asinh(), one / (one + self * self).sqrt())
    }

    fn acosh(self) -> Self {
        let one = Self::constant(1.0);
        self.composed(self.series.acosh(), one / ((self - one) * (self + one)).sqrt())
    }

    fn atanh(self) -> Self {
        let one = Self::constant(1.0);
        self.composed(self.series.atanh(), one / ((one - self) * (one + self)))
    }

    fn exp(self) -> Self {
        let power = self.series.exp();
        self.mutual(power, power).0
    }

    fn ln(self) -> Self {
        self.composed(self.series.ln(), Self::constant(1.0) / self)
    }
}

impl Scalar for Bounded {}

#[cfg(test)]
mod tests {
    use kin_core::Number;

    use super::{Bounded, FACTORIAL, TERMS};

    /// A series against the derivatives that are known of it.
    #[track_caller]
    fn assert_series(series: Bounded, derivatives: [f64; TERMS]) {
        for (k, expected) in derivatives.into_iter().enumerate() {
            let found = series.value()[k] * FACTORIAL[k];
            let allowed = f64::EPSILON * series.error[k] * FACTORIAL[k];
            assert!((found - expected).abs() <= allowed, "{k}: {found} {expected} {allowed}");
            assert!(
                series.error[k] <= 100.0 * series.value()[k].abs().max(1.0),
                "{k}: {series:?}"
            );
        }
    }

    /// The bounds hold, and are no larger than they must be.
    #[test]
    fn functions_of_time() {
        let t = Bounded::moving(0.3, 1.0);
        let ((s, c), e, r, q) = (0.3_f64.sin_cos(), 0.3_f64.exp(), 0.3_f64.sqrt(), 1.0 / 0.3);
        assert_series(t.sin(), [s, c, -s, -c, s]);
        assert_series(t.cos(), [c, -s, -c, s, c]);
        assert_series(t.exp(), [e; TERMS]);
        assert_series(t.ln(), [0.3_f64.ln(), q, -1.0 / 0.09, 2.0 / 0.027, -6.0 / 0.0081]);
        assert_series(
            t.sqrt(),
            [r, 0.5 / r, -0.25 / (0.3 * r), 0.375 / (0.09 * r), -0.9375 / (0.027 * r)],
        );
        assert_series(t * t * t, [0.027, 0.27, 1.8, 6.0, 0.0]);
        assert_series(
            Bounded::constant(1.0) / t,
            [q, -q * q, 2.0 * q.powi(3), -6.0 * q.powi(4), 24.0 * q.powi(5)],
        );
    }

    #[test]
    fn inverses_stay_within_their_bounds() {
        let t = Bounded::from_derivatives([0.4, 0.7, -0.2, 1.1, -0.6]);
        let (sine, cosine) = t.sin_cos();
        for undone in [
            sine.asin(),
            cosine.acos(),
            t.tan().atan(),
            (t * sine).atan2(t * cosine),
            t.exp().ln(),
            (t * t).sqrt(),
            t.sinh().asinh(),
            t.cosh().acosh(),
            t.tanh().atanh(),
        ] {
            for k in 0..TERMS {
                let left = (undone.value()[k] - t.value()[k]).abs();
                assert!(
                    left <= f64::EPSILON * undone.error[k],
                    "{k}: {left:e} {:?}",
                    undone.error
                );
            }
        }
    }
}
