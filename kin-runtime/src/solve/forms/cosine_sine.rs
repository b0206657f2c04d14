//! One angle from an equation in its cosine and sine.

use super::refusal::{length, refusal};
use super::root::Root;
use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::geometry::Plane;
use crate::solve::Scalar;
use crate::solve::check::doubt::{divisor, least_from, size as magnitude};
use crate::solve::check::regular::ordinary_from;
use crate::solve::check::{Check, Real};

const QUANTITY: &str = "coefficients of the cosine and the sine";

/// The largest error of a sum of sines and cosines that counts as rounding, in units of ε and of the size of its terms.
const ROUNDING: f64 = 8.0;

/// The unit vector `u` = (cos x, sin x) with `a cos x + b sin x = c`.
///
/// The coefficients share one unit. `size` is that of the terms whose sums `a` and `b` are, or zero where nothing is
/// known of it: rounding leaves coefficients of a part of it that stand for zeros. [`Assembly::Open`] is x = atan2(b,
/// a) + acos(c / ρ), with ρ² = a² + b²; the crossed solution has the minus sign.
///
/// The second result is the root, a sin x - b cos x = ± √(ρ² - c²), positive in the open assembly. The divisor of rates
/// is its opposite.
///
/// It takes 15 operations: 4 additions, 9 multiplications, 1 division, 1 square root; and one change of sign in the
/// crossed assembly.
///
/// # Errors
/// [`Failure::OutOfReach`] with the margin ρ - |c|, [`Failure::Singular`] if the margin is zero or if `a` and `b` are
/// both zero up to rounding, [`Failure::NotFinite`].
///
/// ```
/// use kin_core::{Assembly, solve};
///
/// let (u, root) = solve::cosine_sine(3.0_f64, 4.0, 3.0, 0.0, Assembly::Crossed)?;
/// assert!((u.x - 1.0).abs() < 1e-15 && u.y.abs() < 1e-15);
/// assert!((root.value + 4.0).abs() < 1e-15);
/// // the cosine of a right angle is a zero that rounding has moved
/// assert!(solve::cosine_sine(0.0, 90_f64.to_radians().cos(), 0.0, 1.0, Assembly::Open).is_err());
/// # Ok::<(), kin_core::Failure>(())
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn cosine_sine<T: Scalar>(a: T, b: T, c: T, size: f64, assembly: Assembly) -> Result<(Plane<T>, Root<T>), Failure> {
    let rho2 = a * a + b * b;
    let q2 = rho2 - c * c;
    let noise = ROUNDING * T::EPSILON * size;
    let reach = Reach {
        q2,
        least: least_from((noise * noise).max(T::SMALLEST_DIVISOR), || rho2),
        rho2,
        c,
    };
    let Some(root) = Root::provided(q2, reach, assembly) else {
        return Err(T::refused(|| {
            no_angle([a.real(), b.real(), c.real()], noise, T::EPSILON)
        }));
    };
    let inverse = T::constant(1.0) / rho2;
    let (cosine, sine) = (c * inverse, root.value * inverse);
    let u = Plane::new((a * cosine).minus_product(b, sine), (b * cosine).plus_product(a, sine));
    Ok((u, root))
}

/// Whether the amplitude ρ of `a cos x + b sin x` reaches `c`.
#[derive(Clone, Copy)]
struct Reach<T> {
    q2: T,
    least: T,
    rho2: T,
    c: T,
}

impl<T: Scalar> Check<T, 2, 2> for Reach<T> {
    fn name(&self) -> &'static str {
        "reach of a cosine and a sine"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 2] {
        [self.q2, self.least]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [q2, least]: [R; 2]) -> [R::Truth; 2] {
        ordinary_from(q2, least, T::SMALLEST_DIVISOR)
    }

    fn margin(&self) -> T {
        self.rho2.sqrt() - magnitude(self.c)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn square(&self) -> T {
        divisor(self.rho2)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shortfall(&self, rho: T) -> Option<[T; 2]> {
        let c = magnitude(self.c);
        Some([rho - c, rho + c])
    }
}

#[cold]
#[inline(never)]
fn no_angle([a, b, c]: [f64; 3], noise: f64, epsilon: f64) -> Failure {
    let rho = length(a, b);
    // the determinant is √(ρ² - c²)
    if rho.max(c.abs()) <= noise || rho == 0.0 && c.is_finite() {
        return Failure::Singular { determinant: rho };
    }
    refusal(rho - c.abs(), rho + c.abs(), epsilon, 0.0, QUANTITY)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::cosine_sine;
    use crate::assembly::Assembly;
    use crate::failure::Failure;
    use crate::geometry::Plane;
    use crate::solve::strategies::{angle, coordinate, direction, norm};

    proptest! {
        #[test]
        fn both_angles_satisfy_the_equation(a in coordinate(), b in coordinate(), x in angle()) {
            let coefficients = Plane::new(a, b);
            let rho = norm(coefficients);
            let c = coefficients.dot(direction(x));
            let condition = rho / coefficients.cross(direction(x)).abs();
            if condition >= 1e6 {
                return Ok(());
            }
            let tolerance = 32.0 * f64::EPSILON * condition * condition;
            for (assembly, sign) in [(Assembly::Open, 1.0), (Assembly::Crossed, -1.0)] {
                let (u, root) = cosine_sine(a, b, c, 0.0, assembly).unwrap();
                prop_assert!((coefficients.cross(u) - root.value).abs() <= tolerance * rho);
                prop_assert_eq!(root.value > 0.0, assembly == Assembly::Open);
                prop_assert!((norm(u) - 1.0).abs() <= tolerance);
                prop_assert!((coefficients.dot(u) - c).abs() <= tolerance * rho);
                let expected = direction(b.atan2(a) + sign * (c / rho).acos());
                prop_assert!(norm(u - expected) <= tolerance);
            }
        }
    }

    #[test]
    fn limits_and_what_lies_beyond() {
        let solve = |a, b, c| cosine_sine::<f64>(a, b, c, 0.0, Assembly::Open).map(|(u, _)| u);
        let singular = Err(Failure::Singular { determinant: 0.0 });
        assert_eq!(solve(3.0, 4.0, 5.0), singular);
        assert_eq!(solve(3.0, 4.0, -5.0), singular);
        assert_eq!(solve(0.0, 0.0, 1.0), singular);
        assert_eq!(solve(3.0, 4.0, 5.5), Err(Failure::OutOfReach { margin: -0.5 }));
        for value in [f64::NAN, f64::INFINITY] {
            for result in [solve(value, 1.0, 1.0), solve(1.0, value, 1.0), solve(1.0, 1.0, value)] {
                assert!(matches!(result, Err(Failure::NotFinite { .. })));
            }
        }
    }

    /// Coefficients that are zero up to the rounding of their terms determine no angle. Those that are small by
    /// themselves do.
    #[test]
    fn what_rounding_leaves_determines_no_angle() {
        let solve = |a: f64, b, c, size| cosine_sine(a, b, c, size, Assembly::Open);
        for (a, b) in [(1e-16, 0.0), (0.0, -6e-17), (1e-15, 1e-15)] {
            for c in [0.0, 1e-16] {
                assert!(
                    matches!(solve(a, b, c, 1.0), Err(Failure::Singular { .. })),
                    "{a} {b} {c}"
                );
            }
            // out of reach by more than rounding
            assert!(matches!(solve(a, b, 1e-3, 1.0), Err(Failure::OutOfReach { .. })));
            assert!(solve(a, b, 0.0, 0.0).is_ok() && solve(a, b, 0.0, 1e-2).is_ok());
        }
        assert!(solve(1e-14, 0.0, 0.0, 1.0).is_ok());
    }
}
