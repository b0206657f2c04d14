//! A link of known length whose end slides along a line: the intersection of a circle and a line.

use super::refusal::{length, refusal, root};
use super::root::Root;
use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::geometry::Plane;
use crate::solve::Scalar;
use crate::solve::check::doubt::{divisor, least, size, sum_of_sizes};
use crate::solve::check::regular::{Finite, ordinary_from};
use crate::solve::check::{Check, Real};

const QUANTITY: &str = "link length, direction of the slide or distance spanned";

/// A vector of known length and a travel in a known direction: `v + s direction = c`, `|v|² = a2`.
///
/// This is the dyad with two revolute joints and a slide. `a2` is the square of the length, in the units of `c`. The
/// direction need not be a unit vector; `s` counts its multiples. [`Assembly::Open`] is the larger `s`, in which the
/// link leans back against the direction: v · direction < 0.
///
/// s = (c · u ± √(a² u² - (u × c)²)) / u². It takes 19 operations: 7 additions, 10 multiplications, 1 division, 1
/// square root.
///
/// # Errors
/// [`Failure::OutOfReach`] with the margin |a| - distance from the centre of the circle to the line,
/// [`Failure::Singular`] if the line touches the circle (the link is at right angles to the slide) or
/// the direction is zero, [`Failure::NotFinite`].
///
/// ```
/// use kin_core::{Assembly, Plane, solve};
///
/// let (link, travel) =
///     solve::circle_line(25.0, Plane::new(2.0, 0.0), Plane::new(1.0, 3.0), Assembly::Open)?;
/// assert_eq!((link.x, link.y, travel), (-4.0, 3.0, 2.5));
/// # Ok::<(), kin_core::Failure>(())
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn circle_line<T: Scalar>(
    a2: T,
    direction: Plane<T>,
    c: Plane<T>,
    assembly: Assembly,
) -> Result<(Plane<T>, T), Failure> {
    let u2 = direction.norm_squared();
    let along = direction.dot(c);
    let beside = direction.cross(c);
    let q2 = a2 * u2 - beside * beside;
    let sizes = || {
        let terms = [a2 * u2, beside * direction.x * c.y, beside * direction.y * c.x];
        sum_of_sizes(&terms)
    };
    let reach = Reach {
        q2,
        least: least(sizes),
        u2,
        a2,
        c,
        beside,
    };
    let Some((_, q)) = q2.rooted(reach) else {
        return Err(does_not_reach(a2, direction, c));
    };
    let travel = T::assembled(assembly, || along + q, || along - q) / u2;
    let Some(travel) = travel.provided(Finite([travel])) else {
        return Err(does_not_reach(a2, direction, c));
    };
    Ok((c - direction.scale(travel), travel))
}

/// [`circle_line`] along the x axis: `v + (s, 0) = c`. The results are v.x and s; v.y is c.y.
///
/// It takes 5 operations at most: 2 additions, 1 multiplication, 1 square root, and one change of sign in the open
/// assembly.
///
/// # Errors
/// As for [`circle_line`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn circle_line_x<T: Scalar>(a2: T, c: Plane<T>, assembly: Assembly) -> Result<(Root<T>, T), Failure> {
    let q2 = a2 - c.y * c.y;
    let reach = ReachAlongX {
        q2,
        least: least(|| a2),
        c,
        a2,
    };
    let Some(leg) = Root::provided(q2, reach, assembly.mirrored()) else {
        let axis = Plane::new(T::constant(1.0), T::constant(0.0));
        return Err(does_not_reach(a2, axis, c));
    };
    Ok((leg, c.x - leg.value))
}

/// [`circle_line`] along the y axis: `v + (0, s) = c`. The results are v.y and s; v.x is c.x.
///
/// It takes 5 operations at most: 2 additions, 1 multiplication, 1 square root, and one change of sign in the open
/// assembly.
///
/// # Errors
/// As for [`circle_line`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn circle_line_y<T: Scalar>(a2: T, c: Plane<T>, assembly: Assembly) -> Result<(Root<T>, T), Failure> {
    circle_line_x(a2, Plane::new(c.y, c.x), assembly)
}

/// Whether a link reaches a line. `a2` is the square of its length, and `u2` that of the direction of the line.
#[derive(Clone, Copy)]
struct Reach<T> {
    q2: T,
    least: T,
    u2: T,
    a2: T,
    c: Plane<T>,
    /// The distance of the line, multiplied by the length of its direction.
    beside: T,
}

impl<T: Scalar> Check<T, 3, 3> for Reach<T> {
    fn name(&self) -> &'static str {
        "reach of a circle and a line"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 3] {
        [self.q2, self.least, self.u2]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [q2, least, u2]: [R; 3]) -> [R::Truth; 3] {
        let [low, high] = ordinary_from(q2, least, T::SMALLEST_DIVISOR);
        [low, high, u2.is_at_least(R::of(T::SMALLEST_DIVISOR))]
    }

    fn margin(&self) -> T {
        margin(self.a2, self.q2 / self.u2)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn square(&self) -> T {
        self.a2
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shortfall(&self, root: T) -> Option<[T; 2]> {
        let distance = size(self.beside) / divisor(self.u2).sqrt();
        Some(shortfall(root, self.c, distance))
    }
}

/// Whether a link reaches a line parallel to an axis, from a point on the axis.
#[derive(Clone, Copy)]
struct ReachAlongX<T> {
    q2: T,
    least: T,
    c: Plane<T>,
    a2: T,
}

impl<T: Scalar> Check<T, 3, 3> for ReachAlongX<T> {
    fn name(&self) -> &'static str {
        "reach of a circle and an axis"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 3] {
        [self.q2, self.least, self.c.x]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [q2, least, x]: [R; 3]) -> [R::Truth; 3] {
        let [low, high] = ordinary_from(q2, least, T::SMALLEST_DIVISOR);
        [low, high, x.is_finite()]
    }

    fn margin(&self) -> T {
        margin(self.a2, self.q2)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn square(&self) -> T {
        self.a2
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shortfall(&self, root: T) -> Option<[T; 2]> {
        Some(shortfall(root, self.c, size(self.c.y)))
    }
}

/// The difference between the length of a link and the distance of the line, where `q2` is the difference of their
/// squares.
fn margin<T: Scalar>(a2: T, q2: T) -> T {
    size(a2).sqrt() - size(a2 - q2).sqrt()
}

/// The difference between the length of a link and the distance of the line, and a size of the lengths.
#[cfg_attr(not(debug_assertions), inline(always))]
fn shortfall<T: Scalar>(radius: T, c: Plane<T>, distance: T) -> [T; 2] {
    [radius - distance, radius + size(c.x) + size(c.y)]
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn does_not_reach<T: Scalar>(a2: T, direction: Plane<T>, c: Plane<T>) -> Failure {
    T::refused(|| {
        diagnose(
            a2.real(),
            Plane::new(direction.x.real(), direction.y.real()),
            Plane::new(c.x.real(), c.y.real()),
            T::EPSILON,
        )
    })
}

#[cold]
#[inline(never)]
fn diagnose(a2: f64, direction: Plane, c: Plane, epsilon: f64) -> Failure {
    let norm = length(direction.x, direction.y);
    let radius = root(a2.abs());
    let scale = radius + length(c.x, c.y);
    if !(scale.is_finite() && norm.is_finite()) {
        return Failure::not_finite(QUANTITY);
    }
    if norm == 0.0 {
        return Failure::Singular { determinant: 0.0 };
    }
    let distance = (c.y * (direction.x / norm) - c.x * (direction.y / norm)).abs();
    // A negative square has no real length; the missing length is the root of its magnitude.
    let reach = if a2 < 0.0 { -radius } else { radius };
    refusal(reach - distance, scale, epsilon, 0.0, QUANTITY)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{circle_line, circle_line_x, circle_line_y};
    use crate::assembly::Assembly;
    use crate::failure::Failure;
    use crate::geometry::Plane;
    use crate::solve::strategies::{angle, coordinate, dimension, direction, norm};

    const X: Plane = Plane::new(1.0, 0.0);
    const Y: Plane = Plane::new(0.0, 1.0);

    proptest! {
        #[test]
        fn both_assemblies_close(
            a in dimension(), inclination in angle(), heading in angle(), stretch in dimension(),
            travel in coordinate(),
        ) {
            let unit = direction(heading);
            let link = direction(inclination).scale(a);
            let c = link + unit.scale(travel);
            let scale = a + norm(c);
            let condition = scale * scale / (link.dot(unit).abs() * a);
            if condition >= 1e12 {
                return Ok(());
            }
            let tolerance = 64.0 * f64::EPSILON * scale * condition;
            let u = unit.scale(stretch);
            for assembly in Assembly::BOTH {
                let (v, s) = circle_line(a * a, u, c, assembly).unwrap();
                prop_assert!(norm(v + u.scale(s) - c) <= 8.0 * f64::EPSILON * scale);
                prop_assert!((norm(v) - a).abs() <= tolerance);
                prop_assert_eq!(v.dot(u) < 0.0, assembly == Assembly::Open);
            }
            let (_, open) = circle_line(a * a, u, c, Assembly::Open).unwrap();
            let (_, crossed) = circle_line(a * a, u, c, Assembly::Crossed).unwrap();
            prop_assert!(open > crossed);
            let original = if link.dot(unit) < 0.0 { open } else { crossed };
            prop_assert!((original * stretch - travel).abs() <= tolerance);
        }

        #[test]
        fn the_axes_agree_with_the_general_form(a in 1.0..2.0, x in -3.0..3.0, y in -0.99..0.99) {
            for assembly in Assembly::BOTH {
                let c = Plane::new(x, y);
                let (general, travel) = circle_line(a * a, X, c, assembly).unwrap();
                let (special, s) = circle_line_x(a * a, c, assembly).unwrap();
                prop_assert!((general.x - special.value).abs() < 1e-14 && (travel - s).abs() < 1e-14);
                prop_assert!((special.value.powi(2) - special.square).abs() <= 2.0 * f64::EPSILON * special.square);

                let c = Plane::new(y, x);
                let (general, travel) = circle_line(a * a, Y, c, assembly).unwrap();
                let (special, s) = circle_line_y(a * a, c, assembly).unwrap();
                prop_assert!((general.y - special.value).abs() < 1e-14 && (travel - s).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn a_link_at_right_angles_to_the_slide_is_singular() {
        let singular = Failure::Singular { determinant: 0.0 };
        for assembly in Assembly::BOTH {
            let (c, d) = (Plane::new(5.0, 3.0), Plane::new(3.0, 5.0));
            assert_eq!(circle_line(9.0, X, c, assembly), Err(singular));
            assert_eq!(circle_line_x(9.0, c, assembly), Err(singular));
            assert_eq!(circle_line_y(9.0, d, assembly), Err(singular));
            assert_eq!(circle_line(9.0, Plane::new(0.0, 0.0), c, assembly), Err(singular));
        }
    }

    #[test]
    fn the_margin_is_the_radius_less_the_distance() {
        let c = Plane::new(5.0, 3.5);
        for result in [
            circle_line(9.0, X.scale(7.0), c, Assembly::Open).map(drop),
            circle_line_x(9.0, c, Assembly::Open).map(drop),
            circle_line_y(9.0, Plane::new(-3.5, 5.0), Assembly::Open).map(drop),
        ] {
            assert_eq!(result, Err(Failure::OutOfReach { margin: -0.5 }));
        }
        // The point (5, 3.5) is 5 · 0.8 - 3.5 · 0.6 = 1.9 away from a slide in the direction (3, 4).
        let slanted = circle_line(0.81, Plane::new(3.0, 4.0), c, Assembly::Open);
        assert!(
            matches!(slanted, Err(Failure::OutOfReach { margin }) if (margin + 1.0).abs() < 1e-15),
            "{slanted:?}"
        );
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
            for index in 0..5 {
                let mut arguments = [4.0, 1.0, 0.0, 1.0, 0.5];
                arguments[index] = value;
                let [a2, u, v, x, y] = arguments;
                let (direction, c) = (Plane::new(u, v), Plane::new(x, y));
                for result in [
                    circle_line(a2, direction, c, Assembly::Open).map(|(link, travel)| [link.x, link.y, travel]),
                    circle_line_x(a2, c, Assembly::Crossed).map(|(leg, travel)| [leg.value, leg.square, travel]),
                    circle_line_y(a2, c, Assembly::Crossed).map(|(leg, travel)| [leg.value, leg.square, travel]),
                ] {
                    if let Ok(parts) = result {
                        for part in parts {
                            assert!(part.is_finite(), "{arguments:?}");
                        }
                    } else if !value.is_finite() {
                        assert!(
                            matches!(result, Err(Failure::NotFinite { .. })),
                            "{arguments:?} {result:?}"
                        );
                    }
                }
            }
        }
    }
}
