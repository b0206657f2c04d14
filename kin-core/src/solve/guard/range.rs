//! The solution that lies in the range declared for an unknown.

use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::solve::Scalar;
use crate::solve::check::{AngleInRange, SolutionInRange, Span, ValueInRange, out_of_range};
use crate::solve::guard::turn::turned;

/// The choice between two solutions by the ranges `low..=high` of unknowns: [`Assembly::Open`] for the first solution,
/// [`Assembly::Crossed`] for the second. The first range that does not contain both solutions decides.
///
/// A range without an end has an infinite end. Solutions may lie beyond an end by no more than rounding. Two solutions
/// that coincide count as one, the first. An angle lies in its range if whole turns can bring it there.
///
/// # Errors
/// [`Failure::OutOfRange`] with the solution closest to the range that decides if neither lies in it, [`Failure::Ambiguous`] if
/// both lie in all ranges, [`Failure::NotFinite`].
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
pub fn choose<T: Scalar, const K: usize>(ranges: [SolutionInRange<T>; K]) -> Result<Assembly, Failure> {
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
pub fn check_value<T: Scalar>(unknown: &'static str, value: T, low: f64, high: f64) -> Result<T, Failure> {
    value.provided(ValueInRange { value, low, high }).ok_or_else(|| {
        let real = value.real();
        if real.is_finite() {
            out_of_range(unknown, real, low, high, false)
        } else {
            Failure::not_finite(unknown)
        }
    })
}

/// The angle that lies in `low..=high`, up to rounding, and differs from `value` by as few whole turns as possible.
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
pub fn check_angle<T: Scalar>(unknown: &'static str, value: T, low: f64, high: f64) -> Result<T, Failure> {
    let range = |angle: T| AngleInRange { angle, low, high };
    let Some(value) = value.provided(range(value)) else {
        let real = value.real();
        return Err(if real.is_finite() {
            let nearest = Span::new(low, high, real, T::EPSILON).representative(real);
            out_of_range(unknown, nearest, low, high, true)
        } else {
            Failure::not_finite(unknown)
        });
    };
    Ok(turned(value, range(value).turns()))
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI, TAU};

    use proptest::prelude::*;

    use super::{check_angle, check_value, choose};
    use crate::assembly::Assembly;
    use crate::failure::Failure;
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
    fn angles_are_chosen_modulo_whole_turns() {
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
