//! Truncated Taylor series in time that know how far rounding may have moved them.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// Coefficients that are kept: from the position through the snap.
pub(crate) const TERMS: usize = 5;

/// A Taylor series, cut off after the term of the snap.
///
/// Beside each coefficient stands a bound on its error, in units of ε and to first order: what the errors of the leaves and the
/// rounding of every operation can add up to (N. J. Higham, *Accuracy and Stability of Numerical Algorithms*, 2nd edition,
/// SIAM 2002, section 3.3). The series shares no code with `kin_core::series`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Taylor {
    /// The coefficients in ascending powers of time.
    pub(crate) value: [f64; TERMS],
    /// The bound on the error of each, in units of ε.
    pub(crate) error: [f64; TERMS],
}

/// The error of rounding a number that is too small for all its digits, in units of ε.
const UNDERFLOW: f64 = f64::MIN_POSITIVE;

/// k as a number, for the few coefficients there are.
const NUMBER: [f64; TERMS] = [0.0, 1.0, 2.0, 3.0, 4.0];

/// The factorials.
pub(crate) const FACTORIAL: [f64; TERMS] = [1.0, 1.0, 2.0, 6.0, 24.0];

impl Taylor {
    /// A number that does not move and is known exactly.
    #[must_use]
    pub(crate) const fn constant(value: f64) -> Self {
        Self {
            value: [value, 0.0, 0.0, 0.0, 0.0],
            error: [0.0; TERMS],
        }
    }

    /// A number that does not move and is rounded.
    #[must_use]
    pub(crate) const fn rounded(value: f64) -> Self {
        Self {
            value: [value, 0.0, 0.0, 0.0, 0.0],
            error: [value.abs(), 0.0, 0.0, 0.0, 0.0],
        }
    }

    /// The series of given derivatives, each of which is rounded.
    #[must_use]
    pub(crate) fn from_derivatives(derivatives: [f64; TERMS]) -> Self {
        let mut value = derivatives;
        for (value, factorial) in value.iter_mut().zip(FACTORIAL) {
            *value /= factorial;
        }
        Self {
            value,
            error: value.map(f64::abs),
        }
    }

    /// The series f with f₀ = `constant` and f' = slope · g', where g is `self`.
    fn composed(self, constant: f64, slope: Self) -> Self {
        let mut result = Self::constant(constant);
        result.error[0] = slope.value[0].abs() * self.error[0] + constant.abs();
        for k in 1..TERMS {
            result.chain(k, self, slope, 1.0);
        }
        result
    }

    /// Sets the k-th coefficient to that of `sign` ∫ slope · g' dt.
    fn chain(&mut self, k: usize, g: Self, slope: Self, sign: f64) {
        let (mut sum, mut error) = (0.0, 0.0);
        for (j, number) in NUMBER.iter().enumerate().take(k + 1).skip(1) {
            let (rate, other) = (number * g.value[j], slope.value[k - j]);
            sum += rate * other;
            error += (rate * other).abs() + number * g.error[j] * other.abs() + rate.abs() * slope.error[k - j];
        }
        self.value[k] = sign * sum / NUMBER[k];
        self.error[k] = error / NUMBER[k] + UNDERFLOW;
    }

    /// Sine and cosine.
    #[must_use]
    pub(crate) fn sin_cos(self) -> (Self, Self) {
        let (s, c) = self.value[0].sin_cos();
        let (mut sine, mut cosine) = (Self::constant(s), Self::constant(c));
        sine.error[0] = c.abs() * self.error[0] + s.abs();
        cosine.error[0] = s.abs() * self.error[0] + c.abs();
        for k in 1..TERMS {
            sine.chain(k, self, cosine, 1.0);
            let before = sine;
            cosine.chain(k, self, before, -1.0);
        }
        (sine, cosine)
    }

    /// The sine.
    #[must_use]
    pub(crate) fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// The cosine.
    #[must_use]
    pub(crate) fn cos(self) -> Self {
        self.sin_cos().1
    }

    /// The tangent.
    #[must_use]
    pub(crate) fn tan(self) -> Self {
        let (sine, cosine) = self.sin_cos();
        sine / cosine
    }

    /// The square.
    #[must_use]
    pub(crate) fn squared(self) -> Self {
        self * self
    }

    /// The square root.
    #[must_use]
    pub(crate) fn sqrt(self) -> Self {
        let root = self.value[0].sqrt();
        let mut result = Self::constant(root);
        result.error[0] = if self.error[0] == 0.0 {
            0.0
        } else {
            self.error[0] / (2.0 * root)
        } + root;
        for k in 1..TERMS {
            let (mut rest, mut error) = (self.value[k], self.error[k] + self.value[k].abs());
            for j in 1..k {
                let product = result.value[j] * result.value[k - j];
                rest -= product;
                error += product.abs() + 2.0 * result.error[j] * result.value[k - j].abs();
            }
            result.value[k] = rest / (2.0 * root);
            error += 2.0 * result.value[k].abs() * result.error[0];
            result.error[k] = error / (2.0 * root) + UNDERFLOW;
        }
        result
    }

    /// The exponential function.
    #[must_use]
    pub(crate) fn exp(self) -> Self {
        let power = self.value[0].exp();
        let mut result = Self::constant(power);
        result.error[0] = power * self.error[0] + power;
        for k in 1..TERMS {
            let before = result;
            result.chain(k, self, before, 1.0);
        }
        result
    }

    /// The natural logarithm.
    #[must_use]
    pub(crate) fn ln(self) -> Self {
        self.composed(self.value[0].ln(), Self::constant(1.0) / self)
    }

    /// The arctangent.
    #[must_use]
    pub(crate) fn atan(self) -> Self {
        let one = Self::constant(1.0);
        self.composed(self.value[0].atan(), one / (one + self.squared()))
    }

    /// The angle of the point with this ordinate and the given abscissa.
    #[must_use]
    pub(crate) fn atan2(self, x: Self) -> Self {
        let angle = self.value[0].atan2(x.value[0]);
        let square = x.squared() + self.squared();
        let (along, across) = (x / square, self / square);
        let mut result = Self::constant(angle);
        result.error[0] = along.value[0].abs() * self.error[0] + across.value[0].abs() * x.error[0] + angle.abs();
        for k in 1..TERMS {
            let mut other = Self::constant(0.0);
            result.chain(k, self, along, 1.0);
            other.chain(k, x, across, -1.0);
            result.value[k] += other.value[k];
            result.error[k] += other.error[k];
        }
        result
    }

    /// The arc sine.
    #[must_use]
    pub(crate) fn asin(self) -> Self {
        self.composed(self.value[0].asin(), Self::constant(1.0) / self.other_leg())
    }

    /// The arc cosine.
    #[must_use]
    pub(crate) fn acos(self) -> Self {
        self.composed(self.value[0].acos(), Self::constant(-1.0) / self.other_leg())
    }

    /// The other leg of a right triangle with this one and a hypotenuse of 1.
    fn other_leg(self) -> Self {
        let one = Self::constant(1.0);
        ((one - self) * (one + self)).sqrt()
    }
}

impl Add for Taylor {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let mut sum = self;
        for k in 0..TERMS {
            sum.value[k] = self.value[k] + other.value[k];
            sum.error[k] = self.error[k] + other.error[k] + sum.value[k].abs() / 2.0;
        }
        sum
    }
}

impl Neg for Taylor {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: self.value.map(|value| -value),
            error: self.error,
        }
    }
}

impl Sub for Taylor {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

/// Cauchy's product.
impl Mul for Taylor {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let mut product = Self::constant(0.0);
        for k in 0..TERMS {
            let mut error = UNDERFLOW;
            for j in 0..=k {
                let (a, b) = (self.value[j], other.value[k - j]);
                product.value[k] += a * b;
                error += (a * b).abs() + self.error[j] * b.abs() + a.abs() * other.error[k - j];
            }
            product.error[k] = error;
        }
        product
    }
}

impl Div for Taylor {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let divisor = other.value[0];
        let mut quotient = Self::constant(0.0);
        for k in 0..TERMS {
            let (mut rest, mut error) = (self.value[k], self.error[k] + self.value[k].abs());
            for j in 1..=k {
                let (a, b) = (other.value[j], quotient.value[k - j]);
                rest -= a * b;
                error += (a * b).abs() + other.error[j] * b.abs() + a.abs() * quotient.error[k - j];
            }
            quotient.value[k] = rest / divisor;
            quotient.error[k] = (error + other.error[0] * quotient.value[k].abs()) / divisor.abs() + UNDERFLOW;
        }
        quotient
    }
}

#[cfg(test)]
mod tests {
    use super::{FACTORIAL, TERMS, Taylor};

    /// A series against the derivatives that are known of it.
    #[track_caller]
    fn assert_series(series: Taylor, derivatives: [f64; TERMS]) {
        for (k, expected) in derivatives.into_iter().enumerate() {
            let found = series.value[k] * FACTORIAL[k];
            let allowed = f64::EPSILON * series.error[k] * FACTORIAL[k];
            assert!((found - expected).abs() <= allowed, "{k}: {found} {expected} {allowed}");
            assert!(
                series.error[k] <= 100.0 * series.value[k].abs().max(1.0),
                "{k}: {:?}",
                series.error
            );
        }
    }

    #[test]
    fn functions_have_the_derivatives_that_are_known_of_them() {
        let t = Taylor {
            value: [0.3, 1.0, 0.0, 0.0, 0.0],
            error: [0.0; TERMS],
        };
        let (s, c) = 0.3_f64.sin_cos();
        let e = 0.3_f64.exp();
        assert_series(t.sin(), [s, c, -s, -c, s]);
        assert_series(t.cos(), [c, -s, -c, s, c]);
        assert_series(t.exp(), [e; TERMS]);
        assert_series(
            t.ln(),
            [0.3_f64.ln(), 1.0 / 0.3, -1.0 / 0.09, 2.0 / 0.027, -6.0 / 0.0081],
        );
        let r = 0.3_f64.sqrt();
        assert_series(
            t.sqrt(),
            [r, 0.5 / r, -0.25 / (0.3 * r), 0.375 / (0.09 * r), -0.9375 / (0.027 * r)],
        );
        assert_series(t * t * t, [0.027, 0.27, 1.8, 6.0, 0.0]);
        let q = 1.0 / 0.3;
        assert_series(
            Taylor::constant(1.0) / t,
            [q, -q * q, 2.0 * q.powi(3), -6.0 * q.powi(4), 24.0 * q.powi(5)],
        );
    }

    #[test]
    fn inverse_functions_undo_what_they_are_the_inverse_of() {
        let t = Taylor::from_derivatives([0.4, 0.7, -0.2, 1.1, -0.6]);
        let (sine, cosine) = t.sin_cos();
        for undone in [
            sine.asin(),
            cosine.acos(),
            t.tan().atan(),
            (t * sine).atan2(t * cosine),
            t.exp().ln(),
            t.squared().sqrt(),
        ] {
            for k in 0..TERMS {
                let left = (undone.value[k] - t.value[k]).abs();
                assert!(
                    left <= f64::EPSILON * undone.error[k],
                    "{k}: {left:e} {:?}",
                    undone.error
                );
            }
        }
    }
}
