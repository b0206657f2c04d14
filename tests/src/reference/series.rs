//! Truncated Taylor series in time, of many digits.

use kin_precise::Number;

/// The coefficients of the powers of time, ascending. Those that are missing are zero: a constant has but one.
#[derive(Clone, Debug)]
pub struct Series(Vec<Number>);

/// A small count as a number.
///
/// # Panics
/// If the count does not fit into 32 bits.
#[must_use]
pub fn number(count: usize) -> Number {
    Number::exactly(f64::from(u32::try_from(count).expect("series are short")))
}

impl Series {
    /// A constant.
    #[must_use]
    pub fn constant(value: Number) -> Self {
        Self(vec![value])
    }

    /// The series of a motion, from value and time derivatives.
    #[must_use]
    pub fn from_derivatives(derivatives: &[f64]) -> Self {
        let mut factorial = number(1);
        let coefficients = derivatives.iter().enumerate().map(|(order, derivative)| {
            factorial = &factorial * &number(order.max(1));
            &Number::exactly(*derivative) / &factorial
        });
        Self(coefficients.collect())
    }

    /// The series of these coefficients, of which there is at least one.
    #[must_use]
    pub fn from_coefficients(coefficients: Vec<Number>) -> Self {
        Self(coefficients)
    }

    /// The coefficient of a power of time.
    #[must_use]
    pub fn coefficient(&self, power: usize) -> Number {
        self.0.get(power).cloned().unwrap_or_else(Number::zero)
    }

    /// With `count` coefficients at most.
    #[must_use]
    pub fn cut(mut self, count: usize) -> Self {
        self.0.truncate(count);
        self
    }

    /// With a number added to one of its coefficients.
    #[must_use]
    pub fn shifted(mut self, power: usize, shift: &Number) -> Self {
        while self.0.len() <= power {
            self.0.push(Number::zero());
        }
        self.0[power] = &self.0[power] + shift;
        self
    }

    fn is_constant(&self) -> bool {
        self.0.len() == 1
    }

    /// The coefficients of a function of the series before, each from those that are already known.
    fn build(count: usize, first: Number, mut next: impl FnMut(usize, &[Number]) -> Number) -> Self {
        let mut coefficients = vec![first];
        for power in 1..count {
            let coefficient = next(power, &coefficients);
            coefficients.push(coefficient);
        }
        Self(coefficients)
    }

    /// The function f of given first coefficient with f' · `divisor` = `rate`.
    fn integral(count: usize, first: Number, rate: &Self, divisor: &Self) -> Self {
        Self::build(count, first, |power, known| {
            // power · f_power · d_0 = r_(power - 1) - sum of j f_j d_(power - j)
            let rest = (1..power).fold(rate.coefficient(power - 1), |rest, j| {
                &rest - &(&(&number(j) * &known[j]) * &divisor.coefficient(power - j))
            });
            &rest / &(&number(power) * &divisor.coefficient(0))
        })
    }

    /// The time derivative.
    fn rate(&self) -> Self {
        if self.is_constant() {
            return Self::constant(Number::zero());
        }
        let rates = self.0.iter().enumerate().skip(1);
        Self(rates.map(|(power, own)| &number(power) * own).collect())
    }

    /// Coefficient by coefficient.
    fn paired(&self, other: &Self, function: impl Fn(&Number, &Number) -> Number) -> Self {
        let count = self.0.len().max(other.0.len());
        let pairs = (0..count).map(|power| function(&self.coefficient(power), &other.coefficient(power)));
        Self(pairs.collect())
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        self.paired(other, |own, other| own + other)
    }

    /// The difference.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        self.paired(other, |own, other| own - other)
    }

    /// The negative.
    #[must_use]
    pub fn negated(&self) -> Self {
        Self(self.0.iter().map(|own| -own).collect())
    }

    /// The product, to so many coefficients.
    #[must_use]
    pub fn times(&self, other: &Self, count: usize) -> Self {
        let last = (self.0.len() + other.0.len() - 1).min(count);
        let coefficients = (0..last).map(|power| {
            let low = (power + 1).saturating_sub(other.0.len());
            let high = power.min(self.0.len() - 1);
            (low..=high).fold(Number::zero(), |sum, j| &sum + &(&self.0[j] * &other.0[power - j]))
        });
        Self(coefficients.collect())
    }

    /// The quotient, to so many coefficients.
    #[must_use]
    pub fn over(&self, other: &Self, count: usize) -> Self {
        if other.is_constant() {
            return Self(self.0.iter().map(|own| own / &other.0[0]).collect());
        }
        let first = &self.0[0] / &other.0[0];
        Self::build(count, first, |power, known| {
            let rest = (0..power).fold(self.coefficient(power), |rest, j| {
                &rest - &(&known[j] * &other.coefficient(power - j))
            });
            &rest / &other.0[0]
        })
    }

    /// The square root.
    #[must_use]
    pub fn sqrt(&self, count: usize) -> Self {
        let first = self.0[0].sqrt();
        if self.is_constant() {
            return Self::constant(first);
        }
        let double = first.doubled(1);
        Self::build(count, first, |power, known| {
            let rest = (1..power).fold(self.coefficient(power), |rest, j| {
                &rest - &(&known[j] * &known[power - j])
            });
            &rest / &double
        })
    }

    /// Sine and cosine.
    #[must_use]
    pub fn sin_cos(&self, count: usize) -> (Self, Self) {
        let (sine, cosine) = self.0[0].sin_cos();
        let (mut sines, mut cosines) = (vec![sine], vec![cosine]);
        if !self.is_constant() {
            let rate = self.rate();
            for power in 1..count {
                // power · s_power = sum of x'_j c_(power - 1 - j), and c likewise with the other sign
                let (mut sine, mut cosine) = (Number::zero(), Number::zero());
                for j in 0..power {
                    let turning = rate.coefficient(j);
                    sine = &sine + &(&turning * &cosines[power - 1 - j]);
                    cosine = &cosine - &(&turning * &sines[power - 1 - j]);
                }
                sines.push(&sine / &number(power));
                cosines.push(&cosine / &number(power));
            }
        }
        (Self(sines), Self(cosines))
    }

    /// The angle of a point with this ordinate and the abscissa `x`.
    #[must_use]
    pub fn atan2(&self, x: &Self, count: usize) -> Self {
        let first = self.0[0].atan2(&x.0[0]);
        if self.is_constant() && x.is_constant() {
            return Self::constant(first);
        }
        let areal = x.times(&self.rate(), count).minus(&self.times(&x.rate(), count));
        let square = x.times(x, count).plus(&self.times(self, count));
        Self::integral(count, first, &areal, &square)
    }

    /// The hyperbolic sine and cosine.
    #[must_use]
    pub fn sinh_cosh(&self, count: usize) -> (Self, Self) {
        let (sine, cosine) = self.0[0].sinh_cosh();
        let (mut sines, mut cosines) = (vec![sine], vec![cosine]);
        if !self.is_constant() {
            let rate = self.rate();
            for power in 1..count {
                // each is the derivative of the other one
                let (mut sine, mut cosine) = (Number::zero(), Number::zero());
                for j in 0..power {
                    let growth = rate.coefficient(j);
                    sine = &sine + &(&growth * &cosines[power - 1 - j]);
                    cosine = &cosine + &(&growth * &sines[power - 1 - j]);
                }
                sines.push(&sine / &number(power));
                cosines.push(&cosine / &number(power));
            }
        }
        (Self(sines), Self(cosines))
    }

    /// The area hyperbolic sine.
    #[must_use]
    pub fn asinh(&self, count: usize) -> Self {
        self.area(count, Number::asinh, |square, one| square.plus(one).sqrt(count))
    }

    /// The area hyperbolic cosine.
    #[must_use]
    pub fn acosh(&self, count: usize) -> Self {
        self.area(count, Number::acosh, |square, one| square.minus(one).sqrt(count))
    }

    /// The area hyperbolic tangent.
    #[must_use]
    pub fn atanh(&self, count: usize) -> Self {
        self.area(count, Number::atanh, |square, one| one.minus(square))
    }

    /// An inverse of a hyperbolic function: its value, and what its rate is divided by.
    fn area(
        &self,
        count: usize,
        value: impl FnOnce(&Number) -> Number,
        divisor: impl FnOnce(&Self, &Self) -> Self,
    ) -> Self {
        let first = value(&self.0[0]);
        if self.is_constant() {
            return Self::constant(first);
        }
        let divisor = divisor(&self.times(self, count), &Self::constant(number(1)));
        Self::integral(count, first, &self.rate(), &divisor)
    }

    /// The exponential function.
    #[must_use]
    pub fn exp(&self, count: usize) -> Self {
        let first = self.0[0].exp();
        if self.is_constant() {
            return Self::constant(first);
        }
        let rate = self.rate();
        Self::build(count, first, |power, known| {
            let sum = (0..power).fold(Number::zero(), |sum, j| {
                &sum + &(&rate.coefficient(j) * &known[power - 1 - j])
            });
            &sum / &number(power)
        })
    }

    /// The natural logarithm.
    #[must_use]
    pub fn ln(&self, count: usize) -> Self {
        let first = self.0[0].ln();
        if self.is_constant() {
            return Self::constant(first);
        }
        Self::integral(count, first, &self.rate(), self)
    }
}
