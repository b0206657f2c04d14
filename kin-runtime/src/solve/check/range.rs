//! The solution that lies in the range declared for an unknown.

use core::f64::consts::TAU;

use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::quantity::Name;
use crate::solve::Scalar;
use crate::solve::check::doubt::{is_distinct_from, size, smaller};
use crate::solve::check::unwrap::plus_revolutions;
use crate::solve::check::{Check, Choose, Measure, Real, Validity};

/// The tolerance for solutions outside the range, in units of ε times the size of the numbers.
const TOLERANCE: f64 = 8.0;

/// The failure of a choice that several poses must leave to the solver for one pose.
const IN_DOUBT: Failure = Failure::NotFinite {
    quantity: Name::new("lanes"),
};

/// The choice between two solutions by the ranges `low..=high` of unknowns: [`Assembly::Open`] for the first solution,
/// [`Assembly::Crossed`] for the second. The first range that does not contain both solutions decides.
///
/// A range without an end has an infinite end. Solutions may lie beyond an end by no more than rounding. Two solutions
/// that coincide count as one, the first. An angle lies in its range if whole revolutions can bring it there.
///
/// # Errors
/// [`Failure::OutOfRange`] with the solution closest to the range that decides if neither lies in it,
/// [`Failure::Ambiguous`] if both lie in all ranges, [`Failure::NotFinite`].
///
/// ```
/// use kin_core::Assembly;
/// use kin_core::solve::{self, SolutionInRange};
///
/// let slider = SolutionInRange::value("s", [-2.0, 2.0], 0.0, f64::INFINITY);
/// assert_eq!(solve::choose([slider]), Ok(Assembly::Crossed));
///
/// let coupler = SolutionInRange::angle("theta3", [0.5, -0.5], -1.0, 1.0);
/// let rocker = SolutionInRange::angle("theta4", [-2.0, 2.0], 0.0, 3.1);
/// assert_eq!(solve::choose([coupler, rocker]), Ok(Assembly::Crossed));
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn choose<T: Scalar, const K: usize>(
    ranges: [SolutionInRange<T, impl Copy + Into<Name>>; K],
) -> Result<Assembly, Failure> {
    const { assert!(K > 0, "a choice has a criterion") };
    T::first_chosen(&ranges)
}

/// [`choose`] by any number of ranges.
///
/// # Errors
/// As for [`choose`]. [`Failure::NotFinite`] without a range.
#[doc(hidden)]
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn choose_in<T: Scalar>(ranges: &[SolutionInRange<T, impl Copy + Into<Name>>]) -> Result<Assembly, Failure> {
    if ranges.is_empty() {
        return Err(Failure::not_finite("range of a choice"));
    }
    T::first_chosen(ranges)
}

/// The value itself, if it lies in `low..=high` up to rounding.
///
/// # Errors
/// [`Failure::OutOfRange`], [`Failure::NotFinite`].
///
/// ```
/// use kin_core::solve;
///
/// assert_eq!(solve::check_value("s", 2.0, 0.0, 3.0), Ok(2.0));
/// assert!(solve::check_value("s", 4.0, 0.0, 3.0).is_err());
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn check_value<T: Scalar>(unknown: impl Into<Name>, value: T, low: f64, high: f64) -> Result<T, Failure> {
    value.provided(ValueInRange { value, low, high }).ok_or_else(|| {
        let real = value.real();
        if real.is_finite() {
            out_of_range(unknown.into(), real, low, high, false)
        } else {
            Failure::not_finite(unknown)
        }
    })
}

/// The angle that lies in `low..=high`, up to rounding, and differs from `value` by as few whole revolutions as
/// possible.
///
/// # Errors
/// [`Failure::OutOfRange`] with the representative closest to the range, [`Failure::NotFinite`].
///
/// ```
/// use core::f64::consts::TAU;
/// use kin_core::solve;
///
/// assert_eq!(solve::check_angle("theta4", -1.0, 0.0, TAU), Ok(TAU - 1.0));
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn check_angle<T: Scalar>(unknown: impl Into<Name>, value: T, low: f64, high: f64) -> Result<T, Failure> {
    let range = |angle: T| AngleInRange { angle, low, high };
    let Some(value) = value.provided(range(value)) else {
        let real = value.real();
        return Err(if real.is_finite() {
            let nearest = Span::new(low, high, real, T::EPSILON).representative(real);
            out_of_range(unknown.into(), nearest, low, high, true)
        } else {
            Failure::not_finite(unknown)
        });
    };
    Ok(plus_revolutions(value, range(value).revolutions()))
}

/// A range. It contains its ends, and also values that lie beyond them by no more than rounding.
#[derive(Clone, Copy)]
struct Span<R> {
    low: f64,
    high: f64,
    tolerance: R,
}

/// Whether a value lies in a range that contains its ends.
#[cfg_attr(not(debug_assertions), inline(always))]
fn within<R: Real>(value: R, low: f64, high: f64) -> R::Truth {
    R::both(value.is_at_least(R::of(low)), || value.is_at_most(R::of(high)))
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn larger<R: Real>(one: R, other: R) -> R {
    R::choose(other.exceeds(one), || other, || one)
}

impl<R: Real> Span<R> {
    /// The range from `low` to `high`. The tolerance suits values of the size of `value`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn new(low: f64, high: f64, value: R, epsilon: f64) -> Self {
        let finite = |end: f64| if end.is_finite() { end.abs() } else { 0.0 };
        let ends = R::of(finite(low).max(finite(high)));
        let size = R::choose(value.is_finite(), || value.magnitude(), || R::of(0.0));
        Self {
            low,
            high,
            tolerance: R::of(TOLERANCE * epsilon) * larger(ends, size),
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
    fn decides<T: Scalar>(self, value: R) -> R::Truth {
        let size = self.tolerance / R::of(TOLERANCE) / R::of(T::EPSILON);
        R::both(is_distinct_from::<T, R>(self.low, value, size), || {
            is_distinct_from::<T, R>(self.high, value, size)
        })
    }

    /// [`decides`](Self::decides) for an angle that whole revolutions may have brought into the range.
    fn decides_angle<T: Scalar>(self, angle: R) -> R::Truth {
        let size = larger(angle.magnitude(), R::of(TAU));
        let ends = [self.low, self.low + TAU, self.high, self.high - TAU];
        ends.iter().fold(R::certainly(true), |decided, end| {
            R::both(decided, || is_distinct_from::<T, R>(*end, angle, size))
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

    /// The smallest number of revolutions that brings an angle into the range, or next to it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn revolutions(self, angle: R) -> R {
        let (low, high, zero) = (R::of(self.low), R::of(self.high), R::of(0.0));
        let revolutions = R::choose(
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
        R::choose(revolutions.equals(zero), || zero, || revolutions)
    }

    /// The representative of an angle that lies in the range, or comes closest to it.
    fn representative(self, angle: R) -> R {
        let inside = angle + R::of(TAU) * self.revolutions(angle);
        // An angle can miss a range of less than a revolution on either side.
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
struct ValueInRange<T> {
    value: T,
    low: f64,
    high: f64,
}

impl<T: Scalar> Check<T, 1, 2> for ValueInRange<T> {
    const IS_LONG: bool = true;

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
                span().decides::<T>(value)
            },
        ]
    }

    fn margin(&self) -> T {
        inside(self.value, self.low, self.high)
    }
}

/// Whether an angle lies in its range after whole revolutions, up to rounding.
#[derive(Clone, Copy)]
struct AngleInRange<T> {
    angle: T,
    low: f64,
    high: f64,
}

impl<T: Scalar> Check<T, 1, 2> for AngleInRange<T> {
    const IS_LONG: bool = true;

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
                span.decides_angle::<T>(span.representative(angle))
            },
        ]
    }

    /// An angle can miss a range of less than a revolution on either side. The nearer side counts.
    fn margin(&self) -> T {
        let (angle, revolution) = (self.angle + self.revolutions(), T::constant(TAU));
        let margin = |angle| inside(angle, self.low, self.high);
        let larger = |one: T, other: T| -smaller(-one, -other);
        [angle - revolution, angle + revolution]
            .map(margin)
            .into_iter()
            .fold(margin(angle), larger)
    }
}

impl<T: Scalar> AngleInRange<T> {
    /// The revolutions that bring the angle into the range, in radians.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn revolutions(&self) -> T {
        T::measured(RevolutionsInto {
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
pub struct SolutionInRange<T, N = &'static str> {
    unknown: N,
    solutions: [T; 2],
    low: f64,
    high: f64,
    /// Whether the solutions are angles, which whole revolutions do not change.
    is_angle: bool,
}

impl<T, N> SolutionInRange<T, N> {
    /// Two values of an unknown, and its range `low..=high`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub const fn value(unknown: N, solutions: [T; 2], low: f64, high: f64) -> Self {
        Self {
            unknown,
            solutions,
            low,
            high,
            is_angle: false,
        }
    }

    /// Two angles in radians, and their range. An angle lies in it if whole revolutions can bring it there.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub const fn angle(unknown: N, solutions: [T; 2], low: f64, high: f64) -> Self {
        Self {
            unknown,
            solutions,
            low,
            high,
            is_angle: true,
        }
    }
}

impl<T: Scalar, N: Copy + Into<Name>> Choose<T, 2> for SolutionInRange<T, N> {
    fn name(&self) -> Name {
        self.unknown.into()
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
            if !(span.decides_angle::<T>(first) && span.decides_angle::<T>(second)) {
                return Err(IN_DOUBT);
            }
            return chosen(self.unknown, first, second, span, self.is_angle);
        }
        if !(span.decides::<T>(first) && span.decides::<T>(second)) {
            return Err(IN_DOUBT);
        }
        // An infinite solution lies in no range.
        let (least, most) = (low.max(f64::MIN), high.min(f64::MAX));
        match (first >= least && first <= most, second >= least && second <= most) {
            (true, false) if second.is_finite() => Ok(Assembly::Open),
            (false, true) if first.is_finite() => Ok(Assembly::Crossed),
            _ => chosen(self.unknown, first, second, span, self.is_angle),
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
            let revolutions = if self.is_angle {
                angle.revolutions()
            } else {
                T::constant(0.0)
            };
            size(inside(solution + revolutions, low, high))
        });
        smaller(first, second)
    }
}

/// Out of line: what is not clear at once is rare.
#[inline(never)]
fn chosen(
    unknown: impl Into<Name>,
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
    Err(out_of_range(unknown.into(), value, span.low, span.high, is_angle))
}

#[cold]
fn out_of_range(unknown: Name, value: f64, low: f64, high: f64, is_angle: bool) -> Failure {
    Failure::OutOfRange {
        unknown,
        value,
        low,
        high,
        is_angle,
    }
}

/// The revolutions that bring an angle into a range, in radians.
#[derive(Clone, Copy)]
struct RevolutionsInto<T> {
    angle: T,
    low: f64,
    high: f64,
}

impl<T: Scalar> Measure<T, 1> for RevolutionsInto<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 1] {
        [self.angle]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measure<R: Real>(&self, [angle]: [R; 1]) -> R {
        // The tolerance is calculated outside of the range only.
        let revolutions = R::choose(
            within(angle, self.low, self.high),
            || R::of(0.0),
            || Span::new(self.low, self.high, angle, T::EPSILON).revolutions(angle),
        );
        revolutions * R::of(TAU)
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI, TAU};

    use proptest::prelude::*;

    use super::{check_angle, check_value, choose, choose_in};
    use crate::assembly::Assembly;
    use crate::failure::Failure;
    use crate::quantity::{Name, NameKind};
    use crate::solve::SolutionInRange;

    #[test]
    fn values_are_chosen_by_the_range() {
        let choose = |first, second| choose::<f64, 1>([SolutionInRange::value("e", [first, second], 0.0, 10.0)]);
        assert_eq!(choose(1.0, -1.0), Ok(Assembly::Open));
        assert_eq!(choose(-1.0, 1.0), Ok(Assembly::Crossed));
        assert_eq!(choose(3.0, 3.0), Ok(Assembly::Open));
        assert_eq!(choose(0.0, -0.0), Ok(Assembly::Open));
        assert_eq!(
            choose(10.0 + 1e-15, -5.0),
            Ok(Assembly::Open),
            "rounding at an end is allowed for"
        );
        assert_eq!(
            choose(1.0, 2.0),
            Err(Failure::Ambiguous {
                unknown: "e".into(),
                first: 1.0,
                second: 2.0,
                is_angle: false
            })
        );
        assert_eq!(
            choose(-3.0, 11.0),
            Err(Failure::OutOfRange {
                unknown: "e".into(),
                value: 11.0,
                low: 0.0,
                high: 10.0,
                is_angle: false
            })
        );
        assert_eq!(choose(1.0, f64::NAN), Err(Failure::not_finite("e")));
    }

    #[test]
    fn angles_are_chosen_modulo_whole_revolutions() {
        let choose_in =
            |low, high, first, second| choose::<f64, 1>([SolutionInRange::angle("gamma", [first, second], low, high)]);
        let choose = |first, second| choose_in(0.0, PI, first, second);
        assert_eq!(choose(0.5, -0.5), Ok(Assembly::Open));
        assert_eq!(choose(-0.5, 0.5), Ok(Assembly::Crossed));
        assert_eq!(choose(0.5 - TAU, -0.5 + 3.0 * TAU), Ok(Assembly::Open));
        assert!(matches!(choose(0.5, 0.6), Err(Failure::Ambiguous { .. })));
        assert!(matches!(
            choose(-0.5, -0.6),
            Err(Failure::OutOfRange { value, .. }) if value == -0.5
        ));
        // Two solutions meet at either end of the range.
        assert_eq!(choose(0.0, -0.0), Ok(Assembly::Open));
        assert_eq!(choose(-1e-17, 1e-17), Ok(Assembly::Open));
        assert!(choose(PI, -PI).is_ok());
        assert_eq!(
            choose_in(f64::NEG_INFINITY, -1.0, -3.0, -0.1),
            Err(Failure::Ambiguous {
                unknown: "gamma".into(),
                first: -3.0,
                second: -0.1 - TAU,
                is_angle: true
            })
        );
    }

    /// The next range decides only where the one before holds both solutions.
    #[test]
    fn several_ranges_choose_one_after_the_other() {
        let choose = |first: [f64; 2], second: [f64; 2]| {
            choose([
                SolutionInRange::value("a", first, 0.0, 10.0),
                SolutionInRange::value("b", second, 0.0, 10.0),
            ])
        };
        assert_eq!(choose([1.0, -1.0], [-1.0, 1.0]), Ok(Assembly::Open));
        assert_eq!(choose([1.0, 2.0], [-1.0, 1.0]), Ok(Assembly::Crossed));
        assert!(matches!(
            choose([-1.0, -2.0], [1.0, -1.0]),
            Err(Failure::OutOfRange { unknown, .. }) if unknown == "a"
        ));
        assert!(matches!(
            choose([1.0, 2.0], [-1.0, -2.0]),
            Err(Failure::OutOfRange { unknown, .. }) if unknown == "b"
        ));
        assert!(matches!(
            choose([1.0, 2.0], [3.0, 4.0]),
            Err(Failure::Ambiguous { unknown, .. }) if unknown == "b"
        ));
    }

    #[test]
    fn values_are_checked() {
        assert_eq!(check_value("s", 1.0, 0.0, f64::INFINITY), Ok(1.0));
        assert_eq!(check_value("s", 1.0 + 1e-16, 0.0, 1.0), Ok(1.0 + 1e-16));
        assert_eq!(
            check_value("s", -1.0, 0.0, f64::INFINITY),
            Err(Failure::OutOfRange {
                unknown: "s".into(),
                value: -1.0,
                low: 0.0,
                high: f64::INFINITY,
                is_angle: false
            })
        );
        for value in [f64::NAN, f64::INFINITY] {
            assert_eq!(
                check_value("s", value, 0.0, f64::INFINITY),
                Err(Failure::not_finite("s"))
            );
        }
    }

    proptest! {
        #[test]
        fn angles_are_brought_into_the_range(angle in -100.0..100.0, low in -20.0..20.0, width in 0.0..10.0) {
            let high = low + width;
            match check_angle::<f64>("x", angle, low, high) {
                Ok(inside) => {
                    prop_assert!(inside >= low - 1e-12 && inside <= high + 1e-12);
                    let revolutions = (inside - angle) / TAU;
                    prop_assert!((revolutions - revolutions.round()).abs() < 1e-12);
                }
                Err(Failure::OutOfRange { value, .. }) => {
                    prop_assert!(width < TAU);
                    prop_assert!(value < low || value > high);
                    let distance = (low - value).max(value - high);
                    prop_assert!(distance <= FRAC_PI_2 * 2.0 + 1e-12);
                }
                Err(other) => prop_assert!(false, "{:?}", other),
            }
        }
    }

    /// A mechanism that is made while the program runs names its unknowns by their indices.
    #[test]
    fn an_unknown_may_be_named_by_its_index() {
        let unknown = Name::by_index(NameKind::Unknown, 1);
        let outside = |value, is_angle| Failure::OutOfRange {
            unknown,
            value,
            low: 0.0,
            high: 1.0,
            is_angle,
        };
        assert_eq!(check_value(unknown, 2.0, 0.0, 1.0), Err(outside(2.0, false)));
        assert_eq!(check_angle(unknown, 1.5, 0.0, 1.0), Err(outside(1.5, true)));
        let range = |second| SolutionInRange::value(unknown, [2.0, second], 0.0, 1.0);
        assert_eq!(choose_in(&[range(3.0)]), Err(outside(2.0, false)));
        assert_eq!(choose_in(&[range(0.5)]), Ok(Assembly::Crossed));
        assert!(choose_in(&[range(0.5)][..0]).is_err());
    }

    #[test]
    fn an_angle_in_the_range_is_left_alone() {
        assert_eq!(check_angle("x", 7.0, 0.0, 10.0), Ok(7.0));
        assert_eq!(check_angle("x", -FRAC_PI_2, PI, TAU), Ok(TAU - FRAC_PI_2));
        assert!(check_angle("x", f64::NAN, 0.0, 10.0).is_err());
    }
}
