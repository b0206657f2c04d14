//! One unknown of which the square occurs.

use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::solve::Scalar;
use crate::solve::diagnosis::{ordinary_from, root};
use crate::solve::doubt::least;

const QUANTITY: &str = "coefficients of a quadratic equation, or its solution";

/// A root of `a x² + b x + c = 0`. [`Assembly::Open`] is the larger one, whatever the sign of `a`.
///
/// Of the two ways to write a root, (g ± q) / a and c / (g ∓ q) with g = -b / 2 and q² = g² - a c, the one is taken in which
/// nothing cancels (G. E. Forsythe, *How do you solve a quadratic equation?*, Stanford 1966).
///
/// 7 operations: 2 additions, 3 multiplications, 1 division, 1 square root.
///
/// # Errors
/// [`Failure::OutOfReach`] with the margin -√(4 a c - b²) / 2|a|, the imaginary part of the roots with its sign reversed,
/// in the unit of `x`; [`Failure::Singular`] for a double root, or if `a` is zero; [`Failure::NotFinite`].
///
/// ```
/// use kin_core::{Assembly, solve};
///
/// // x² - 3 x + 2 = (x - 1) (x - 2)
/// assert_eq!(solve::quadratic(1.0, -3.0, 2.0, Assembly::Open), Ok(2.0));
/// assert_eq!(solve::quadratic(1.0, -3.0, 2.0, Assembly::Crossed), Ok(1.0));
/// ```
#[inline(always)]
pub fn quadratic<T: Scalar>(a: T, b: T, c: T, assembly: Assembly) -> Result<T, Failure> {
    let g = b * T::constant(-0.5);
    let q2 = g * g - a * c;
    // What cancels is no larger.
    let least = least(|| g * g);
    let fails = || no_root(a.real(), b.real(), c.real(), T::EPSILON);
    let q2 = q2
        .provided([q2, least, a], |[q2, least, a]| {
            let [low, high] = ordinary_from(q2, least, T::SMALLEST);
            [low, high, a != 0.0]
        })
        .ok_or_else(fails)?;
    let q = q2.sqrt();
    // g and q are added with the same sign, and the root is that sum by a, or c by it.
    let sum = T::either([g], |[g]| g >= 0.0, || g + q, || g - q);
    // The sign of the root in (g ± q) / a: dividing by a negative number reverses the order.
    let plus = |a: f64| (assembly == Assembly::Open) == (a > 0.0);
    let direct = |[a, g]: [f64; 2]| plus(a) == (g >= 0.0);
    let above = T::either([a, g], direct, || sum, || c);
    let below = T::either([a, g], direct, || a, || sum);
    let x = above / below;
    x.provided([x], |[x]| [x.is_finite()]).ok_or_else(fails)
}

#[cold]
#[inline(never)]
fn no_root(a: f64, b: f64, c: f64, epsilon: f64) -> Failure {
    if !(a.is_finite() && b.is_finite() && c.is_finite()) {
        return Failure::NotFinite { quantity: QUANTITY };
    }
    if a == 0.0 {
        return Failure::Singular { determinant: 0.0 };
    }
    let square = 0.25 * b * b;
    let q2 = square - a * c;
    if q2.abs() <= 8.0 * epsilon * (square + (a * c).abs()) {
        Failure::Singular { determinant: 0.0 }
    } else if q2 < 0.0 {
        Failure::OutOfReach {
            margin: -root(-q2) / a.abs(),
        }
    } else {
        Failure::NotFinite { quantity: QUANTITY }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::quadratic;
    use crate::assembly::Assembly;
    use crate::failure::Failure;
    use crate::solve::strategies::coordinate;

    proptest! {
        #[test]
        fn each_root_keeps_its_precision(a in coordinate(), r in coordinate(), s in coordinate()) {
            let (low, high) = (r.min(s), r.max(s));
            let condition = (low.abs() + high.abs()) / (high - low);
            if condition >= 1e6 {
                return Ok(());
            }
            for (assembly, root) in [(Assembly::Open, high), (Assembly::Crossed, low)] {
                let x = quadratic(a, -a * (r + s), a * r * s, assembly).unwrap();
                // The coefficients themselves are rounded; each root feels it by the condition.
                prop_assert!((x - root).abs() <= 32.0 * f64::EPSILON * condition * condition * root.abs());
            }
        }
    }

    #[test]
    fn small_roots_do_not_cancel() {
        assert_eq!(quadratic(1.0, -1e9, 1.0, Assembly::Crossed), Ok(1e-9));
        assert_eq!(quadratic(1.0, 1e9, 1.0, Assembly::Open), Ok(-1e-9));
        assert_eq!(quadratic(1.0, 0.0, -4.0, Assembly::Open), Ok(2.0));
        assert_eq!(quadratic(-1.0, 0.0, 4.0, Assembly::Crossed), Ok(-2.0));
        assert_eq!(quadratic(1.0, -3.0, 0.0, Assembly::Crossed), Ok(0.0));
    }

    #[test]
    fn limits_and_what_lies_beyond() {
        let solve = |a, b, c| quadratic::<f64>(a, b, c, Assembly::Open);
        let singular = Err(Failure::Singular { determinant: 0.0 });
        assert_eq!(solve(1.0, -2.0, 1.0), singular);
        assert_eq!(solve(0.0, 2.0, 1.0), singular);
        assert_eq!(solve(0.1, -0.2, 0.1), singular);
        // x² - 2 x + 5 has the roots 1 ± 2i.
        assert_eq!(solve(1.0, -2.0, 5.0), Err(Failure::OutOfReach { margin: -2.0 }));
        assert_eq!(solve(-2.0, 4.0, -10.0), Err(Failure::OutOfReach { margin: -2.0 }));
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for result in [solve(value, 1.0, -1.0), solve(1.0, value, -1.0), solve(1.0, 1.0, value)] {
                assert!(matches!(result, Err(Failure::NotFinite { .. })));
            }
        }
        assert!(matches!(solve(1e-300, 1e10, 1.0), Ok(x) if x.is_finite()));
        assert!(matches!(
            quadratic(1e-300, 1e10, 1.0, Assembly::Crossed),
            Err(Failure::NotFinite { .. })
        ));
    }
}
