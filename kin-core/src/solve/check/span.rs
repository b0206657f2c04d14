//! The range declared for an unknown.

use core::f64::consts::TAU;

use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::quantity::Name;
use crate::solve::Scalar;
use crate::solve::check::{Check, Choose, Real, TurnsInto, Validity};
use crate::solve::doubt::{is_told_from, size, smaller};

/// The tolerance for solutions outside the range, in units of ε times the size of the numbers.
const TOLERANCE: f64 = 8.0;

/// The failure of a choice that several poses must leave to the solver for one pose.
const IN_DOUBT: Failure = Failure::NotFinite {
    quantity: Name::new("lanes"),
};

/// A range. It contains its ends, and also values that lie beyond them by no more than rounding.
#[derive(Clone, Copy)]
pub(in crate::solve) struct Span<R> {
    pub(in crate::solve) low: f64,
    pub(in crate::solve) high: f64,
    tolerance: R,
}

/// Whether a value lies in a range that contains its ends.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::solve) fn within<R: Real>(value: R, low: f64, high: f64) -> R::Truth {
    R::both(value.is_at_least(R::of(low)), || value.is_at_most(R::of(high)))
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn larger<R: Real>(one: R, other: R) -> R {
    R::choose(other.exceeds(one), || other, || one)
}

impl<R: Real> Span<R> {
    /// The range from `low` to `high`. The tolerance suits values of the size of `value`.
    #[cfg_attr(not(debug_assertions), inline(always))]
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

    /// The distance of a value from the nearer end, positive inside the range.
    fn inside(self, value: R) -> R {
        let (above, below) = (value - R::of(self.low), R::of(self.high) - value);
        R::choose(below.is_below(above), || below, || above)
    }

    fn distance(self, value: R) -> R {
        let outside = larger(R::of(self.low) - value, value - R::of(self.high));
        larger(outside, R::of(0.0))
    }

    /// The smallest number of turns that brings an angle into the range, or next to it.
    #[cfg_attr(not(debug_assertions), inline(always))]
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

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 1] {
        [self.value]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
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

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 1] {
        [self.angle]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
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

    /// An angle can miss a range of less than a turn on either side. The nearer side counts.
    fn margin(&self) -> T {
        let (angle, turn) = (self.angle + self.turns(), T::constant(TAU));
        let margin = |angle| inside(angle, self.low, self.high);
        let larger = |one: T, other: T| -smaller(-one, -other);
        [angle - turn, angle + turn]
            .map(margin)
            .into_iter()
            .fold(margin(angle), larger)
    }
}

impl<T: Scalar> AngleInRange<T> {
    /// The turns that bring the angle into the range, in radians.
    #[cfg_attr(not(debug_assertions), inline(always))]
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

/// Which of two solutions lies in a range: the criterion of [`choose`](crate::solve::choose()).
#[derive(Clone, Copy, Debug)]
pub struct SolutionInRange<T> {
    unknown: &'static str,
    solutions: [T; 2],
    low: f64,
    high: f64,
    /// Whether the solutions are angles, which whole turns do not change.
    is_angle: bool,
}

impl<T> SolutionInRange<T> {
    /// Two values of an unknown, and its range `low..=high`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub const fn value(unknown: &'static str, solutions: [T; 2], low: f64, high: f64) -> Self {
        Self {
            unknown,
            solutions,
            low,
            high,
            is_angle: false,
        }
    }

    /// Two angles in radians, and their range. An angle lies in it if whole turns can bring it there.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub const fn angle(unknown: &'static str, solutions: [T; 2], low: f64, high: f64) -> Self {
        Self {
            unknown,
            solutions,
            low,
            high,
            is_angle: true,
        }
    }
}

impl<T: Scalar> Choose<T, 2> for SolutionInRange<T> {
    fn name(&self) -> &'static str {
        self.unknown
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 2] {
        self.solutions
    }

    fn validity<R: Real>(&self, [first, second]: [R; 2]) -> Validity<R> {
        let span = Span::new(
            self.low,
            self.high,
            larger(first.magnitude(), second.magnitude()),
            T::EPSILON,
        );
        let of_range = |solution| {
            if self.is_angle {
                span.representative(solution)
            } else {
                solution
            }
        };
        let (first, second) = (of_range(first), of_range(second));
        let strictly = [first, second].map(|solution| span.holds_strictly(solution));
        let loosely = [first, second].map(|solution| span.holds(solution));
        let one = |[one, other]: [R::Truth; 2]| R::either(one, || other);
        let two = |[one, other]: [R::Truth; 2]| R::both(one, || other);
        let are_equal = R::both((first - second).magnitude().is_at_most(span.tolerance), || two(loosely));
        // Rounding counts only if there would be no solution otherwise.
        let by_rounding = || R::both(R::not(one(strictly)), || two(loosely));
        let are_valid = R::either(two(strictly), by_rounding);
        let is_first = R::either(strictly[0], || R::both(R::not(strictly[1]), || loosely[0]));
        let (inside, other) = (span.inside(first), span.inside(second));
        Validity {
            are_finite: R::both(first.is_finite(), || second.is_finite()),
            has_one: one(loosely),
            has_two: R::both(are_valid, || R::not(are_equal)),
            // The end of the range may lie between two angles that are equal up to rounding.
            is_first: if self.is_angle {
                R::either(are_equal, || is_first)
            } else {
                is_first
            },
            margin_of_one: larger(inside, other),
            margin_of_two: larger(-inside, -other),
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
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
        // An infinite solution lies in no range.
        let (least, most) = (low.max(f64::MIN), high.min(f64::MAX));
        match (first >= least && first <= most, second >= least && second <= most) {
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
        return Err(Failure::not_finite(unknown));
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
                    unknown: unknown.into(),
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
        unknown: unknown.into(),
        value,
        low,
        high,
        is_angle,
    }
}
