//! Numbers that carry a change.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::number::Number;

/// A number and its change with one quantity: the first derivative with respect to this quantity.
///
/// The number itself may be of any type, so that a series can change as well. Comparisons, `==` among them, compare the
/// numbers and leave the changes aside.
#[derive(Clone, Copy, Debug)]
pub struct Changing<S> {
    /// The number.
    pub value: S,
    /// Its derivative.
    pub change: S,
}

impl<S: Number> Changing<S> {
    /// A number with its derivative.
    #[must_use]
    pub const fn new(value: S, change: S) -> Self {
        Self { value, change }
    }

    /// A function's value, with the change of the argument times the slope of the function.
    fn sloped(self, value: S, slope: S) -> Self {
        Self::new(value, self.change * slope)
    }
}

impl<S: Number> Add for Changing<S> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::new(self.value + other.value, self.change + other.change)
    }
}

impl<S: Number> Sub for Changing<S> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self::new(self.value - other.value, self.change - other.change)
    }
}

impl<S: Number> Mul for Changing<S> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let change = self.change * other.value + self.value * other.change;
        Self::new(self.value * other.value, change)
    }
}

impl<S: Number> Div for Changing<S> {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        Self::new(quotient, (self.change - quotient * other.change) / other.value)
    }
}

impl<S: Number> Neg for Changing<S> {
    type Output = Self;

    fn neg(self) -> Self {
        Self::new(-self.value, -self.change)
    }
}

impl<S: Number> Number for Changing<S> {
    const EPSILON: f64 = S::EPSILON;
    const SMALLEST_DIVISOR: f64 = S::SMALLEST_DIVISOR;
    const ORDER: usize = S::ORDER + 1;

    fn constant(value: f64) -> Self {
        Self::new(S::constant(value), S::constant(0.0))
    }

    fn real(self) -> f64 {
        self.value.real()
    }

    fn is_finite(self) -> bool {
        self.value.is_finite() && self.change.is_finite()
    }

    fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.sloped(root, S::constant(0.5) / root)
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value.sin_cos();
        (self.sloped(sine, cosine), self.sloped(cosine, -sine))
    }

    fn asin(self) -> Self {
        let one = S::constant(1.0);
        self.sloped(self.value.asin(), one / (one - self.value * self.value).sqrt())
    }

    fn acos(self) -> Self {
        let one = S::constant(1.0);
        self.sloped(self.value.acos(), -(one / (one - self.value * self.value).sqrt()))
    }

    fn atan(self) -> Self {
        let one = S::constant(1.0);
        self.sloped(self.value.atan(), one / (one + self.value * self.value))
    }

    fn atan2(self, x: Self) -> Self {
        let square = x.value * x.value + self.value * self.value;
        let change = (x.value * self.change - self.value * x.change) / square;
        Self::new(self.value.atan2(x.value), change)
    }

    fn sinh(self) -> Self {
        self.sloped(self.value.sinh(), self.value.cosh())
    }

    fn cosh(self) -> Self {
        self.sloped(self.value.cosh(), self.value.sinh())
    }

    fn tanh(self) -> Self {
        let tangent = self.value.tanh();
        self.sloped(tangent, S::constant(1.0) - tangent * tangent)
    }

    fn asinh(self) -> Self {
        let one = S::constant(1.0);
        self.sloped(self.value.asinh(), one / (self.value * self.value + one).sqrt())
    }

    fn acosh(self) -> Self {
        let one = S::constant(1.0);
        self.sloped(self.value.acosh(), one / (self.value * self.value - one).sqrt())
    }

    fn atanh(self) -> Self {
        let one = S::constant(1.0);
        self.sloped(self.value.atanh(), one / (one - self.value * self.value))
    }

    fn exp(self) -> Self {
        let power = self.value.exp();
        self.sloped(power, power)
    }

    fn ln(self) -> Self {
        self.sloped(self.value.ln(), S::constant(1.0) / self.value)
    }
}

#[cfg(test)]
mod tests {
    use super::Changing;
    use crate::number::Number;
    use crate::number::series::Series;

    /// The change is the coefficient that a truncated series carries, for every function.
    #[test]
    fn changes_are_first_derivatives() {
        type Function<T> = fn(T) -> T;
        macro_rules! functions {
            ($($function:expr),* $(,)?) => {
                [$(($function as Function<Changing<f64>>, $function as Function<Series<2>>)),*]
            };
        }
        let functions = functions![
            |x| x.sqrt(),
            |x| x.sin_cos().0,
            |x| x.sin_cos().1,
            |x| x.asin(),
            |x| x.acos(),
            |x| x.atan(),
            |x| x.atan2(x * x - 2.0),
            |x| x.sinh(),
            |x| x.cosh(),
            |x| x.tanh(),
            |x| x.asinh(),
            |x| (x + 2.0).acosh(),
            |x| x.atanh(),
            |x| x.exp(),
            |x| x.ln(),
            |x| x.powi(-3) / (x - x * x) - x,
        ];
        for (index, (changing, series)) in functions.into_iter().enumerate() {
            let found = changing(Changing::new(0.4, 1.5));
            let [value, change] = series(Series::from_coefficients([0.4, 1.5])).coefficients();
            assert!(
                (found.value - value).abs() <= 4.0 * f64::EPSILON * value.abs(),
                "{index}"
            );
            assert!(
                (found.change - change).abs() <= 16.0 * f64::EPSILON * change.abs(),
                "{index}"
            );
        }
    }
}
