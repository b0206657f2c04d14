//! A length along an unknown direction: a slide on a link that rotates.

use super::refusal::{length, refusal};
use super::root::Root;
use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::geometry::Plane;
use crate::solve::Scalar;
use crate::solve::check::doubt::{least, size};
use crate::solve::check::regular::{ordinary, ordinary_from};
use crate::solve::check::{Check, Real};

const QUANTITY: &str = "offset of the slide or distance spanned";

/// The length of a known vector, with a sign: `s u = c`, `|u| = 1`.
///
/// This is the dyad with two revolute joints and a slide between them, as in the inverted slider-crank.
/// [`Assembly::Open`] is the solution with s > 0. `s` has the unit of `c`. The direction is c / s; the caller forms it
/// if needed.
///
/// It takes 4 operations: 1 addition, 2 multiplications, 1 square root; and one change of sign in the crossed assembly.
///
/// # Errors
/// [`Failure::Singular`] if `c` is zero, [`Failure::NotFinite`].
///
/// ```
/// use kin_core::{Assembly, Plane, solve};
///
/// let c = Plane::new(0.0, 2.0);
/// let length = solve::polar(c, Assembly::Crossed)?.value;
/// assert_eq!((length, c.y / length), (-2.0, -1.0));
/// # Ok::<(), kin_core::Failure>(())
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn polar<T: Scalar>(c: Plane<T>, assembly: Assembly) -> Result<Root<T>, Failure> {
    let d2 = c.norm_squared();
    let Some(d2) = d2.provided(Apart { d2 }) else {
        return Err(no_length(c.x.real(), c.y.real()));
    };
    Ok(Root::of(d2, assembly))
}

/// The length and direction of [`polar`] with an offset slide, which passes beside the joint: `(s + offset) u = c` as
/// complex numbers, `|u| = 1`.
///
/// The offset is fixed to the rotating link: its x component lies along the slide, its y component across. s + offset.x
/// = ± √(|c|² - offset.y²), with the plus sign in [`Assembly::Open`].
///
/// It takes 16 operations: 5 additions, 9 multiplications, 1 division, 1 square root; and one change of sign in the
/// crossed assembly.
///
/// # Errors
/// [`Failure::OutOfReach`] with the margin |c| - |offset.y|, [`Failure::Singular`] if the margin is zero,
/// [`Failure::NotFinite`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn polar_offset<T: Scalar>(offset: Plane<T>, c: Plane<T>, assembly: Assembly) -> Result<(T, Plane<T>), Failure> {
    let d2 = c.norm_squared();
    let q2 = d2 - offset.y * offset.y;
    let reach = Reach {
        q2,
        least: least(|| d2),
        shift: offset.x,
        d2,
        across: offset.y,
    };
    let Some((_, q)) = q2.rooted(reach) else {
        return Err(T::refused(|| {
            does_not_pass(
                Plane::new(offset.x.real(), offset.y.real()),
                Plane::new(c.x.real(), c.y.real()),
                T::EPSILON,
            )
        }));
    };
    let along = q.signed(assembly);
    // u = c / w with w = along + i offset.y, and |w|² = |c|².
    let inverse = T::constant(1.0) / d2;
    let cosine = along * inverse;
    let sine = offset.y * inverse;
    let u = Plane::new(
        (c.x * cosine).plus_product(c.y, sine),
        (c.y * cosine).minus_product(c.x, sine),
    );
    Ok((along - offset.x, u))
}

/// Whether two points are apart. `d2` is the square of their distance.
#[derive(Clone, Copy)]
struct Apart<T> {
    d2: T,
}

impl<T: Scalar> Check<T, 1, 2> for Apart<T> {
    fn name(&self) -> &'static str {
        "distance of two points"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 1] {
        [self.d2]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [d2]: [R; 1]) -> [R::Truth; 2] {
        ordinary(d2, T::SMALLEST_DIVISOR)
    }

    fn margin(&self) -> T {
        self.d2.sqrt()
    }
}

/// Whether a slide can pass a point at its offset.
#[derive(Clone, Copy)]
struct Reach<T> {
    q2: T,
    least: T,
    shift: T,
    d2: T,
    across: T,
}

impl<T: Scalar> Check<T, 3, 3> for Reach<T> {
    fn name(&self) -> &'static str {
        "reach of an offset slide"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 3] {
        [self.q2, self.least, self.shift]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [q2, least, shift]: [R; 3]) -> [R::Truth; 3] {
        let [low, high] = ordinary_from(q2, least, T::SMALLEST_DIVISOR);
        [low, high, shift.is_finite()]
    }

    fn margin(&self) -> T {
        self.d2.sqrt() - size(self.across)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn square(&self) -> T {
        self.d2
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shortfall(&self, d: T) -> Option<[T; 2]> {
        let across = size(self.across);
        // The product is NaN if the shift is not finite.
        Some([d - across, d + across + self.shift * T::constant(0.0)])
    }
}

#[cold]
#[inline(never)]
fn no_length(x: f64, y: f64) -> Failure {
    let determinant = length(x, y);
    if determinant.is_finite() && determinant < 1.0 {
        Failure::Singular { determinant }
    } else {
        Failure::not_finite(QUANTITY)
    }
}

#[cold]
#[inline(never)]
fn does_not_pass(offset: Plane, c: Plane, epsilon: f64) -> Failure {
    let d = length(c.x, c.y);
    let across = offset.y.abs();
    if !offset.x.is_finite() {
        return Failure::not_finite(QUANTITY);
    }
    refusal(d - across, d + across, epsilon, 0.0, QUANTITY)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{polar, polar_offset};
    use crate::assembly::Assembly;
    use crate::failure::Failure;
    use crate::geometry::Plane;
    use crate::solve::strategies::{angle, coordinate, dimension, direction, norm};

    proptest! {
        #[test]
        fn length_and_direction_give_the_vector(d in dimension(), heading in angle()) {
            let c = direction(heading).scale(d);
            for assembly in Assembly::BOTH {
                let s = polar(c, assembly).unwrap().value;
                let u = c.scale(1.0 / s);
                prop_assert!((norm(u) - 1.0).abs() <= 4.0 * f64::EPSILON);
                prop_assert_eq!(s > 0.0, assembly == Assembly::Open);
            }
        }

        #[test]
        fn an_offset_slide_closes(s in coordinate(), x in coordinate(), y in coordinate(), heading in angle()) {
            let offset = Plane::new(x, y);
            let arm = Plane::new(s + x, y);
            let c = arm.times(direction(heading));
            let condition = norm(c) / arm.x.abs();
            if condition >= 1e6 {
                return Ok(());
            }
            let tolerance = 32.0 * f64::EPSILON * condition * condition;
            for assembly in Assembly::BOTH {
                let (s, u) = polar_offset(offset, c, assembly).unwrap();
                let arm = Plane::new(s + x, y);
                prop_assert!((norm(u) - 1.0).abs() <= tolerance);
                prop_assert!(norm(arm.times(u) - c) <= tolerance * (norm(c) + x.abs()));
            }
            let along = |assembly| polar_offset(offset, c, assembly).unwrap().0 + x;
            prop_assert!(along(Assembly::Open) > along(Assembly::Crossed));
        }
    }

    #[test]
    fn an_offset_larger_than_the_distance_is_out_of_reach() {
        let c = Plane::new(3.0, 4.0);
        assert_eq!(
            polar_offset(Plane::new(1.0, -6.0), c, Assembly::Open),
            Err(Failure::OutOfReach { margin: -1.0 })
        );
        assert_eq!(
            polar_offset(Plane::new(1.0, 5.0), c, Assembly::Open),
            Err(Failure::Singular { determinant: 0.0 })
        );
        // The excess is rounding alone.
        assert_eq!(
            polar_offset(Plane::new(1.0, 5.0 * (1.0 + 4.0 * f64::EPSILON)), c, Assembly::Open),
            Err(Failure::Singular { determinant: 0.0 })
        );
    }

    #[test]
    fn no_vector_has_no_direction() {
        let c = Plane::new(0.0, 0.0);
        let singular = Failure::Singular { determinant: 0.0 };
        assert_eq!(polar(c, Assembly::Open), Err(singular));
        assert_eq!(polar_offset(c, c, Assembly::Open), Err(singular));
    }

    #[test]
    fn nothing_that_is_not_finite_comes_out() {
        for value in [
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            1e200,
            1e-200,
            f64::MAX,
            5e-324,
        ] {
            for index in 0..4 {
                let mut arguments = [1.0, 0.5, 2.0, 3.0];
                arguments[index] = value;
                let [p, q, x, y] = arguments;
                let (offset, c) = (Plane::new(p, q), Plane::new(x, y));
                for (s, u) in [
                    polar_offset(offset, c, Assembly::Open),
                    polar(c, Assembly::Crossed)
                        .map(|root| root.value)
                        .map(|s| (s, Plane::new(c.x / s, c.y / s))),
                ]
                .into_iter()
                .flatten()
                {
                    assert!(s.is_finite() && u.x.is_finite() && u.y.is_finite(), "{arguments:?}");
                }
                if !value.is_finite() {
                    assert!(matches!(
                        polar_offset(Plane::new(p, q), Plane::new(x, y), Assembly::Open),
                        Err(Failure::NotFinite { .. })
                    ));
                }
            }
        }
    }
}
