//! Tests that a number can be used further.

use crate::failure::Failure;
use crate::quantity::Name;
use crate::solve::Scalar;
use crate::solve::check::doubt::size;
use crate::solve::check::{Check, Real};

/// The determinant itself, if it may be a divisor: its magnitude is neither zero, nor so small that it has lost digits,
/// nor too large to have a reciprocal with all digits.
///
/// # Errors
/// [`Failure::Singular`] if it is zero or too small, [`Failure::NotFinite`] if it is too large or NaN.
///
/// ```
/// use kin_core::{Failure, solve};
///
/// assert_eq!(solve::regular(-0.5), Ok(-0.5));
/// assert_eq!(solve::regular(0.0), Err(Failure::Singular { determinant: 0.0 }));
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn regular<T: Scalar>(determinant: T) -> Result<T, Failure> {
    determinant
        .provided(Regular(determinant))
        .ok_or_else(|| irregular(determinant.real()))
}

/// The value itself, if it is finite; all parts of a dual number must be finite. `quantity` names the value in a few
/// words.
///
/// # Errors
/// [`Failure::NotFinite`] if it is too large or NaN.
///
/// ```
/// use kin_core::{Failure, solve};
///
/// assert_eq!(solve::finite("r1", 90.0), Ok(90.0));
/// let error = Failure::NotFinite { quantity: "r1".into() };
/// assert_eq!(solve::finite("r1", f64::NAN), Err(error));
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn finite<T: Scalar>(quantity: impl Into<Name>, value: T) -> Result<T, Failure> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Failure::not_finite(quantity))
    }
}

#[cold]
#[inline(never)]
fn irregular(determinant: f64) -> Failure {
    if determinant.is_finite() && determinant.abs() < 1.0 {
        Failure::Singular { determinant }
    } else {
        Failure::NotFinite {
            quantity: "determinant".into(),
        }
    }
}

/// Whether a determinant is neither zero, nor so small that it has lost digits, nor too large to have a reciprocal.
#[derive(Clone, Copy)]
pub(in crate::solve) struct Regular<T>(pub(in crate::solve) T);

impl<T: Scalar> Check<T, 1, 2> for Regular<T> {
    fn name(&self) -> &'static str {
        "regular determinant"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 1] {
        [self.0]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [determinant]: [R; 1]) -> [R::Truth; 2] {
        ordinary(determinant.magnitude(), T::SMALLEST_DIVISOR)
    }

    fn margin(&self) -> T {
        size(self.0)
    }
}

/// Whether the real parts of some numbers are all finite.
#[derive(Clone, Copy)]
pub(in crate::solve) struct Finite<T, const N: usize>(pub(in crate::solve) [T; N]);

impl<T: Scalar, const N: usize> Check<T, N, N> for Finite<T, N> {
    const IS_LONG: bool = true;

    fn name(&self) -> &'static str {
        "finite numbers"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; N] {
        self.0
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, numbers: [R; N]) -> [R::Truth; N] {
        numbers.map(R::is_finite)
    }

    /// The margin is infinite or NaN.
    fn margin(&self) -> T {
        let sum = self
            .0
            .into_iter()
            .fold(T::constant(0.0), |sum, number| sum + number - number);
        T::constant(f64::INFINITY) + sum
    }
}

/// Whether a number is positive, and whether the number and its reciprocal have full precision: both must hold. NaN
/// fails. The square root of such a number passes too.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::solve) fn ordinary<R: Real>(number: R, smallest: f64) -> [R::Truth; 2] {
    ordinary_from(number, R::of(smallest), smallest)
}

/// [`ordinary`] for a number that must also be at least `least`, which is no smaller than `smallest`.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::solve) fn ordinary_from<R: Real>(number: R, least: R, smallest: f64) -> [R::Truth; 2] {
    [number.is_at_least(least), number.is_at_most(R::of(1.0 / smallest))]
}

#[cfg(test)]
mod tests {
    use super::{finite, regular};
    use crate::failure::Failure;
    use crate::number::series::Series;

    #[test]
    fn a_determinant_is_regular_if_it_has_its_full_precision() {
        for determinant in [
            1.0,
            -1.0,
            2.0 * f64::MIN_POSITIVE,
            -3.0 * f64::MIN_POSITIVE,
            0.1 * f64::MAX,
        ] {
            assert_eq!(regular(determinant), Ok(determinant));
        }
        for determinant in [0.0, -0.0, 1e-310, -f64::MIN_POSITIVE] {
            assert_eq!(regular(determinant), Err(Failure::Singular { determinant }));
        }
        assert!(regular(1e-40_f32).is_err());
        for determinant in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX] {
            assert_eq!(
                regular(determinant),
                Err(Failure::NotFinite {
                    quantity: "determinant".into()
                })
            );
        }
    }

    #[test]
    fn every_part_must_be_finite() {
        assert!(finite("x", Series::from_coefficients([1.0, 2.0])).is_ok());
        assert_eq!(
            finite("x", Series::from_coefficients([1.0, f64::NAN])),
            Err(Failure::not_finite("x"))
        );
    }
}
