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
pub type Series<const N: usize> = SeriesOf<f64, N>;

/// A [`Series`] whose coefficients are numbers of any type.
#[derive(Clone, Copy, Debug)]
pub struct SeriesOf<T, const N: usize> {
    coefficients: [T; N],
}

impl<const N: usize> Series<N> {
    /// Zero.
    pub const ZERO: Self = Self { coefficients: [0.0; N] };
}

impl<T: Number, const N: usize> SeriesOf<T, N> {
    /// The series with the given coefficients, in ascending powers of time.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub const fn from_coefficients(coefficients: [T; N]) -> Self {
        const { assert!(N > 0, "a series has a constant term at least") };
        Self { coefficients }
    }

    /// The coefficients in ascending powers of time.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub const fn coefficients(&self) -> [T; N] {
        self.coefficients
    }

    /// The series of a function, from its value and its derivatives.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn from_derivatives(mut derivatives: [T; N]) -> Self {
        let mut factorial = 1.0;
        for (order, entry) in derivatives.iter_mut().enumerate().skip(1) {
            factorial *= number(order);
            *entry = *entry / T::constant(factorial);
        }
        Self::from_coefficients(derivatives)
    }

    /// The value and the derivatives at time zero.
    #[must_use]
    pub fn derivatives(self) -> [T; N] {
        let mut derivatives = self.coefficients;
        let mut factorial = 1.0;
        for (order, entry) in derivatives.iter_mut().enumerate().skip(1) {
            factorial *= number(order);
            *entry = *entry * T::constant(factorial);
        }
        derivatives
    }

    /// The series f with the given constant term and f' = derivative / denominator. Every function with an algebraic
    /// derivative follows this rule.
    fn integrate(constant: T, derivative: Self, denominator: Self) -> Self {
        let d = denominator.coefficients;
        let mut f = [T::constant(0.0); N];
        f[0] = constant;
        for k in 1..N {
            let mut sum = derivative.coefficients[k - 1];
            for j in 1..k {
                sum = sum - T::constant(number(j)) * f[j] * d[k - j];
            }
            f[k] = sum / (T::constant(number(k)) * d[0]);
        }
        Self::from_coefficients(f)
    }

    /// The hyperbolic sine and cosine: the derivative of each is the other.
    fn sinh_cosh(self) -> (Self, Self) {
        let a = self.coefficients;
        let (mut sine, mut cosine) = ([T::constant(0.0); N], [T::constant(0.0); N]);
        (sine[0], cosine[0]) = (a[0].sinh(), a[0].cosh());
        for k in 1..N {
            for j in 1..=k {
                let rate = T::constant(number(j)) * a[j] / T::constant(number(k));
                sine[k] = sine[k] + rate * cosine[k - j];
                cosine[k] = cosine[k] + rate * sine[k - j];
            }
        }
        (Self::from_coefficients(sine), Self::from_coefficients(cosine))
    }

    /// The derivative with respect to time. Its last coefficient is unknown and is set to zero.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn differentiate(self) -> Self {
        let mut slope = [T::constant(0.0); N];
        for k in 1..N {
            slope[k - 1] = T::constant(number(k)) * self.coefficients[k];
        }
        Self::from_coefficients(slope)
    }

    /// The series of another number of terms, of which further ones are zero.
    #[cfg(feature = "alloc")]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn resized<const M: usize>(&self) -> SeriesOf<T, M> {
        let mut resized = [T::constant(0.0); M];
        for (own, term) in resized.iter_mut().zip(&self.coefficients) {
            *own = *term;
        }
        SeriesOf::from_coefficients(resized)
    }

    /// The product of each term with a number.
    #[cfg(feature = "alloc")]
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn scaled(mut self, factor: T) -> Self {
        for term in &mut self.coefficients {
            *term = *term * factor;
        }
        self
    }
}

#[expect(clippy::cast_precision_loss, reason = "the number of terms of a series is small")]
const fn number(index: usize) -> f64 {
    index as f64
}

impl<T: Number, const N: usize> Add for SeriesOf<T, N> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn add(self, other: Self) -> Self {
        let mut sum = self.coefficients;
        for (term, addend) in sum.iter_mut().zip(&other.coefficients) {
            *term = *term + *addend;
        }
        Self::from_coefficients(sum)
    }
}

impl<T: Number, const N: usize> Sub for SeriesOf<T, N> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sub(self, other: Self) -> Self {
        let mut difference = self.coefficients;
        for (term, subtrahend) in difference.iter_mut().zip(&other.coefficients) {
            *term = *term - *subtrahend;
        }
        Self::from_coefficients(difference)
    }
}

impl<T: Number, const N: usize> Neg for SeriesOf<T, N> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn neg(mut self) -> Self {
        for term in &mut self.coefficients {
            *term = -*term;
        }
        self
    }
}

impl<T: Number, const N: usize> SeriesOf<T, N> {
    /// Whether products stand where they are used. Longer series, and those whose terms are more than a number, share
    /// one product of each length.
    const IS_SHORT: bool = N <= 8 && size_of::<T>() <= size_of::<f64>();
}

/// Cauchy's product.
#[inline(always)]
fn product<T: Number>(a: &[T], b: &[T], product: &mut [T]) {
    for (k, term) in product.iter_mut().enumerate() {
        for (a, b) in a[..=k].iter().zip(b[..=k].iter().rev()) {
            *term = *term + *a * *b;
        }
    }
}

/// The same, where each factor of the first series adds to all terms at once: the same sums in the same order.
#[inline(never)]
fn long_product<T: Number, const N: usize>(a: &[T; N], b: &[T; N]) -> [T; N] {
    let mut result = [T::constant(0.0); N];
    for (j, factor) in a.iter().enumerate() {
        for (term, b) in result[j..].iter_mut().zip(b) {
            *term = *term + *factor * *b;
        }
    }
    result
}

#[inline(always)]
fn quotient<T: Number>(a: &[T], b: &[T], quotient: &mut [T]) {
    for k in 0..quotient.len() {
        let (before, rest) = quotient.split_at_mut(k);
        let mut sum = a[k];
        for (q, b) in before.iter().zip(b[1..=k].iter().rev()) {
            sum = sum - *q * *b;
        }
        rest[0] = sum / b[0];
    }
}

/// The same, where each term takes its part of all later ones at once.
#[inline(never)]
fn long_quotient<T: Number, const N: usize>(a: &[T; N], b: &[T; N]) -> [T; N] {
    let mut result = *a;
    for k in 0..N {
        let term = result[k] / b[0];
        result[k] = term;
        for (rest, b) in result[k + 1..].iter_mut().zip(&b[1..]) {
            *rest = *rest - term * *b;
        }
    }
    result
}

impl<T: Number, const N: usize> Mul for SeriesOf<T, N> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn mul(self, other: Self) -> Self {
        if !Self::IS_SHORT {
            return Self::from_coefficients(long_product(&self.coefficients, &other.coefficients));
        }
        let mut result = [T::constant(0.0); N];
        product(&self.coefficients, &other.coefficients, &mut result);
        Self::from_coefficients(result)
    }
}

impl<T: Number, const N: usize> Div for SeriesOf<T, N> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn div(self, other: Self) -> Self {
        if !Self::IS_SHORT {
            return Self::from_coefficients(long_quotient(&self.coefficients, &other.coefficients));
        }
        let mut result = [T::constant(0.0); N];
        quotient(&self.coefficients, &other.coefficients, &mut result);
        Self::from_coefficients(result)
    }
}

impl<T: Number, const N: usize> Number for SeriesOf<T, N> {
    const EPSILON: f64 = T::EPSILON;
    const SMALLEST_DIVISOR: f64 = T::SMALLEST_DIVISOR;
    const ORDER: usize = N - 1;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn constant(value: f64) -> Self {
        let mut coefficients = [T::constant(0.0); N];
        coefficients[0] = T::constant(value);
        Self::from_coefficients(coefficients)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn real(self) -> f64 {
        self.coefficients[0].real()
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_finite(self) -> bool {
        self.coefficients.iter().all(|term| term.is_finite())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sqrt(self) -> Self {
        let a = self.coefficients;
        let mut root = [T::constant(0.0); N];
        root[0] = a[0].sqrt();
        for k in 1..N {
            let mut sum = a[k];
            for j in 1..k {
                sum = sum - root[j] * root[k - j];
            }
            root[k] = sum / (T::constant(2.0) * root[0]);
        }
        Self::from_coefficients(root)
    }

    fn sin_cos(self) -> (Self, Self) {
        let a = self.coefficients;
        let (mut sine, mut cosine) = ([T::constant(0.0); N], [T::constant(0.0); N]);
        (sine[0], cosine[0]) = a[0].sin_cos();
        for k in 1..N {
            for j in 1..=k {
                let rate = T::constant(number(j)) * a[j] / T::constant(number(k));
                sine[k] = sine[k] + rate * cosine[k - j];
                cosine[k] = cosine[k] - rate * sine[k - j];
            }
        }
        (Self::from_coefficients(sine), Self::from_coefficients(cosine))
    }

    fn asin(self) -> Self {
        let one = Self::constant(1.0);
        let slope = ((one - self) * (one + self)).sqrt();
        Self::integrate(self.coefficients[0].asin(), self.differentiate(), slope)
    }

    fn acos(self) -> Self {
        let one = Self::constant(1.0);
        let slope = ((one - self) * (one + self)).sqrt();
        Self::integrate(self.coefficients[0].acos(), -self.differentiate(), slope)
    }

    fn atan(self) -> Self {
        let slope = Self::constant(1.0) + self * self;
        Self::integrate(self.coefficients[0].atan(), self.differentiate(), slope)
    }

    fn atan2(self, x: Self) -> Self {
        let y = self;
        Self::integrate(
            y.coefficients[0].atan2(x.coefficients[0]),
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
        let (mut value, mut slope) = ([T::constant(0.0); N], [T::constant(0.0); N]);
        let one = T::constant(1.0);
        value[0] = a[0].tanh();
        slope[0] = (one - value[0]) * (one + value[0]);
        for k in 1..N {
            for j in 1..=k {
                value[k] = value[k] + T::constant(number(j)) * a[j] * slope[k - j] / T::constant(number(k));
            }
            for j in 0..=k {
                slope[k] = slope[k] - value[j] * value[k - j];
            }
        }
        Self::from_coefficients(value)
    }

    fn asinh(self) -> Self {
        let slope = (Self::constant(1.0) + self * self).sqrt();
        Self::integrate(self.coefficients[0].asinh(), self.differentiate(), slope)
    }

    fn acosh(self) -> Self {
        let one = Self::constant(1.0);
        let slope = ((self - one) * (self + one)).sqrt();
        Self::integrate(self.coefficients[0].acosh(), self.differentiate(), slope)
    }

    fn atanh(self) -> Self {
        let one = Self::constant(1.0);
        let slope = (one - self) * (one + self);
        Self::integrate(self.coefficients[0].atanh(), self.differentiate(), slope)
    }

    fn exp(self) -> Self {
        let a = self.coefficients;
        let mut power = [T::constant(0.0); N];
        power[0] = a[0].exp();
        for k in 1..N {
            let mut sum = T::constant(0.0);
            for j in 1..=k {
                sum = sum + T::constant(number(j)) * a[j] * power[k - j];
            }
            power[k] = sum / T::constant(number(k));
        }
        Self::from_coefficients(power)
    }

    fn ln(self) -> Self {
        Self::integrate(self.coefficients[0].ln(), self.differentiate(), self)
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
