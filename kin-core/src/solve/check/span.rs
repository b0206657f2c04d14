//! The range declared for an unknown.

use core::f64::consts::TAU;

use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::solve::Scalar;
use crate::solve::check::{Check, Choose, Real, TurnsInto};
use crate::solve::doubt::{is_told_from, size, smaller};

/// The tolerance for solutions outside the range, in units of ε times the size of the numbers.
const TOLERANCE: f64 = 8.0;

/// The failure of a choice that several poses must leave to the solver for one pose.
const IN_DOUBT: Failure = Failure::NotFinite { quantity: "lanes" };

/// A range. It contains its ends, and also values that lie beyond them by no more than rounding.
#[derive(Clone, Copy)]
pub(in crate::solve) struct Span<R> {
    pub(in crate::solve) low: f64,
    pub(in crate::solve) high: f64,
    tolerance: R,
}

/// Whether a value lies in a range that contains its ends.
#[inline(always)]
pub(in crate::solve) fn within<R: Real>(value: R, low: f64, high: f64) -> R::Truth {
    R::both(value.is_at_least(R::of(low)), || value.is_at_most(R::of(high)))
}

#[inline(always)]
fn larger<R: Real>(one: R, other: R) -> R {
    R::choose(other.exceeds(one), || other, || one)
}

impl<R: Real> Span<R> {
    /// The range from `low` to `high`. The tolerance suits values of the size of `value`.
    #[inline(always)]
    pub(in crate::solve) fn new(low: f64, high: f64, value: R, epsilon: f64) -> Self {
        let finite = |end: f64| if end.is_finite() { end.abs() } else { 0.0 };
        let ends = R::of(finite(low).max(finite(high)));
        let own = R::choose(value.is_finite(), || value.magnitude(), || R::of(0.0));
        Self {
            low,
            high,
            tolerance: R::of(TOLERANCE * epsilon) * larger(ends, own),
        }
    }

    fn holds_strictly(self, value: R) -> R::Truth {
        within(value, self.low, self.high)
    }

    fn holds(self, value: R) -> R::Truth {
        let above = value.is_at_least(R::of(self.low) - self.tolerance);
        R::both(above, || value.is_at_most(R::of(self.high) + self.tolerance))
    }

    /// Whether a value is clearly on one side of each end. Several poses need a distance of more than their
    /// [doubt](Scalar::DOUBT).
    fn tells<T: Scalar>(self, value: R) -> R::Truth {
        let size = self.tolerance / R::of(TOLERANCE) / R::of(T::EPSILON);
        R::both(is_told_from::<T, R>(self.low, value, size), || {
            is_told_from::<T, R>(self.high, value, size)
        })
    }

    /// [`tells`](Self::tells) for an angle that whole turns may have brought into the range.
    fn tells_angle<T: Scalar>(self, angle: R) -> R::Truth {
        let size = larger(angle.magnitude(), R::of(TAU));
        let ends = [self.low, self.low + TAU, self.high, self.high - TAU];
        ends.iter().fold(R::certainly(true), |told, end| {
            R::both(told, || is_told_from::<T, R>(*end, angle, size))
        })
    }

    fn distance(self, value: R) -> R {
        let outside = larger(R::of(self.low) - value, value - R::of(self.high));
        larger(outside, R::of(0.0))
    }

    /// The smallest number of turns that brings an angle into the range, or next to it.
    #[inline(always)]
    pub(in crate::solve) fn turns(self, angle: R) -> R {
        let (low, high, zero) = (R::of(self.low), R::of(self.high), R::of(0.0));
        let turns = R::choose(
            angle.is_below(low),
            || ((low - self.tolerance - angle) / R::of(TAU)).raised(),
            || {
                R::choose(
                    angle.exceeds(high),
                    || -((angle - high - self.tolerance) / R::of(TAU)).raised(),
                    || zero,
                )
            },
        );
        // Zero has no sign.
        R::choose(turns.equals(zero), || zero, || turns)
    }

    /// The representative of an angle that lies in the range, or comes closest to it.
    pub(in crate::solve) fn representative(self, angle: R) -> R {
        let inside = angle + R::of(TAU) * self.turns(angle);
        // An angle can miss a range of less than a turn on either side.
        let nearest = || {
            let others = [inside - R::of(TAU), inside + R::of(TAU)];
            others.into_iter().fold(inside, |nearest, other| {
                let is_nearer = self.distance(nearest).exceeds(self.distance(other));
                R::choose(is_nearer, || other, || nearest)
            })
        };
        R::choose(self.holds(inside), || inside, nearest)
    }
}

/// Whether a value lies in its range, up to rounding.
#[derive(Clone, Copy)]
pub(in crate::solve) struct ValueInRange<T> {
    pub(in crate::solve) value: T,
    pub(in crate::solve) low: f64,
    pub(in crate::solve) high: f64,
}

impl<T: Scalar> Check<T, 1, 2> for ValueInRange<T> {
    fn name(&self) -> &'static str {
        "range of a value"
    }

    #[inline(always)]
    fn operands(&self) -> [T; 1] {
        [self.value]
    }

    #[inline(always)]
    fn holds<R: Real>(&self, [value]: [R; 1]) -> [R::Truth; 2] {
        let span = || Span::new(self.low, self.high, value, T::EPSILON);
        let is_inside = || R::either(within(value, self.low, self.high), || span().holds(value));
        [
            R::both(value.is_finite(), is_inside),
            if T::DOUBT == 0.0 {
                R::certainly(true)
            } else {
                span().tells::<T>(value)
            },
        ]
    }

    fn margin(&self) -> T {
        inside(self.value, self.low, self.high)
    }
}

/// Whether an angle lies in its range after whole turns, up to rounding.
#[derive(Clone, Copy)]
pub(in crate::solve) struct AngleInRange<T> {
    pub(in crate::solve) angle: T,
    pub(in crate::solve) low: f64,
    pub(in crate::solve) high: f64,
}

impl<T: Scalar> Check<T, 1, 2> for AngleInRange<T> {
    fn name(&self) -> &'static str {
        "range of an angle"
    }

    #[inline(always)]
    fn operands(&self) -> [T; 1] {
        [self.angle]
    }

    #[inline(always)]
    fn holds<R: Real>(&self, [angle]: [R; 1]) -> [R::Truth; 2] {
        let span = || Span::new(self.low, self.high, angle, T::EPSILON);
        let is_inside = || {
            R::either(within(angle, self.low, self.high), || {
                let span = span();
                span.holds(span.representative(angle))
            })
        };
        [
            R::both(angle.is_finite(), is_inside),
            if T::DOUBT == 0.0 {
                R::certainly(true)
            } else {
                let span = span();
                span.tells_angle::<T>(span.representative(angle))
            },
        ]
    }

    fn margin(&self) -> T {
        inside(self.angle + self.turns(), self.low, self.high)
    }
}

impl<T: Scalar> AngleInRange<T> {
    /// The turns that bring the angle into the range, in radians.
    #[inline(always)]
    pub(in crate::solve) fn turns(&self) -> T {
        T::measured(TurnsInto {
            angle: self.angle,
            low: self.low,
            high: self.high,
        })
    }
}

/// The distance of a value from the nearer end of its range, positive inside the range.
fn inside<T: Scalar>(value: T, low: f64, high: f64) -> T {
    smaller(value - T::constant(low), T::constant(high) - value)
}

/// Which of two solutions lies in a range.
#[derive(Clone, Copy)]
pub(in crate::solve) struct SolutionInRange<T> {
    pub(in crate::solve) unknown: &'static str,
    pub(in crate::solve) solutions: [T; 2],
    pub(in crate::solve) low: f64,
    pub(in crate::solve) high: f64,
    /// Whether the solutions are angles, which whole turns do not change.
    pub(in crate::solve) is_angle: bool,
}

impl<T: Scalar> Choose<T, 2> for SolutionInRange<T> {
    fn name(&self) -> &'static str {
        self.unknown
    }

    #[inline(always)]
    fn operands(&self) -> [T; 2] {
        self.solutions
    }

    #[inline(always)]
    fn choose(&self, [first, second]: [f64; 2]) -> Result<Assembly, Failure> {
        let (low, high) = (self.low, self.high);
        let span = Span::new(low, high, first.abs().max(second.abs()), T::EPSILON);
        if self.is_angle {
            let (first, second) = (span.representative(first), span.representative(second));
            if !(span.tells_angle::<T>(first) && span.tells_angle::<T>(second)) {
                return Err(IN_DOUBT);
            }
            return choose(self.unknown, first, second, span, self.is_angle);
        }
        if !(span.tells::<T>(first) && span.tells::<T>(second)) {
            return Err(IN_DOUBT);
        }
        match (first >= low && first <= high, second >= low && second <= high) {
            (true, false) if second.is_finite() => Ok(Assembly::Open),
            (false, true) if first.is_finite() => Ok(Assembly::Crossed),
            _ => choose(self.unknown, first, second, span, self.is_angle),
        }
    }

    /// The smaller of the distances to the two ends.
    fn margin(&self) -> T {
        let [first, second] = self.solutions.map(|solution| {
            let (low, high) = (self.low, self.high);
            let angle = AngleInRange {
                angle: solution,
                low,
                high,
            };
            let turns = if self.is_angle { angle.turns() } else { T::constant(0.0) };
            size(inside(solution + turns, low, high))
        });
        smaller(first, second)
    }
}

fn choose(
    unknown: &'static str,
    first: f64,
    second: f64,
    span: Span<f64>,
    is_angle: bool,
) -> Result<Assembly, Failure> {
    if !(first.is_finite() && second.is_finite()) {
        return Err(Failure::NotFinite { quantity: unknown });
    }
    if (first - second).abs() <= span.tolerance && span.holds(first) && span.holds(second) {
        return Ok(Assembly::Open);
    }
    // Rounding counts only if there would be no solution otherwise.
    for inside in [Span::<f64>::holds_strictly, Span::<f64>::holds] {
        match (inside(span, first), inside(span, second)) {
            (true, false) => return Ok(Assembly::Open),
            (false, true) => return Ok(Assembly::Crossed),
            (true, true) => {
                return Err(Failure::Ambiguous {
                    unknown,
                    first,
                    second,
                    is_angle,
                });
            }
            (false, false) => {}
        }
    }
    let value = if span.distance(second) < span.distance(first) {
        second
    } else {
        first
    };
    Err(out_of_range(unknown, value, span.low, span.high, is_angle))
}

#[cold]
pub(in crate::solve) fn out_of_range(
    unknown: &'static str,
    value: f64,
    low: f64,
    high: f64,
    is_angle: bool,
) -> Failure {
    Failure::OutOfRange {
        unknown,
        value,
        low,
        high,
        is_angle,
    }
}
