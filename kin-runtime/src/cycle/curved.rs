//! Bounds with second derivatives, for intervals about which those with first derivatives decide nothing.
//!
//! A short link about which a long crank rotates moves little, since the parts of its closure that move much cancel.
//! Bounds of the first derivative see that they do only over intervals that are shorter by the ratio of the links;
//! those of the second, by its root.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::assembly::Assembly;
use crate::bounds::{Bounds, HUGE, UNDECIDED, Verdict, product, reciprocal, verdict, widened};
use crate::failure::Failure;
use crate::number::Number;
use crate::quantity::Name;
use crate::solve::{Check, Choose, Equations, NewtonMemory, Real, Scalar, Validity};

/// All values of a function of one variable t in -1 ..= 1, with its derivative at t = 0 and bounds of its second
/// derivative.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Curved {
    pub(super) bounds: Bounds,
    /// The derivative at t = 0, with its largest error.
    slope: f64,
    error: f64,
    bends: [f64; 2],
}

/// The sum of two intervals.
fn sum(one: [f64; 2], other: [f64; 2]) -> [f64; 2] {
    widened([one[0] + other[0], one[1] + other[1]])
}

/// The largest magnitude in an interval.
fn largest([low, high]: [f64; 2]) -> f64 {
    low.abs().max(high.abs())
}

/// A derivative of a function: its value in the middle and its bounds.
struct Derivative {
    middle: f64,
    bounds: [f64; 2],
}

impl Curved {
    /// A number that is known to one unit in its last place.
    pub(super) fn rounded(value: f64) -> Self {
        Self::steady(Bounds::rounded(value))
    }

    /// The variable itself: all values from `low` to `high`.
    pub(super) fn variable(low: f64, high: f64) -> Self {
        let slope = 0.5 * (high - low);
        Self {
            bounds: Bounds::variable(low, high),
            slope,
            error: f64::EPSILON * slope,
            bends: [0.0; 2],
        }
    }

    /// A number that does not move.
    fn steady(bounds: Bounds) -> Self {
        Self {
            bounds,
            slope: 0.0,
            error: 0.0,
            bends: [0.0; 2],
        }
    }

    /// A number whose second derivative is not known.
    fn flat(bounds: Bounds) -> Self {
        Self {
            bounds,
            slope: 0.0,
            error: HUGE,
            bends: [-HUGE, HUGE],
        }
    }

    /// The first derivative within the bounds that the second gives, and the values within those of the first.
    fn tight(mut self) -> Self {
        let reach = (largest(self.bends) + self.error) * (1.0 + 4.0 * f64::EPSILON) + f64::EPSILON * self.slope.abs();
        if reach < HUGE {
            self.bounds = self.bounds.with_slopes([self.slope - reach, self.slope + reach]);
        }
        self
    }

    /// A function of this number, with its first derivative and the bounds of its second.
    fn through(self, bounds: Bounds, first: &Derivative, second: [f64; 2]) -> Self {
        if largest(second) >= HUGE || largest(first.bounds) >= HUGE {
            return Self::flat(bounds);
        }
        let slopes = self.bounds.slopes();
        let wrong = largest(second) * self.bounds.error() + 16.0 * f64::EPSILON * first.middle.abs();
        let slope = first.middle * self.slope;
        Self {
            bounds,
            slope,
            error: (first.middle.abs() * self.error + wrong * (self.slope.abs() + self.error))
                * (1.0 + 8.0 * f64::EPSILON)
                + f64::EPSILON * slope.abs(),
            bends: sum(
                product(second, product(slopes, slopes)),
                product(first.bounds, self.bends),
            ),
        }
        .tight()
    }

    fn inverse(self) -> Self {
        let values = reciprocal(self.bounds.values());
        let square = product(values, values);
        let middle = 1.0 / self.bounds.middle();
        let first = Derivative {
            middle: -middle * middle,
            bounds: [-square[1], -square[0]],
        };
        let second = product([2.0; 2], product(square, values));
        self.through(Bounds::constant(1.0) / self.bounds, &first, second)
    }
}

impl Add for Curved {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let slope = self.slope + other.slope;
        Self {
            bounds: self.bounds + other.bounds,
            slope,
            error: self.error + other.error + f64::EPSILON * slope.abs(),
            bends: sum(self.bends, other.bends),
        }
        .tight()
    }
}

impl Neg for Curved {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            bounds: -self.bounds,
            slope: -self.slope,
            error: self.error,
            bends: [-self.bends[1], -self.bends[0]],
        }
    }
}

impl Sub for Curved {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Curved {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let (one, two) = (self.bounds, other.bounds);
        let terms = [one.middle() * other.slope, two.middle() * self.slope];
        let wrong = |bounds: Bounds, other: &Self| {
            bounds.middle().abs() * other.error + bounds.error() * (other.slope.abs() + other.error)
        };
        let error = wrong(one, &other) + wrong(two, &self);
        let both = product([2.0; 2], product(one.slopes(), two.slopes()));
        Self {
            bounds: one * two,
            slope: terms[0] + terms[1],
            error: error * (1.0 + 8.0 * f64::EPSILON) + 2.0 * f64::EPSILON * (terms[0].abs() + terms[1].abs()),
            bends: sum(
                both,
                sum(product(one.values(), other.bends), product(two.values(), self.bends)),
            ),
        }
        .tight()
    }
}

impl Div for Curved {
    type Output = Self;

    #[expect(
        clippy::suspicious_arithmetic_impl,
        reason = "a quotient is a product with the reciprocal"
    )]
    fn div(self, other: Self) -> Self {
        self * other.inverse()
    }
}

impl Number for Curved {
    const EPSILON: f64 = f64::EPSILON;

    fn constant(value: f64) -> Self {
        Self::steady(Bounds::constant(value))
    }

    fn real(self) -> f64 {
        self.bounds.real()
    }

    fn is_finite(self) -> bool {
        self.bounds.is_finite()
    }

    fn sqrt(self) -> Self {
        let root = self.bounds.sqrt();
        let inverse = reciprocal(root.values());
        let cube = product(inverse, product(inverse, inverse));
        let first = Derivative {
            middle: 0.5 / root.middle(),
            bounds: product([0.5; 2], inverse),
        };
        let second = product([-0.25; 2], cube);
        if self.bounds.values()[0] > 0.0 {
            self.through(root, &first, second)
        } else {
            Self::flat(root)
        }
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.bounds.sin_cos();
        let derivative = |bounds: Bounds| Derivative {
            middle: bounds.middle(),
            bounds: bounds.values(),
        };
        let negative = |bounds: Bounds| (-bounds).values();
        (
            self.through(sine, &derivative(cosine), negative(sine)),
            self.through(cosine, &derivative(-sine), negative(cosine)),
        )
    }

    fn asin(self) -> Self {
        Self::flat(self.bounds.asin())
    }

    fn acos(self) -> Self {
        Self::flat(self.bounds.acos())
    }

    fn atan(self) -> Self {
        Self::flat(self.bounds.atan())
    }

    /// The derivative is (x y' - y x') / r², with the derivative (x y'' - y x'') / r² - 2 (x y' - y x') (x x' + y y') /
    /// r⁴.
    fn atan2(self, x: Self) -> Self {
        let (y, angle) = (self, self.bounds.atan2(x.bounds));
        let square = y.bounds * y.bounds + x.bounds * x.bounds;
        let inverse = reciprocal(square.values());
        if largest(inverse) >= HUGE || y.error.max(x.error) >= HUGE {
            return Self::flat(angle);
        }
        let (one, two) = (x.bounds, y.bounds);
        let negative = |[low, high]: [f64; 2]| [-high, -low];
        let across = |ys: [f64; 2], xs: [f64; 2]| sum(product(one.values(), ys), negative(product(two.values(), xs)));
        let along = sum(product(one.values(), one.slopes()), product(two.values(), two.slopes()));
        let rotation = product(
            across(two.slopes(), one.slopes()),
            product(along, product(inverse, inverse)),
        );
        let bends = sum(product(across(y.bends, x.bends), inverse), product([-2.0; 2], rotation));
        let terms = [one.middle() * y.slope, two.middle() * x.slope];
        let wrong = one.middle().abs() * y.error
            + one.error() * (y.slope.abs() + y.error)
            + two.middle().abs() * x.error
            + two.error() * (x.slope.abs() + x.error)
            + 4.0 * f64::EPSILON * (terms[0].abs() + terms[1].abs());
        let part = 1.0 / square.middle();
        let slope = (terms[0] - terms[1]) * part;
        let square_error = square.error() * largest(inverse) + 8.0 * f64::EPSILON;
        Self {
            bounds: angle,
            slope,
            error: (wrong * largest(inverse) + slope.abs() * square_error) * (1.0 + 16.0 * f64::EPSILON),
            bends,
        }
        .tight()
    }

    fn sinh(self) -> Self {
        Self::flat(self.bounds.sinh())
    }

    fn cosh(self) -> Self {
        Self::flat(self.bounds.cosh())
    }

    fn tanh(self) -> Self {
        Self::flat(self.bounds.tanh())
    }

    fn asinh(self) -> Self {
        Self::flat(self.bounds.asinh())
    }

    fn acosh(self) -> Self {
        Self::flat(self.bounds.acosh())
    }

    fn atanh(self) -> Self {
        Self::flat(self.bounds.atanh())
    }

    fn exp(self) -> Self {
        Self::flat(self.bounds.exp())
    }

    fn ln(self) -> Self {
        Self::flat(self.bounds.ln())
    }
}

/// A check or a choice of numbers with second derivatives, which decides by their bounds.
#[derive(Clone, Copy)]
struct ByBounds<C>(C);

impl<C: Check<Curved, N, K>, const N: usize, const K: usize> Check<Bounds, N, K> for ByBounds<C> {
    fn name(&self) -> &'static str {
        self.0.name()
    }

    fn operands(&self) -> [Bounds; N] {
        self.0.operands().map(|operand| operand.bounds)
    }

    fn holds<R: Real>(&self, operands: [R; N]) -> [R::Truth; K] {
        self.0.holds(operands)
    }

    fn margin(&self) -> Bounds {
        self.0.margin().bounds
    }
}

impl<C: Choose<Curved, N>, const N: usize> Choose<Bounds, N> for ByBounds<C> {
    fn name(&self) -> Name {
        self.0.name()
    }

    fn operands(&self) -> [Bounds; N] {
        self.0.operands().map(|operand| operand.bounds)
    }

    fn validity<R: Real>(&self, operands: [R; N]) -> Validity<R> {
        self.0.validity(operands)
    }

    fn choose(&self, operands: [f64; N]) -> Result<Assembly, Failure> {
        self.0.choose(operands)
    }

    fn margin(&self) -> Bounds {
        self.0.margin().bounds
    }
}

impl Scalar for Curved {
    fn provided<const N: usize, const K: usize>(self, check: impl Check<Self, N, K>) -> Option<Self> {
        let bounds = self.bounds.provided(ByBounds(check))?;
        Some(Self { bounds, ..self })
    }

    fn either<const N: usize>(
        check: impl Check<Self, N, 1>,
        one: impl FnOnce() -> Self,
        other: impl FnOnce() -> Self,
    ) -> Self {
        match verdict(ByBounds(check)) {
            Verdict::Holds => one(),
            Verdict::Fails => other(),
            Verdict::Doubtful(_) => {
                let (one, other) = (one().bounds, other().bounds);
                Self::flat(Bounds::either(ByBounds(check), || one, || other))
            }
        }
    }

    fn chosen<const N: usize>(choice: impl Choose<Self, N>) -> Result<Assembly, Failure> {
        Bounds::chosen(ByBounds(choice))
    }

    fn root(_: &mut [Self], _: &[Self], _: NewtonMemory<'_, Self>, _: impl Equations<Self>) -> Result<(), Failure> {
        Err(Failure::not_finite(UNDECIDED))
    }
}
