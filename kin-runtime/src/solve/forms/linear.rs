//! Unknowns that occur linearly.

use crate::failure::Failure;
use crate::solve::Scalar;
use crate::solve::check::doubt::{decisive, size};
use crate::solve::check::regular::Finite;
use crate::solve::check::{Check, Real};

const QUANTITY: &str = "coefficients of a linear equation, or its solution";

/// The solution of `a x = b`. It takes 1 operation, a division.
///
/// # Errors
/// [`Failure::Singular`] with the determinant `a` if it is zero, or so small that the solution overflows;
/// [`Failure::NotFinite`].
///
/// ```
/// use kin_core::solve;
///
/// assert_eq!(solve::linear(4.0, 6.0), Ok(1.5));
/// assert!(solve::linear(0.0, 6.0).is_err());
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn linear<T: Scalar>(a: T, b: T) -> Result<T, Failure> {
    let x = b / a;
    // Check the coefficient too: division by an infinite coefficient gives zero, which would pass as a solution.
    x.provided(Finite([x, a]))
        .ok_or_else(|| no_solution(a.real(), b.real().is_finite()))
}

/// The solution of two linear equations, `a[i][0] x + a[i][1] y = b[i]`, by Cramer's rule.
///
/// It takes 12 operations: 3 additions, 8 multiplications, 1 division.
///
/// # Errors
/// [`Failure::Singular`] if the determinant is zero up to the rounding of its two products; [`Failure::NotFinite`].
///
/// ```
/// use kin_core::solve;
///
/// assert_eq!(solve::linear_pair([[1.0, 1.0], [1.0, -1.0]], [3.0, 1.0]), Ok((2.0, 1.0)));
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn linear_pair<T: Scalar>(a: [[T; 2]; 2], b: [T; 2]) -> Result<(T, T), Failure> {
    let product = a[0][0] * a[1][1];
    let determinant = product - a[0][1] * a[1][0];
    let determinant = decisive(determinant, || [product, a[0][1] * a[1][0]]);
    let inverse = T::constant(1.0) / determinant;
    let x = (b[0] * a[1][1] - a[0][1] * b[1]) * inverse;
    let y = (a[0][0] * b[1] - b[0] * a[1][0]) * inverse;
    let meet = Meet {
        determinant,
        product,
        x,
        y,
    };
    let (Some(x), Some(y)) = (x.provided(meet), y.provided(meet)) else {
        // Solutions can overflow although the lines are not parallel; then the determinant is not at fault.
        let parallel = determinant.real().abs() <= noise::<T, f64>(product.real());
        let right = parallel && b[0].real().is_finite() && b[1].real().is_finite();
        return Err(no_solution(determinant.real(), right));
    };
    Ok((x, y))
}

/// Whether two lines meet at a point. `product` is the product along the diagonal of their determinant.
#[derive(Clone, Copy)]
struct Meet<T> {
    determinant: T,
    product: T,
    x: T,
    y: T,
}

impl<T: Scalar> Check<T, 4, 4> for Meet<T> {
    fn name(&self) -> &'static str {
        "two lines that meet"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 4] {
        [self.determinant, self.product, self.x, self.y]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [determinant, product, x, y]: [R; 4]) -> [R::Truth; 4] {
        let size = determinant.magnitude();
        [
            size.exceeds(noise::<T, R>(product)),
            size.is_below(R::of(f64::INFINITY)),
            x.is_finite(),
            y.is_finite(),
        ]
    }

    fn margin(&self) -> T {
        size(self.determinant) - T::constant(2.0 * T::EPSILON) * size(self.product)
    }
}

/// The size of rounding errors in the determinant. The determinant of parallel lines is of this size, so the lines
/// would seem to meet far away.
#[cfg_attr(not(debug_assertions), inline(always))]
fn noise<T: Scalar, R: Real>(product: R) -> R {
    R::of(2.0 * T::EPSILON) * product.magnitude()
}

#[cold]
#[inline(never)]
fn no_solution(determinant: f64, rest_is_finite: bool) -> Failure {
    if determinant.is_finite() && rest_is_finite {
        Failure::Singular { determinant }
    } else {
        Failure::not_finite(QUANTITY)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{linear, linear_pair};
    use crate::failure::Failure;
    use crate::solve::strategies::coordinate;

    proptest! {
        #[test]
        fn pairs_satisfy_their_equations(
            p in coordinate(), q in coordinate(), r in coordinate(), s in coordinate(),
            x in coordinate(), y in coordinate(),
        ) {
            let determinant = p * s - q * r;
            let condition = ((p * s).abs() + (q * r).abs()) / determinant.abs();
            if condition >= 1e6 {
                return Ok(());
            }
            let (u, v) = linear_pair([[p, q], [r, s]], [p * x + q * y, r * x + s * y]).unwrap();
            let tolerance = 32.0 * f64::EPSILON * condition;
            // Each numerator cancels as far as its products do.
            let size_x = ((p * x).abs() + (q * y).abs()) * s.abs() + ((r * x).abs() + (s * y).abs()) * q.abs();
            let size_y = ((p * x).abs() + (q * y).abs()) * r.abs() + ((r * x).abs() + (s * y).abs()) * p.abs();
            prop_assert!((u - x).abs() <= tolerance * size_x / determinant.abs());
            prop_assert!((v - y).abs() <= tolerance * size_y / determinant.abs());
        }
    }

    #[test]
    fn zero_coefficients_are_singular() {
        assert_eq!(linear(0.0, 1.0), Err(Failure::Singular { determinant: 0.0 }));
        assert_eq!(linear(0.0, 0.0), Err(Failure::Singular { determinant: 0.0 }));
        assert!(matches!(linear(1e-300, 1e300), Err(Failure::Singular { .. })));
        assert_eq!(linear(2.0, 0.0), Ok(0.0));
    }

    #[test]
    fn parallel_lines_do_not_meet_far_away() {
        // The products 0.1 * 0.6 and 0.2 * 0.3 differ in the last digit.
        let a = [[0.1, 0.2], [0.3, 0.6]];
        for b in [[1.0, 1.0], [0.0, 0.0]] {
            assert!(matches!(linear_pair(a, b), Err(Failure::Singular { .. })));
        }
        assert!(linear_pair([[1.0, 0.0], [0.0, 1e-30]], [1.0, 1.0]).is_ok());
        assert!(linear_pair([[0.0, 1.0], [1.0, 0.0]], [1.0, 2.0]) == Ok((2.0, 1.0)));
    }

    #[test]
    fn nothing_that_is_not_finite_comes_out() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for result in [linear(value, 1.0), linear(1.0, value)] {
                assert!(matches!(result, Err(Failure::NotFinite { .. })));
            }
            for index in 0..6 {
                let mut entries = [1.0, 2.0, 3.0, 5.0, 1.0, 1.0];
                entries[index] = value;
                let [p, q, r, s, x, y] = entries;
                assert!(matches!(
                    linear_pair([[p, q], [r, s]], [x, y]),
                    Err(Failure::NotFinite { .. })
                ));
            }
        }
    }
}
