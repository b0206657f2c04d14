//! One unknown from its square.

use super::refusal::root;
use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::solve::Scalar;
use crate::solve::check::doubt::size;
use crate::solve::check::{Check, Real};

/// A root of `x² = w`. [`Assembly::Open`] is the positive one.
///
/// It takes 1 operation, a square root; and one change of sign in the crossed assembly.
///
/// # Errors
/// [`Failure::OutOfReach`] with the margin -√-w, [`Failure::Singular`] if `w` is zero, [`Failure::NotFinite`].
///
/// ```
/// use kin_core::{Assembly, solve};
///
/// assert_eq!(solve::square_root(9.0, Assembly::Crossed), Ok(-3.0));
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn square_root<T: Scalar>(w: T, assembly: Assembly) -> Result<T, Failure> {
    match w.provided(Positive { square: w }) {
        Some(square) => Ok(square.sqrt().signed(assembly)),
        None => Err(no_root(w.real())),
    }
}

/// Whether a square has a root other than zero.
#[derive(Clone, Copy)]
struct Positive<T> {
    square: T,
}

impl<T: Scalar> Check<T, 1, 2> for Positive<T> {
    fn name(&self) -> &'static str {
        "positive square"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 1] {
        [self.square]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [square]: [R; 1]) -> [R::Truth; 2] {
        [square.exceeds(R::of(0.0)), square.is_below(R::of(f64::INFINITY))]
    }

    fn margin(&self) -> T {
        size(self.square).sqrt().times_sign_of(self.square)
    }
}

#[cold]
#[inline(never)]
fn no_root(w: f64) -> Failure {
    if !w.is_finite() {
        Failure::NotFinite {
            quantity: "square of the unknown".into(),
        }
    } else if w < 0.0 {
        Failure::OutOfReach { margin: -root(-w) }
    } else {
        Failure::Singular { determinant: 0.0 }
    }
}

#[cfg(test)]
mod tests {
    use super::square_root;
    use crate::assembly::Assembly;
    use crate::failure::Failure;

    #[test]
    fn limits_and_what_lies_beyond() {
        let solve = |w| square_root::<f64>(w, Assembly::Open);
        assert_eq!(solve(0.0), Err(Failure::Singular { determinant: 0.0 }));
        assert_eq!(solve(-4.0), Err(Failure::OutOfReach { margin: -2.0 }));
        assert_eq!(solve(5e-324).map(|x| x > 0.0), Ok(true));
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(matches!(solve(value), Err(Failure::NotFinite { .. })));
        }
    }
}
