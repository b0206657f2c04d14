//! One unknown in a quadratic equation.

use super::refusal::root;
use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::solve::Scalar;
use crate::solve::check::doubt::{least, size, smaller};
use crate::solve::check::regular::{Finite, ordinary_from};
use crate::solve::check::{Check, NotNegative, Real};

const QUANTITY: &str = "coefficients of a quadratic equation, or its solution";

/// A root of `a x² + b x + c = 0`. [`Assembly::Open`] is the larger one, whatever the sign of `a`.
///
/// A root can be written as (g ± q) / a or as c / (g ∓ q), with g = -b / 2 and q² = g² - a c. The function takes the
/// form in which nothing cancels (G. E. Forsythe, *How do you solve a quadratic equation?*, Stanford 1966).
///
/// It takes 7 operations: 2 additions, 3 multiplications, 1 division, 1 square root.
///
/// # Errors
/// [`Failure::OutOfReach`] with the margin -√(4 a c - b²) / 2|a|, which is the imaginary part of the roots with its
/// sign reversed, in the unit of `x`; [`Failure::Singular`] for a double root, or if `a` is zero;
/// [`Failure::NotFinite`].
///
/// ```
/// use kin_core::{Assembly, solve};
///
/// // x² - 3 x + 2 = (x - 1) (x - 2)
/// assert_eq!(solve::quadratic(1.0, -3.0, 2.0, Assembly::Open), Ok(2.0));
/// assert_eq!(solve::quadratic(1.0, -3.0, 2.0, Assembly::Crossed), Ok(1.0));
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn quadratic<T: Scalar>(a: T, b: T, c: T, assembly: Assembly) -> Result<T, Failure> {
    let g = b * T::constant(-0.5);
    let q2 = g * g - a * c;
    // Cancelling numbers are no larger than this.
    let reach = Reach {
        q2,
        least: least(|| g * g),
        a,
    };
    let fails = || no_root(a.real(), b.real(), c.real(), T::EPSILON);
    let q2 = q2.provided(reach).ok_or_else(fails)?;
    let q = q2.sqrt();
    // g and q are added with the same sign. The root is that sum divided by a, or c divided by it.
    let sum = T::either(NotNegative(g), || g + q, || g - q);
    // In (g ± q) / a, a negative divisor reverses the order of the roots.
    let direct = IsSum { a, g };
    let above = T::assembled(
        assembly,
        || T::either(direct, || sum, || c),
        || T::either(direct, || c, || sum),
    );
    let below = T::assembled(
        assembly,
        || T::either(direct, || a, || sum),
        || T::either(direct, || sum, || a),
    );
    let x = above / below;
    x.provided(Finite([x])).ok_or_else(fails)
}

/// Whether the parabola reaches zero. `q2` is a quarter of its discriminant.
#[derive(Clone, Copy)]
struct Reach<T> {
    q2: T,
    least: T,
    a: T,
}

impl<T: Scalar> Check<T, 3, 3> for Reach<T> {
    fn name(&self) -> &'static str {
        "reach of a parabola"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 3] {
        [self.q2, self.least, self.a]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [q2, least, a]: [R; 3]) -> [R::Truth; 3] {
        let [low, high] = ordinary_from(q2, least, T::SMALLEST_DIVISOR);
        [low, high, R::not(a.equals(R::of(0.0)))]
    }

    fn margin(&self) -> T {
        // As a length: the root of the missing square, divided by the leading coefficient.
        size(self.q2).sqrt().times_sign_of(self.q2) / size(self.a)
    }
}

/// Whether the larger root is the sum g ± q divided by the leading coefficient; otherwise the smaller root is. The
/// other root is the last coefficient divided by that sum.
#[derive(Clone, Copy)]
struct IsSum<T> {
    a: T,
    g: T,
}

impl<T: Scalar> Check<T, 2, 1> for IsSum<T> {
    fn name(&self) -> &'static str {
        "formula of a root"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 2] {
        [self.a, self.g]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [a, g]: [R; 2]) -> [R::Truth; 1] {
        let (plus, above) = (a.exceeds(R::of(0.0)), g.is_at_least(R::of(0.0)));
        [R::either(R::both(plus, || above), || R::not(R::either(plus, || above)))]
    }

    /// The smaller of the magnitudes of the two coefficients.
    fn margin(&self) -> T {
        smaller(size(self.a), size(self.g))
    }
}

#[cold]
#[inline(never)]
fn no_root(a: f64, b: f64, c: f64, epsilon: f64) -> Failure {
    if !(a.is_finite() && b.is_finite() && c.is_finite()) {
        return Failure::not_finite(QUANTITY);
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
        Failure::not_finite(QUANTITY)
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
                // The coefficients themselves are rounded, and the condition carries this into each root.
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
        // The equation x² - 2 x + 5 = 0 has the roots 1 ± 2i.
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

    /// A multiple of an equation has the same roots, or no roots for the same reason.
    #[test]
    fn a_multiple_of_an_equation_says_the_same() {
        let beyond = |rounding: f64| 1.0 + rounding;
        for factor in [1.0, 2.0_f64.powi(-60), 2.0_f64.powi(60)] {
            let solve = |c: f64| quadratic::<f64>(factor, -2.0 * factor, c * factor, Assembly::Open);
            assert!(matches!(
                solve(beyond(1e-9)),
                Err(Failure::OutOfReach { margin }) if (margin + 1e-9_f64.sqrt()).abs() < 1e-10
            ));
            // The tolerance is 8 ε of g² and of a c.
            assert_eq!(
                solve(beyond(12.0 * f64::EPSILON)),
                Err(Failure::Singular { determinant: 0.0 })
            );
        }
    }
}
