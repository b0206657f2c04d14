//! One number from its hyperbolic cosine.

use super::refusal::refusal;
use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::solve::Scalar;
use crate::solve::check::doubt::{is_distinct_from, size};
use crate::solve::check::{Check, Real};

/// The number a with cosh a = `value`. In [`Assembly::Open`] it has the sign of `growth`, in the crossed assembly the
/// opposite sign.
///
/// If a is a multiple of an unknown plus a constant, and `growth` has the sign of the factor, then the open assembly
/// has the larger of the two unknowns.
///
/// It takes one function of the number library, and one change of sign in the crossed assembly.
///
/// # Errors
/// [`Failure::OutOfReach`] with the margin `value` - 1, [`Failure::Singular`] if the margin is zero,
/// [`Failure::NotFinite`].
///
/// ```
/// use kin_core::{Assembly, solve};
///
/// let value = 2.0_f64.cosh();
/// let argument = solve::inverse_hyperbolic_cosine(value, 1.0, Assembly::Crossed)?;
/// assert!((argument + 2.0).abs() < 1e-15);
/// # Ok::<(), kin_core::Failure>(())
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn inverse_hyperbolic_cosine<T: Scalar>(value: T, growth: T, assembly: Assembly) -> Result<T, Failure> {
    match value.provided(AboveOne { value }) {
        Some(value) => Ok(value.acosh().times_sign_of(growth).signed(assembly)),
        None => Err(T::refused(|| too_small(value.real(), T::EPSILON))),
    }
}

/// Whether a number is the hyperbolic cosine of two different numbers.
#[derive(Clone, Copy)]
struct AboveOne<T> {
    value: T,
}

impl<T: Scalar> Check<T, 1, 3> for AboveOne<T> {
    fn name(&self) -> &'static str {
        "reach of a hyperbolic cosine"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 1] {
        [self.value]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [value]: [R; 1]) -> [R::Truth; 3] {
        let one = R::of(1.0);
        [
            value.exceeds(one),
            value.is_below(R::of(f64::INFINITY)),
            is_distinct_from::<T, R>(1.0, value, one),
        ]
    }

    fn margin(&self) -> T {
        self.value - T::constant(1.0)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shortfall(&self, _: T) -> Option<[T; 2]> {
        Some([self.margin(), size(self.value) + T::constant(1.0)])
    }
}

#[cold]
#[inline(never)]
fn too_small(value: f64, epsilon: f64) -> Failure {
    refusal(value - 1.0, 1.0, epsilon, 0.0, "hyperbolic cosine of an unknown")
}

#[cfg(test)]
mod tests {
    use super::inverse_hyperbolic_cosine;
    use crate::assembly::Assembly;
    use crate::failure::Failure;
    use crate::number::Number;

    #[test]
    fn the_assembly_and_the_growth_give_the_sign() {
        for assembly in Assembly::BOTH {
            for growth in [2.0_f64, -3.0, 1e-300] {
                for argument in [1e-7, 0.3, 2.0, 700.0] {
                    let value = Number::cosh(argument);
                    let found = inverse_hyperbolic_cosine(value, growth, assembly).unwrap();
                    assert_eq!(found.abs(), Number::acosh(value));
                    assert_eq!(Assembly::from_sign(found * growth), assembly);
                }
            }
        }
    }

    #[test]
    fn limits_and_what_lies_beyond() {
        let solve = |value| inverse_hyperbolic_cosine::<f64>(value, 1.0, Assembly::Open);
        for value in [1.0, 1.0 - f64::EPSILON] {
            assert_eq!(solve(value), Err(Failure::Singular { determinant: 0.0 }));
        }
        for value in [0.5, -2.0] {
            assert_eq!(solve(value), Err(Failure::OutOfReach { margin: value - 1.0 }));
        }
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(matches!(solve(value), Err(Failure::NotFinite { .. })));
        }
    }
}
