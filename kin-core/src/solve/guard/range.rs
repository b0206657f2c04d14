//! The solution that lies in the range declared for an unknown.

use core::f64::consts::TAU;

use num_traits::Float;

use super::turn::add_turns;
use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::solve::Scalar;
use crate::solve::doubt::is_told_from;

/// Units of rounding by which a solution may lie outside of its range.
const TOLERANCE: f64 = 8.0;

/// The failure of a decision that several poses must leave to the solver of one pose.
const IN_DOUBT: Failure = Failure::NotFinite { quantity: "lanes" };

/// The ends of a range belong to it, and what lies beyond them by no more than rounding does too.
#[derive(Clone, Copy)]
struct Range {
    low: f64,
    high: f64,
    tolerance: f64,
}

impl Range {
    /// `value` is any value of the size of those that will be asked for.
    fn new(low: f64, high: f64, value: f64, epsilon: f64) -> Self {
        let finite = |end: f64| if end.is_finite() { end.abs() } else { 0.0 };
        let size = finite(low).max(finite(high)).max(finite(value));
        Self {
            low,
            high,
            tolerance: TOLERANCE * epsilon * size,
        }
    }

    fn holds_strictly(self, value: f64) -> bool {
        value >= self.low && value <= self.high
    }

    fn holds(self, value: f64) -> bool {
        value >= self.low - self.tolerance && value <= self.high + self.tolerance
    }

    /// Whether a value is told from both ends: beyond [doubt](Scalar::DOUBT) where it stands for several poses.
    fn tells<T: Scalar>(self, value: f64) -> bool {
        let size = self.tolerance / TOLERANCE / T::EPSILON;
        is_told_from::<T>(self.low, value, size) && is_told_from::<T>(self.high, value, size)
    }

    /// The same for an angle that may have been brought to the range by whole turns.
    fn tells_angle<T: Scalar>(self, angle: f64) -> bool {
        let size = angle.abs().max(TAU);
        let ends = [self.low, self.low + TAU, self.high, self.high - TAU];
        ends.iter().all(|end| is_told_from::<T>(*end, angle, size))
    }

    fn distance(self, value: f64) -> f64 {
        (self.low - value).max(value - self.high).max(0.0)
    }

    /// How many turns have to be added to an angle to have it in the range, or next to it: as few as possible.
    fn turns(self, angle: f64) -> f64 {
        let turns = if angle < self.low {
            Float::ceil((self.low - self.tolerance - angle) / TAU)
        } else if angle > self.high {
            -Float::ceil((angle - self.high - self.tolerance) / TAU)
        } else {
            0.0
        };
        if turns == 0.0 { 0.0 } else { turns }
    }

    /// The representative of an angle that is in the range, or that comes nearest to it.
    fn representative(self, angle: f64) -> f64 {
        let inside = angle + TAU * self.turns(angle);
        if self.holds(inside) {
            return inside;
        }
        // A range of less than a turn can be missed on either side.
        [inside - TAU, inside + TAU].into_iter().fold(inside, |nearest, other| {
            if self.distance(other) < self.distance(nearest) {
                other
            } else {
                nearest
            }
        })
    }
}

/// Which of two solutions lies in `low..=high`: [`Assembly::Open`] for the first, [`Assembly::Crossed`] for the second.
///
/// A range without end has an infinite one. An end is overstepped by no more than rounding. Two solutions that coincide are one, the first.
///
/// # Errors
/// [`Failure::OutOfRange`] with the solution that comes nearest if neither lies in the range, [`Failure::Ambiguous`] if both do,
/// [`Failure::NotFinite`].
///
/// ```
/// use kin_core::{Assembly, solve};
///
/// assert_eq!(solve::choose_value("e", -2.0, 2.0, 0.0, f64::INFINITY), Ok(Assembly::Crossed));
/// ```
#[inline(always)]
pub fn choose_value<T: Scalar>(
    unknown: &'static str,
    first: T,
    second: T,
    low: f64,
    high: f64,
) -> Result<Assembly, Failure> {
    T::decided([first, second], |[first, second]| {
        let range = Range::new(low, high, first.abs().max(second.abs()), T::EPSILON);
        if !(range.tells::<T>(first) && range.tells::<T>(second)) {
            return Err(IN_DOUBT);
        }
        match (first >= low && first <= high, second >= low && second <= high) {
            (true, false) if second.is_finite() => Ok(Assembly::Open),
            (false, true) if first.is_finite() => Ok(Assembly::Crossed),
            _ => choose(unknown, first, second, range),
        }
    })
}

/// [`choose_value`] for angles: a solution lies in the range if it does so after some whole turns.
///
/// # Errors
/// As for [`choose_value`].
///
/// ```
/// use kin_core::{Assembly, solve};
///
/// let chosen = solve::choose_angle("gamma", 0.5, -0.5, 5.0, 6.2);
/// assert_eq!(chosen, Ok(Assembly::Crossed));
/// ```
#[inline(always)]
pub fn choose_angle<T: Scalar>(
    unknown: &'static str,
    first: T,
    second: T,
    low: f64,
    high: f64,
) -> Result<Assembly, Failure> {
    T::decided([first, second], |[first, second]| {
        let range = Range::new(low, high, first.abs().max(second.abs()), T::EPSILON);
        let (first, second) = (range.representative(first), range.representative(second));
        if !(range.tells_angle::<T>(first) && range.tells_angle::<T>(second)) {
            return Err(IN_DOUBT);
        }
        choose(unknown, first, second, range)
    })
}

fn choose(unknown: &'static str, first: f64, second: f64, range: Range) -> Result<Assembly, Failure> {
    if !(first.is_finite() && second.is_finite()) {
        return Err(Failure::NotFinite { quantity: unknown });
    }
    if (first - second).abs() <= range.tolerance && range.holds(first) && range.holds(second) {
        return Ok(Assembly::Open);
    }
    // Rounding is allowed for only where there would be no solution otherwise.
    for inside in [Range::holds_strictly, Range::holds] {
        match (inside(range, first), inside(range, second)) {
            (true, false) => return Ok(Assembly::Open),
            (false, true) => return Ok(Assembly::Crossed),
            (true, true) => {
                return Err(Failure::Ambiguous { unknown, first, second });
            }
            (false, false) => {}
        }
    }
    let value = if range.distance(second) < range.distance(first) {
        second
    } else {
        first
    };
    Err(out_of_range(unknown, value, range.low, range.high))
}

/// The value itself if it lies in `low..=high`, up to rounding.
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
#[inline(always)]
pub fn check_value<T: Scalar>(unknown: &'static str, value: T, low: f64, high: f64) -> Result<T, Failure> {
    let holds = |real: f64| {
        let strictly = real >= low && real <= high;
        real.is_finite() && (strictly || Range::new(low, high, real, T::EPSILON).holds(real))
    };
    let is_told = |real: f64| T::DOUBT == 0.0 || Range::new(low, high, real, T::EPSILON).tells::<T>(real);
    let conditions = |[real]: [f64; 1]| [holds(real), is_told(real)];
    value.provided([value], conditions).ok_or_else(|| {
        let real = value.real();
        if real.is_finite() {
            out_of_range(unknown, real, low, high)
        } else {
            Failure::NotFinite { quantity: unknown }
        }
    })
}

/// The angle that lies in `low..=high`, up to rounding, and differs from `value` by whole turns: by as few as possible.
///
/// # Errors
/// [`Failure::OutOfRange`] with the representative nearest to the range, [`Failure::NotFinite`].
///
/// ```
/// use core::f64::consts::TAU;
/// use kin_core::solve;
///
/// assert_eq!(solve::check_angle("theta4", -1.0, 0.0, TAU), Ok(TAU - 1.0));
/// ```
#[inline(always)]
pub fn check_angle<T: Scalar>(unknown: &'static str, value: T, low: f64, high: f64) -> Result<T, Failure> {
    let range = |real: f64| Range::new(low, high, real, T::EPSILON);
    let strictly = |real: f64| real >= low && real <= high;
    let holds = |real: f64| {
        let range = range(real);
        real.is_finite() && (strictly(real) || range.holds(range.representative(real)))
    };
    let is_told = |real: f64| {
        let range = range(real);
        T::DOUBT == 0.0 || range.tells_angle::<T>(range.representative(real))
    };
    let Some(value) = value.provided([value], |[real]| [holds(real), is_told(real)]) else {
        let real = value.real();
        return Err(if real.is_finite() {
            out_of_range(unknown, range(real).representative(real), low, high)
        } else {
            Failure::NotFinite { quantity: unknown }
        });
    };
    Ok(add_turns([value], |[real]| {
        if strictly(real) { 0.0 } else { range(real).turns(real) }
    }))
}

#[cold]
fn out_of_range(unknown: &'static str, value: f64, low: f64, high: f64) -> Failure {
    Failure::OutOfRange {
        unknown,
        value,
        low,
        high,
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI, TAU};

    use proptest::prelude::*;

    use super::{check_angle, check_value, choose_angle, choose_value};
    use crate::assembly::Assembly;
    use crate::failure::Failure;

    #[test]
    fn values_are_chosen_by_the_range() {
        let choose = |first, second| choose_value::<f64>("e", first, second, 0.0, 10.0);
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
                unknown: "e",
                first: 1.0,
                second: 2.0
            })
        );
        assert_eq!(
            choose(-3.0, 11.0),
            Err(Failure::OutOfRange {
                unknown: "e",
                value: 11.0,
                low: 0.0,
                high: 10.0
            })
        );
        assert_eq!(choose(1.0, f64::NAN), Err(Failure::NotFinite { quantity: "e" }));
    }

    #[test]
    fn angles_are_chosen_modulo_whole_turns() {
        let choose = |first, second| choose_angle::<f64>("gamma", first, second, 0.0, PI);
        assert_eq!(choose(0.5, -0.5), Ok(Assembly::Open));
        assert_eq!(choose(-0.5, 0.5), Ok(Assembly::Crossed));
        assert_eq!(choose(0.5 - TAU, -0.5 + 3.0 * TAU), Ok(Assembly::Open));
        assert!(matches!(choose(0.5, 0.6), Err(Failure::Ambiguous { .. })));
        assert!(matches!(
            choose(-0.5, -0.6),
            Err(Failure::OutOfRange { value, .. }) if value == -0.5
        ));
        // Where two solutions meet, at either end of the range.
        assert_eq!(choose(0.0, -0.0), Ok(Assembly::Open));
        assert_eq!(choose(-1e-17, 1e-17), Ok(Assembly::Open));
        assert!(choose(PI, -PI).is_ok());
        assert_eq!(
            choose_angle::<f64>("gamma", -3.0, -0.1, f64::NEG_INFINITY, -1.0),
            Err(Failure::Ambiguous {
                unknown: "gamma",
                first: -3.0,
                second: -0.1 - TAU
            })
        );
    }

    #[test]
    fn values_are_checked() {
        assert_eq!(check_value("s", 1.0, 0.0, f64::INFINITY), Ok(1.0));
        assert_eq!(check_value("s", 1.0 + 1e-16, 0.0, 1.0), Ok(1.0 + 1e-16));
        assert_eq!(
            check_value("s", -1.0, 0.0, f64::INFINITY),
            Err(Failure::OutOfRange {
                unknown: "s",
                value: -1.0,
                low: 0.0,
                high: f64::INFINITY
            })
        );
        for value in [f64::NAN, f64::INFINITY] {
            assert_eq!(
                check_value("s", value, 0.0, f64::INFINITY),
                Err(Failure::NotFinite { quantity: "s" })
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
                    let turns = (inside - angle) / TAU;
                    prop_assert!((turns - turns.round()).abs() < 1e-12);
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

    #[test]
    fn an_angle_in_the_range_is_left_alone() {
        assert_eq!(check_angle("x", 7.0, 0.0, 10.0), Ok(7.0));
        assert_eq!(check_angle("x", -FRAC_PI_2, PI, TAU), Ok(TAU - FRAC_PI_2));
        assert!(check_angle("x", f64::NAN, 0.0, 10.0).is_err());
    }
}
