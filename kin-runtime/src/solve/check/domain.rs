//! Functions that are not defined everywhere, and their inverses.
//!
//! A declaration may contain these functions anywhere. Their arguments are checked, so that they never give NaN. An end
//! of a domain is allowed if the function has a value there and the derivatives that the number type carries exist.

use core::f64::consts::{FRAC_PI_2, PI};

use crate::failure::Failure;
use crate::solve::Scalar;
use crate::solve::check::doubt::{is_distinct_from, size};
use crate::solve::check::{Check, Real};

/// The square root √x for x ≥ 0.
///
/// # Errors
/// [`Failure::OutsideDomain`], [`Failure::NotFinite`].
///
/// ```
/// use kin_core::solve;
///
/// assert_eq!(solve::square_root_of(9.0), Ok(3.0));
/// assert!(solve::square_root_of(-9.0).is_err());
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn square_root_of<T: Scalar>(x: T) -> Result<T, Failure> {
    within(Ends::NotNegative, x, x.sqrt(), "sqrt")
}

/// The angle in -π/2 ..= π/2 whose sine is `x`, for |x| ≤ 1.
///
/// # Errors
/// [`Failure::OutsideDomain`], [`Failure::NotFinite`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn arc_sine<T: Scalar>(x: T) -> Result<T, Failure> {
    within(Ends::Unit, x, x.asin(), "asin")
}

/// The angle in 0 ..= π whose cosine is `x`, for |x| ≤ 1.
///
/// # Errors
/// [`Failure::OutsideDomain`], [`Failure::NotFinite`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn arc_cosine<T: Scalar>(x: T) -> Result<T, Failure> {
    within(Ends::Unit, x, x.acos(), "acos")
}

/// The non-negative number whose hyperbolic cosine is `x`, for x ≥ 1.
///
/// # Errors
/// [`Failure::OutsideDomain`], [`Failure::NotFinite`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn area_hyperbolic_cosine<T: Scalar>(x: T) -> Result<T, Failure> {
    within(Ends::FromOne, x, x.acosh(), "acosh")
}

/// The number whose hyperbolic tangent is `x`, for |x| < 1.
///
/// # Errors
/// [`Failure::OutsideDomain`], [`Failure::NotFinite`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn area_hyperbolic_tangent<T: Scalar>(x: T) -> Result<T, Failure> {
    within(Ends::WithinUnit, x, x.atanh(), "atanh")
}

/// The natural logarithm ln x for x > 0.
///
/// # Errors
/// [`Failure::OutsideDomain`], [`Failure::NotFinite`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn logarithm<T: Scalar>(x: T) -> Result<T, Failure> {
    within(Ends::Positive, x, x.ln(), "ln")
}

/// The solution x of asin(x) = v, which is sin v, for |v| ≤ π/2.
///
/// # Errors
/// [`Failure::OutsideDomain`], [`Failure::NotFinite`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn sine_of_arc<T: Scalar>(v: T) -> Result<T, Failure> {
    within(Ends::RightAngles, v, v.sin_cos().0, "the inverse of asin")
}

/// The solution x of acos(x) = v, which is cos v, for 0 ≤ v ≤ π.
///
/// # Errors
/// [`Failure::OutsideDomain`], [`Failure::NotFinite`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn cosine_of_arc<T: Scalar>(v: T) -> Result<T, Failure> {
    within(Ends::HalfRevolution, v, v.sin_cos().1, "the inverse of acos")
}

/// The solution x of atan(x) = v, which is tan v, for |v| < π/2.
///
/// # Errors
/// [`Failure::OutsideDomain`], [`Failure::NotFinite`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn tangent_of_arc<T: Scalar>(v: T) -> Result<T, Failure> {
    let (sine, cosine) = v.sin_cos();
    within(Ends::WithinRightAngles, v, sine / cosine, "the inverse of atan")
}

/// The solution x of acosh(x) = v, which is cosh v, for v ≥ 0.
///
/// # Errors
/// [`Failure::OutsideDomain`], [`Failure::NotFinite`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn hyperbolic_cosine_of_area<T: Scalar>(v: T) -> Result<T, Failure> {
    within(Ends::NotNegative, v, v.cosh(), "the inverse of acosh")
}

/// The solution x of sqrt(x) = v, which is v², for v ≥ 0.
///
/// # Errors
/// [`Failure::OutsideDomain`], [`Failure::NotFinite`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn square_of_root<T: Scalar>(v: T) -> Result<T, Failure> {
    within(Ends::NotNegative, v, v * v, "the inverse of sqrt")
}

/// The result, if its argument is inside the domain and the result and its rates are finite.
#[cfg_attr(not(debug_assertions), inline(always))]
fn within<T: Scalar>(ends: Ends, argument: T, result: T, function: &'static str) -> Result<T, Failure> {
    let domain = InDomain {
        argument,
        result,
        ends,
        function,
    };
    match result.provided(domain) {
        Some(result) if result.is_finite() => Ok(result),
        _ => {
            let argument = argument.real();
            Err(outside(domain.is_inside(argument), argument, function))
        }
    }
}

#[cold]
#[inline(never)]
fn outside(inside: bool, argument: f64, function: &'static str) -> Failure {
    if argument.is_finite() && !inside {
        Failure::OutsideDomain { function, argument }
    } else {
        Failure::NotFinite {
            quantity: "argument of a function, its value, or the rate of its value".into(),
        }
    }
}

/// The domain of a function.
#[derive(Clone, Copy)]
enum Ends {
    /// Numbers ≥ 0.
    NotNegative,
    /// Numbers > 0.
    Positive,
    /// Numbers from -1 to 1.
    Unit,
    /// Numbers between -1 and 1, without the ends.
    WithinUnit,
    /// Numbers ≥ 1.
    FromOne,
    /// Angles from -π/2 to π/2, up to rounding.
    RightAngles,
    /// Angles from 0 to π, up to rounding.
    HalfRevolution,
    /// Angles between -π/2 and π/2, without the ends.
    WithinRightAngles,
}

/// Whether an argument lies in the domain of a function, and the value there is finite.
#[derive(Clone, Copy)]
struct InDomain<T> {
    argument: T,
    result: T,
    ends: Ends,
    /// The function, as written in a declaration.
    function: &'static str,
}

impl<T: Scalar> InDomain<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_inside<R: Real>(&self, x: R) -> R::Truth {
        match self.ends {
            Ends::NotNegative => x.is_at_least(R::of(0.0)),
            Ends::Positive => x.exceeds(R::of(0.0)),
            Ends::Unit => x.magnitude().is_at_most(R::of(1.0)),
            Ends::WithinUnit => x.magnitude().is_below(R::of(1.0)),
            Ends::FromOne => x.is_at_least(R::of(1.0)),
            Ends::RightAngles => x.magnitude().is_at_most(R::of(FRAC_PI_2 * (1.0 + 4.0 * T::EPSILON))),
            Ends::HalfRevolution => {
                let rounding = 4.0 * PI * T::EPSILON;
                R::both(x.is_at_least(R::of(-rounding)), || x.is_at_most(R::of(PI + rounding)))
            }
            Ends::WithinRightAngles => x.magnitude().is_below(R::of(FRAC_PI_2)),
        }
    }

    /// Whether an argument is clearly inside or outside the ends whose size is about 1.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_decided<R: Real>(&self, x: R) -> R::Truth {
        let one = R::of(1.0);
        let decided = |low, high| {
            R::both(is_distinct_from::<T, R>(low, x, one), || {
                is_distinct_from::<T, R>(high, x, one)
            })
        };
        match self.ends {
            Ends::NotNegative | Ends::Positive => R::certainly(true),
            Ends::Unit | Ends::WithinUnit => decided(-1.0, 1.0),
            Ends::FromOne => is_distinct_from::<T, R>(1.0, x, one),
            Ends::RightAngles | Ends::WithinRightAngles => decided(-FRAC_PI_2, FRAC_PI_2),
            Ends::HalfRevolution => decided(0.0, PI),
        }
    }
}

impl<T: Scalar> Check<T, 2, 3> for InDomain<T> {
    fn name(&self) -> &'static str {
        self.function
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 2] {
        [self.argument, self.result]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [argument, result]: [R; 2]) -> [R::Truth; 3] {
        // Each of several poses needs the test for a finite value here, because a later division by an infinite value
        // hides it.
        [self.is_inside(argument), self.is_decided(argument), result.is_finite()]
    }

    fn margin(&self) -> T {
        match self.ends {
            Ends::NotNegative | Ends::Positive => self.argument,
            Ends::Unit | Ends::WithinUnit => T::constant(1.0) - size(self.argument),
            Ends::FromOne => self.argument - T::constant(1.0),
            Ends::RightAngles | Ends::WithinRightAngles => T::constant(FRAC_PI_2) - size(self.argument),
            Ends::HalfRevolution => T::constant(FRAC_PI_2) - size(self.argument - T::constant(FRAC_PI_2)),
        }
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use super::*;
    use crate::batch::lanes::Lanes;

    #[test]
    fn inside_the_functions_are_the_usual_ones() {
        assert_eq!(square_root_of(4.0), Ok(2.0));
        assert_eq!(square_root_of(0.0), Ok(0.0));
        assert_eq!(arc_sine(1.0), Ok(FRAC_PI_2));
        assert_eq!(arc_cosine(-1.0), Ok(PI));
        assert_eq!(logarithm(1.0), Ok(0.0));
        assert_eq!(sine_of_arc(FRAC_PI_2), Ok(1.0));
        assert_eq!(cosine_of_arc(PI), Ok(-1.0));
        assert_eq!(sine_of_arc(core::f32::consts::FRAC_PI_2), Ok(1.0));
        assert_eq!(cosine_of_arc(core::f32::consts::PI), Ok(-1.0));
        assert_eq!(square_of_root(3.0), Ok(9.0));
        assert_eq!(area_hyperbolic_cosine(1.0), Ok(0.0));
        assert_eq!(area_hyperbolic_tangent(0.0), Ok(0.0));
        assert_eq!(hyperbolic_cosine_of_area(0.0), Ok(1.0));
        assert!((tangent_of_arc(1.0).unwrap() - 1.0_f64.tan()).abs() < 1e-15);
    }

    #[test]
    fn outside_they_are_not_defined() {
        for (result, function, argument) in [
            (square_root_of(-1.0), "sqrt", -1.0),
            (arc_sine(1.5), "asin", 1.5),
            (arc_cosine(-1.5), "acos", -1.5),
            (logarithm(0.0), "ln", 0.0),
            (sine_of_arc(2.0), "the inverse of asin", 2.0),
            (cosine_of_arc(-0.1), "the inverse of acos", -0.1),
            (tangent_of_arc(2.0), "the inverse of atan", 2.0),
            (square_of_root(-0.1), "the inverse of sqrt", -0.1),
            (area_hyperbolic_cosine(0.5), "acosh", 0.5),
            (area_hyperbolic_tangent(1.0), "atanh", 1.0),
            (area_hyperbolic_tangent(-1.0), "atanh", -1.0),
            (hyperbolic_cosine_of_area(-0.1), "the inverse of acosh", -0.1),
        ] {
            assert_eq!(result, Err(Failure::OutsideDomain { function, argument }));
        }
    }

    #[test]
    fn nothing_that_is_not_finite_comes_out() {
        for function in [
            square_root_of::<f64>,
            arc_sine,
            arc_cosine,
            logarithm,
            sine_of_arc,
            cosine_of_arc,
            tangent_of_arc,
            square_of_root,
            area_hyperbolic_cosine,
            area_hyperbolic_tangent,
            hyperbolic_cosine_of_area,
        ] {
            for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                assert!(matches!(function(value), Err(Failure::NotFinite { .. })));
            }
        }
    }

    #[test]
    fn nor_for_one_of_several_poses() {
        for function in [
            square_root_of::<Lanes<2, 128>>,
            logarithm,
            square_of_root,
            area_hyperbolic_cosine,
            hyperbolic_cosine_of_area,
        ] {
            for value in [f64::NAN, f64::INFINITY, f64::MAX] {
                let Ok(Lanes([first, second])) = function(Lanes([value, 2.0])) else {
                    panic!("lanes decide each for itself");
                };
                assert!(first.is_nan() || first.is_finite(), "{value}: {first}");
                assert!(value == f64::MAX || first.is_nan(), "{value}: {first}");
                assert!(second.is_finite(), "{second}");
            }
        }
    }
}
