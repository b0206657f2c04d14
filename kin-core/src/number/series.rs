//! Truncated Taylor series in time.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::number::Number;

/// A Taylor series in time, cut off after `N` terms: `c₀ + c₁ t + c₂ t² + …`.
///
/// Every operation is exact up to rounding in the terms that are kept. To check derivatives, put the motion of a
/// mechanism into its closure as such series: every coefficient of the residual must vanish. This checks the
/// derivatives of all orders at once, and it shares nothing with the method that computed them.
///
/// The recurrences come from A. Griewank and A. Walther, *Evaluating Derivatives*, 2nd edition, SIAM 2008, chapter 13.
///
/// ```
/// use kin_core::Number;
/// use kin_core::series::Series;
///
/// // an angle that starts at 0 with speed 2: its sine has the derivatives 0, 2, 0, -8
/// let angle = Series::from_derivatives([0.0, 2.0, 0.0, 0.0]);
/// let (sine, _) = angle.sin_cos();
/// assert_eq!(sine.derivatives(), [0.0, 2.0, 0.0, -8.0]);
/// ```
///
/// Plain numbers take part as constants. Comparisons, `==` among them, compare the values and leave the derivatives
/// aside:
///
/// ```
/// use kin_core::Number;
/// use kin_core::series::Series;
///
/// let angle = Series::from_derivatives([0.5, 2.0, 0.0]);
/// let lift = 3.0 * angle.sin() + 1.0;
/// assert!(lift > 2.0 && lift == 3.0 * 0.5_f64.sin() + 1.0);
/// assert_eq!((-lift).abs().derivatives(), lift.derivatives());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Series<const N: usize> {
    coefficients: [f64; N],
}

impl<const N: usize> Series<N> {
    /// Zero.
    pub const ZERO: Self = Self { coefficients: [0.0; N] };

    /// The series with the given coefficients, in ascending powers of time.
    #[must_use]
    pub const fn from_coefficients(coefficients: [f64; N]) -> Self {
        const { assert!(N > 0, "a series has a constant term at least") };
        Self { coefficients }
    }

    /// The coefficients in ascending powers of time.
    #[must_use]
    pub const fn coefficients(&self) -> [f64; N] {
        self.coefficients
    }

    /// The series of a function, from its value and its derivatives.
    #[must_use]
    pub fn from_derivatives(mut derivatives: [f64; N]) -> Self {
        let mut factorial = 1.0;
        for (order, entry) in derivatives.iter_mut().enumerate().skip(1) {
            factorial *= number(order);
            *entry /= factorial;
        }
        Self::from_coefficients(derivatives)
    }

    /// The value and the derivatives at time zero.
    #[must_use]
    pub fn derivatives(self) -> [f64; N] {
        let mut derivatives = self.coefficients;
        let mut factorial = 1.0;
        for (order, entry) in derivatives.iter_mut().enumerate().skip(1) {
            factorial *= number(order);
            *entry *= factorial;
        }
        derivatives
    }

    /// The series f with the given constant term and f' = derivative / denominator. Every function with an algebraic
    /// derivative follows this rule.
    fn integrate(constant: f64, derivative: Self, denominator: Self) -> Self {
        let d = denominator.coefficients;
        let mut f = [0.0; N];
        f[0] = constant;
        for k in 1..N {
            let mut sum = derivative.coefficients[k - 1];
            for j in 1..k {
                sum -= number(j) * f[j] * d[k - j];
            }
            f[k] = sum / (number(k) * d[0]);
        }
        Self::from_coefficients(f)
    }

    /// The hyperbolic sine and cosine: the derivative of each is the other.
    fn sinh_cosh(self) -> (Self, Self) {
        let a = self.coefficients;
        let (mut sine, mut cosine) = ([0.0; N], [0.0; N]);
        (sine[0], cosine[0]) = (Number::sinh(a[0]), Number::cosh(a[0]));
        for k in 1..N {
            for j in 1..=k {
                let rate = number(j) * a[j] / number(k);
                sine[k] += rate * cosine[k - j];
                cosine[k] += rate * sine[k - j];
            }
        }
        (Self::from_coefficients(sine), Self::from_coefficients(cosine))
    }

    /// The derivative with respect to time. Its last coefficient is unknown and is set to zero.
    pub(crate) fn differentiate(self) -> Self {
        let mut slope = [0.0; N];
        for k in 1..N {
            slope[k - 1] = number(k) * self.coefficients[k];
        }
        Self::from_coefficients(slope)
    }

    /// The series of another number of terms, of which further ones are zero.
    #[cfg(feature = "alloc")]
    pub(crate) fn resized<const M: usize>(&self) -> Series<M> {
        Series::from_coefficients(core::array::from_fn(|power| {
            self.coefficients.get(power).copied().unwrap_or(0.0)
        }))
    }

    fn map(self, function: impl FnMut(f64) -> f64) -> Self {
        Self::from_coefficients(self.coefficients.map(function))
    }
}

#[expect(clippy::cast_precision_loss, reason = "the number of terms of a series is small")]
const fn number(index: usize) -> f64 {
    index as f64
}

impl<const N: usize> Add for Series<N> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let mut sum = self.coefficients;
        for (term, addend) in sum.iter_mut().zip(other.coefficients) {
            *term += addend;
        }
        Self::from_coefficients(sum)
    }
}

impl<const N: usize> Sub for Series<N> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        let mut difference = self.coefficients;
        for (term, subtrahend) in difference.iter_mut().zip(other.coefficients) {
            *term -= subtrahend;
        }
        Self::from_coefficients(difference)
    }
}

impl<const N: usize> Neg for Series<N> {
    type Output = Self;

    fn neg(self) -> Self {
        self.map(|coefficient| -coefficient)
    }
}

/// The largest number of terms whose products stand where they are used. Longer series share one product of each
/// length.
const SHORT: usize = 8;

/// Cauchy's product.
#[inline(always)]
fn product(a: &[f64], b: &[f64], product: &mut [f64]) {
    for (k, term) in product.iter_mut().enumerate() {
        *term = a[..=k]
            .iter()
            .zip(b[..=k].iter().rev())
            .fold(0.0, |sum, (a, b)| sum + a * b);
    }
}

/// The same, where each factor of the first series adds to all terms at once: the same sums in the same order.
#[inline(never)]
fn long_product<const N: usize>(a: &[f64; N], b: &[f64; N]) -> [f64; N] {
    let mut result = [0.0; N];
    for (j, factor) in a.iter().enumerate() {
        for (term, b) in result[j..].iter_mut().zip(b) {
            *term += factor * b;
        }
    }
    result
}

#[inline(always)]
fn quotient(a: &[f64], b: &[f64], quotient: &mut [f64]) {
    for k in 0..quotient.len() {
        let (before, rest) = quotient.split_at_mut(k);
        let sum = before
            .iter()
            .zip(b[1..=k].iter().rev())
            .fold(a[k], |sum, (q, b)| sum - q * b);
        rest[0] = sum / b[0];
    }
}

/// The same, where each term takes its part of all later ones at once.
#[inline(never)]
fn long_quotient<const N: usize>(a: &[f64; N], b: &[f64; N]) -> [f64; N] {
    let mut result = *a;
    for k in 0..N {
        let term = result[k] / b[0];
        result[k] = term;
        for (rest, b) in result[k + 1..].iter_mut().zip(&b[1..]) {
            *rest -= term * b;
        }
    }
    result
}

impl<const N: usize> Mul for Series<N> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if N > SHORT {
            return Self::from_coefficients(long_product(&self.coefficients, &other.coefficients));
        }
        let mut result = [0.0; N];
        product(&self.coefficients, &other.coefficients, &mut result);
        Self::from_coefficients(result)
    }
}

impl<const N: usize> Div for Series<N> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        if N > SHORT {
            return Self::from_coefficients(long_quotient(&self.coefficients, &other.coefficients));
        }
        let mut result = [0.0; N];
        quotient(&self.coefficients, &other.coefficients, &mut result);
        Self::from_coefficients(result)
    }
}

impl<const N: usize> Number for Series<N> {
    const EPSILON: f64 = f64::EPSILON;
    const ORDER: usize = N - 1;

    fn constant(value: f64) -> Self {
        let mut coefficients = [0.0; N];
        coefficients[0] = value;
        Self::from_coefficients(coefficients)
    }

    fn real(self) -> f64 {
        self.coefficients[0]
    }

    fn is_finite(self) -> bool {
        self.coefficients.iter().all(|term| term.is_finite())
    }

    fn sqrt(self) -> Self {
        let a = self.coefficients;
        let mut root = [0.0; N];
        root[0] = Number::sqrt(a[0]);
        for k in 1..N {
            let mut sum = a[k];
            for j in 1..k {
                sum -= root[j] * root[k - j];
            }
            root[k] = sum / (2.0 * root[0]);
        }
        Self::from_coefficients(root)
    }

    fn sin_cos(self) -> (Self, Self) {
        let a = self.coefficients;
        let (mut sine, mut cosine) = ([0.0; N], [0.0; N]);
        (sine[0], cosine[0]) = Number::sin_cos(a[0]);
        for k in 1..N {
            for j in 1..=k {
                let rate = number(j) * a[j] / number(k);
                sine[k] += rate * cosine[k - j];
                cosine[k] -= rate * sine[k - j];
            }
        }
        (Self::from_coefficients(sine), Self::from_coefficients(cosine))
    }

    fn asin(self) -> Self {
        let one = Self::constant(1.0);
        let slope = ((one - self) * (one + self)).sqrt();
        Self::integrate(Number::asin(self.real()), self.differentiate(), slope)
    }

    fn acos(self) -> Self {
        let one = Self::constant(1.0);
        let slope = ((one - self) * (one + self)).sqrt();
        Self::integrate(Number::acos(self.real()), -self.differentiate(), slope)
    }

    fn atan(self) -> Self {
        let slope = Self::constant(1.0) + self * self;
        Self::integrate(Number::atan(self.real()), self.differentiate(), slope)
    }

    fn atan2(self, x: Self) -> Self {
        let y = self;
        Self::integrate(
            Number::atan2(y.real(), x.real()),
            x * y.differentiate() - y * x.differentiate(),
            x * x + y * y,
        )
    }

    fn sinh(self) -> Self {
        self.sinh_cosh().0
    }

    fn cosh(self) -> Self {
        self.sinh_cosh().1
    }

    fn tanh(self) -> Self {
        let a = self.coefficients;
        // The slope, 1 - tanh², gains one coefficient whenever the value does.
        let (mut value, mut slope) = ([0.0; N], [0.0; N]);
        value[0] = Number::tanh(a[0]);
        slope[0] = (1.0 - value[0]) * (1.0 + value[0]);
        for k in 1..N {
            for j in 1..=k {
                value[k] += number(j) * a[j] * slope[k - j] / number(k);
            }
            for j in 0..=k {
                slope[k] -= value[j] * value[k - j];
            }
        }
        Self::from_coefficients(value)
    }

    fn asinh(self) -> Self {
        let slope = (Self::constant(1.0) + self * self).sqrt();
        Self::integrate(Number::asinh(self.real()), self.differentiate(), slope)
    }

    fn acosh(self) -> Self {
        let one = Self::constant(1.0);
        let slope = ((self - one) * (self + one)).sqrt();
        Self::integrate(Number::acosh(self.real()), self.differentiate(), slope)
    }

    fn atanh(self) -> Self {
        let one = Self::constant(1.0);
        let slope = (one - self) * (one + self);
        Self::integrate(Number::atanh(self.real()), self.differentiate(), slope)
    }

    fn exp(self) -> Self {
        let a = self.coefficients;
        let mut power = [0.0; N];
        power[0] = Number::exp(a[0]);
        for k in 1..N {
            let mut sum = 0.0;
            for j in 1..=k {
                sum += number(j) * a[j] * power[k - j];
            }
            power[k] = sum / number(k);
        }
        Self::from_coefficients(power)
    }

    fn ln(self) -> Self {
        Self::integrate(Number::ln(self.real()), self.differentiate(), self)
    }
}

#[cfg(test)]
mod tests {
    use super::Series;
    use crate::number::Number;

    type Fifth = Series<5>;

    fn close(one: Fifth, other: Fifth) {
        let (one, other) = (one.derivatives(), other.derivatives());
        for (order, (one, other)) in one.into_iter().zip(other).enumerate() {
            let tolerance = 1e-12 * (1.0 + other.abs());
            assert!((one - other).abs() <= tolerance, "order {order}: {one} {other}");
        }
    }

    /// The series t + 0.3, and one with more terms.
    fn arguments() -> [Fifth; 2] {
        [
            Series::from_derivatives([0.3, 1.0, 0.0, 0.0, 0.0]),
            Series::from_derivatives([0.4, -0.7, 1.3, 0.2, -2.1]),
        ]
    }

    #[test]
    fn functions_of_time_itself() {
        let t = Fifth::from_derivatives([0.5, 1.0, 0.0, 0.0, 0.0]);
        let one = Fifth::constant(1.0);
        close(one / t, Series::from_derivatives([2.0, -4.0, 16.0, -96.0, 768.0]));
        close(t.ln(), Series::from_derivatives([0.5_f64.ln(), 2.0, -4.0, 16.0, -96.0]));
        close(t.exp(), Series::from_derivatives([0.5_f64.exp(); 5]));
        let (s, c) = 0.5_f64.sin_cos();
        close(t.sin_cos().0, Series::from_derivatives([s, c, -s, -c, s]));
        close(t.sin_cos().1, Series::from_derivatives([c, -s, -c, s, c]));
        let (s, c) = (0.5_f64.sinh(), 0.5_f64.cosh());
        close(t.sinh(), Series::from_derivatives([s, c, s, c, s]));
        close(t.cosh(), Series::from_derivatives([c, s, c, s, c]));
    }

    #[test]
    fn functions_and_their_inverses_cancel() {
        for x in arguments() {
            let one = Fifth::constant(1.0);
            close(x / x, one);
            close((x * x).sqrt(), x);
            close(x.exp().ln(), x);
            let (sine, cosine) = x.sin_cos();
            close(sine * sine + cosine * cosine, one);
            close(sine.asin(), x);
            close(cosine.acos(), x);
            close((sine / cosine).atan(), x);
            let (sinh, cosh) = (x.sinh(), x.cosh());
            close(cosh * cosh - sinh * sinh, one);
            close(sinh + cosh, x.exp());
            close(sinh / cosh, x.tanh());
            close(sinh.asinh(), x);
            close(cosh.acosh(), x);
            close(x.tanh().atanh(), x);
            for quarters in 0..4 {
                let (shift, y, x_axis) = match quarters {
                    0 => (0.0, sine, cosine),
                    1 => (core::f64::consts::FRAC_PI_2, cosine, -sine),
                    2 => (-core::f64::consts::PI, -sine, -cosine),
                    _ => (-core::f64::consts::FRAC_PI_2, -cosine, sine),
                };
                close(y.atan2(x_axis), x + Fifth::constant(shift));
            }
        }
    }

    #[test]
    fn derivatives_go_in_and_come_out() {
        let derivatives = [1.0, 2.0, 3.0, 4.0, 5.0];
        let series = Fifth::from_derivatives(derivatives);
        assert_eq!(series.coefficients()[2], 1.5);
        close(series, Series::from_derivatives(series.derivatives()));
        assert!(Number::is_finite(series));
        assert!(!Number::is_finite(series / Fifth::constant(0.0)));
    }
}
