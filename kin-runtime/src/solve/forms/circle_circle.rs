//! Two links of known length between two known points: the intersection of two circles.

use super::refusal::{length, refusal, root};
use super::root::Root;
use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::geometry::Plane;
use crate::solve::Scalar;
use crate::solve::check::doubt::{least, size, smaller, sum_of_sizes};
use crate::solve::check::regular::ordinary_from;
use crate::solve::check::{Check, Real};

const QUANTITY: &str = "link lengths or the distance they span";

/// The first of two vectors with known lengths and a known sum: `v₁ + v₂ = c`, `|v₁| = |a|`, `|v₂| = |b|`.
///
/// This is the dyad with three revolute joints. The lengths and `c` share one unit; a negative length stands for its
/// magnitude. [`Assembly::Open`] is the solution with v₁ × v₂ < 0, in which the second vector is clockwise from the
/// first. The second vector is `c - v₁`; the caller forms it if needed, with the sign it needs.
///
/// With d = |c|, the foot of the joint on the line of `c` lies at p = (d² + (a + b)(a - b)) / 2d². The joint lies
/// beside it at q, where 4 q² d⁴ = ((a + b)² - d²)(d² - (a - b)²). This is Heron's formula for the triangle, in factors
/// that do not cancel at the limits. So v₁ = c (p ± i q).
///
/// The second result is the root, 2 c × v₁ = ± 2 q d²: four times the area of the triangle, positive in the open
/// assembly. The divisor of rates, v₁ × v₂, is minus half of it.
///
/// It takes 22 operations: 8 additions, 12 multiplications, 1 division, 1 square root; and one change of sign in the
/// crossed assembly.
///
/// # Errors
/// [`Failure::OutOfReach`] with the margin min(|a| + |b| - d, d - ||a| - |b||), [`Failure::Singular`] if the three
/// joints lie on one line or the ends coincide, [`Failure::NotFinite`].
///
/// ```
/// use kin_core::{Assembly, Plane, solve};
///
/// let c = Plane::new(5.0_f64, 0.0);
/// let (first, four_areas) = solve::circle_circle(3.0, 4.0, c, Assembly::Open)?;
/// let second = c - first;
/// assert!((first.x - 1.8).abs() < 1e-15 && (first.y - 2.4).abs() < 1e-15);
/// assert!((four_areas.value - 24.0).abs() < 1e-14);
/// assert!((first.cross(second) + four_areas.value / 2.0).abs() < 1e-14);
/// # Ok::<(), kin_core::Failure>(())
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn circle_circle<T: Scalar>(a: T, b: T, c: Plane<T>, assembly: Assembly) -> Result<(Plane<T>, Root<T>), Failure> {
    let d2 = c.norm_squared();
    let sum = a + b;
    let difference = a - b;
    let twice_p = d2.plus_product(sum, difference);
    // The product stays the same if one length is negative, because sum and difference are then exchanged.
    let four_q2 = (sum * sum - d2) * (d2 - difference * difference);
    // One of the two squares belongs to the sum of both lengths, whatever their signs.
    let reach2 = || sum * sum + difference * difference;
    let reach = Reach {
        lengths: [a, b],
        four_q2,
        least_four_q2: least(|| reach2() * d2),
        d2,
        least_d2: least(reach2),
    };
    let Some(root) = Root::provided(four_q2, reach, assembly) else {
        return Err(T::refused(|| {
            let c = Plane::new(c.x.real(), c.y.real());
            lengths_do_not_close(a.real(), b.real(), c, T::EPSILON)
        }));
    };
    let half = T::constant(0.5) / d2;
    Ok((beside(c, twice_p * half, root.value * half), root))
}

/// [`circle_circle`] for links whose squared lengths are known, `a2` = |v₁|² and `b2` = |v₂|², as for ternary links.
///
/// 4 q² d⁴ = 4 a² d² - (d² + a² - b²)². It takes 19 operations: 6 additions, 11 multiplications, 1 division, 1 square
/// root; and one change of sign in the crossed assembly.
///
/// # Errors
/// As for [`circle_circle`]. If a square is negative, the links are out of reach by the root of its magnitude.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn circle_circle_squared<T: Scalar>(a2: T, b2: T, c: Plane<T>, assembly: Assembly) -> Result<Plane<T>, Failure> {
    let d2 = c.norm_squared();
    let twice_p = d2 + a2 - b2;
    let four_q2 = T::constant(4.0) * a2 * d2 - twice_p * twice_p;
    // Without the attribute, lanes would call the closure, which is compiled for the narrowest vectors.
    let least_four_q2 = least(
        #[cfg_attr(not(debug_assertions), inline(always))]
        || {
            let terms = [T::constant(4.0) * a2 * d2, twice_p * d2, twice_p * a2, twice_p * b2];
            sum_of_sizes(&terms)
        },
    );
    let reach = ReachOfSquares {
        squares: [a2, b2],
        four_q2,
        least_four_q2,
        d2,
        least_d2: least(|| a2 + b2),
    };
    let Some(root) = Root::provided(four_q2, reach, assembly) else {
        return Err(T::refused(|| {
            let c = Plane::new(c.x.real(), c.y.real());
            squares_do_not_close(a2.real(), b2.real(), c, T::EPSILON)
        }));
    };
    let half = T::constant(0.5) / d2;
    Ok(beside(c, twice_p * half, root.value * half))
}

/// Whether two links of given lengths can span a distance.
#[derive(Clone, Copy)]
struct Reach<T> {
    lengths: [T; 2],
    four_q2: T,
    least_four_q2: T,
    d2: T,
    least_d2: T,
}

impl<T: Scalar> Check<T, 4, 3> for Reach<T> {
    fn name(&self) -> &'static str {
        "reach of two circles"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 4] {
        [self.four_q2, self.least_four_q2, self.d2, self.least_d2]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [q2, least_q2, d2, least_d2]: [R; 4]) -> [R::Truth; 3] {
        let [low, high] = ordinary_from(q2, least_q2, T::SMALLEST_DIVISOR);
        [low, high, d2.is_at_least(least_d2)]
    }

    fn margin(&self) -> T {
        let [margin, _] = shortfall(self.lengths, self.d2.sqrt());
        margin
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn square(&self) -> T {
        self.d2
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shortfall(&self, root: T) -> Option<[T; 2]> {
        Some(shortfall(self.lengths, root))
    }
}

/// Whether two links can span a distance, given the squares of their lengths.
#[derive(Clone, Copy)]
struct ReachOfSquares<T> {
    squares: [T; 2],
    four_q2: T,
    least_four_q2: T,
    d2: T,
    least_d2: T,
}

impl<T: Scalar> Check<T, 4, 3> for ReachOfSquares<T> {
    fn name(&self) -> &'static str {
        "reach of two circles"
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 4] {
        [self.four_q2, self.least_four_q2, self.d2, self.least_d2]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [q2, least_q2, d2, least_d2]: [R; 4]) -> [R::Truth; 3] {
        let [low, high] = ordinary_from(q2, least_q2, T::SMALLEST_DIVISOR);
        [low, high, d2.is_at_least(least_d2)]
    }

    fn margin(&self) -> T {
        let [margin, _] = shortfall(self.squares.map(|square| size(square).sqrt()), self.d2.sqrt());
        margin
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn square(&self) -> T {
        self.d2
    }

    /// A negative square gives NaN.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shortfall(&self, root: T) -> Option<[T; 2]> {
        let [a2, b2] = self.squares;
        Some(shortfall([a2.sqrt(), b2.sqrt()], root))
    }
}

/// The reach of two links, negative if they do not reach: the smaller of |a| + |b| - d and d - ||a| - |b||. The second
/// number is the sum of the three lengths.
#[cfg_attr(not(debug_assertions), inline(always))]
fn shortfall<T: Scalar>(lengths: [T; 2], d: T) -> [T; 2] {
    // `map` is not always inlined.
    let [a, b] = [size(lengths[0]), size(lengths[1])];
    let reach = a + b;
    [smaller(reach - d, d - size(a - b)), reach + d]
}

/// The vector `c (p + i q)`.
#[cfg_attr(not(debug_assertions), inline(always))]
fn beside<T: Scalar>(c: Plane<T>, p: T, q: T) -> Plane<T> {
    Plane::new((c.x * p).minus_product(c.y, q), (c.y * p).plus_product(c.x, q))
}

#[cold]
#[inline(never)]
fn lengths_do_not_close(a: f64, b: f64, c: Plane, epsilon: f64) -> Failure {
    let (a, b, d) = (a.abs(), b.abs(), length(c.x, c.y));
    let reach = a + b;
    // Minimum and maximum ignore NaN; the scale does not.
    let margin = (reach - d).min(d - (a - b).abs());
    refusal(margin, reach + d, epsilon, 0.0, QUANTITY)
}

#[cold]
#[inline(never)]
fn squares_do_not_close(a2: f64, b2: f64, c: Plane, epsilon: f64) -> Failure {
    if !(a2 + b2).is_finite() {
        return Failure::not_finite(QUANTITY);
    }
    let least = a2.min(b2);
    if least < 0.0 {
        return Failure::OutOfReach { margin: -root(-least) };
    }
    lengths_do_not_close(root(a2), root(b2), c, epsilon)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::{circle_circle, circle_circle_squared};
    use crate::assembly::Assembly;
    use crate::failure::Failure;
    use crate::geometry::Plane;
    use crate::solve::strategies::{angle, dimension, direction, norm};

    proptest! {
        #[test]
        fn both_assemblies_close(a in dimension(), b in dimension(), s in angle(), t in angle()) {
            let (u, v) = (direction(s).scale(a), direction(t).scale(b));
            let c = u + v;
            let scale = a + b;
            let (cross, d) = (u.cross(v).abs(), norm(c));
            let condition = scale / f64::min(scale - d, d - (a - b).abs());
            // Otherwise rounding of the distance may carry it over the limit.
            if !(0.0..1e10).contains(&condition) {
                return Ok(());
            }
            let tolerance = 16.0 * f64::EPSILON * (cross / d * condition + scale);
            for assembly in Assembly::BOTH {
                // The squares of the lengths cancel, so rounding in d² + a² - b² reaches q through its square.
                let noise = 2.0 * f64::EPSILON * a * scale.powi(3) / (cross * cross);
                if noise < 1e-2 {
                    let first = circle_circle_squared(a * a, b * b, c, assembly).unwrap();
                    let second = c - first;
                    let tolerance = 16.0 * (cross / d * noise + f64::EPSILON * scale * scale / d);
                    prop_assert!((norm(first) - a).abs() <= tolerance);
                    prop_assert!((norm(second) - b).abs() <= tolerance);
                    prop_assert_eq!(first.cross(second) < 0.0, assembly == Assembly::Open);
                }
                for (a, b) in [(a, b), (-a, b), (a, -b), (-a, -b)] {
                    let (first, four_areas) = circle_circle(a, b, c, assembly).unwrap();
                    let second = c - first;
                    prop_assert_eq!(four_areas.value > 0.0, assembly == Assembly::Open);
                    prop_assert!((four_areas.value.powi(2) / four_areas.square - 1.0).abs() <= 4.0 * f64::EPSILON);
                    prop_assert!((2.0 * c.cross(first) - four_areas.value).abs() <= 4.0 * tolerance * d);
                    prop_assert!((norm(first) - a.abs()).abs() <= tolerance);
                    prop_assert!((norm(second) - b.abs()).abs() <= tolerance);
                    let is_open = first.cross(second) < 0.0;
                    prop_assert_eq!(is_open, assembly == Assembly::Open);
                }
                let original = if u.cross(v) < 0.0 { Assembly::Open } else { Assembly::Crossed };
                if assembly == original {
                    let (first, _) = circle_circle(a, b, c, assembly).unwrap();
                    prop_assert!(norm(first - u) <= tolerance * scale / d);
                }
            }
        }

        #[test]
        fn what_is_out_of_reach_says_by_how_much(
            a in dimension(), b in dimension(), t in angle(), excess in 1e-6..1.0,
        ) {
            let scale: f64 = a + b;
            for d in [scale * (1.0_f64 + excess), (a - b).abs() * (1.0 - excess)] {
                let expected = f64::min(scale - d, d - (a - b).abs());
                if expected >= -1e-12 * scale {
                    return Ok(());
                }
                let c = direction(t).scale(d);
                for result in [
                    circle_circle(a, b, c, Assembly::Open).map(|(first, _)| first),
                    circle_circle_squared(a * a, b * b, c, Assembly::Open),
                ] {
                    match result {
                        Err(Failure::OutOfReach { margin }) =>
                            prop_assert!((margin - expected).abs() <= 1e-14 * scale),
                        other => prop_assert!(false, "{:?}", other),
                    }
                }
            }
        }
    }

    #[test]
    fn exact_limits_are_singular() {
        for assembly in Assembly::BOTH {
            for (a, b, d) in [(3.0, 4.0, 7.0), (7.0, 4.0, 3.0), (2.0, 7.0, 5.0), (0.0, 2.0, 2.0)] {
                let c = Plane::new(0.0, d);
                let singular = Failure::Singular { determinant: 0.0 };
                assert_eq!(circle_circle(a, b, c, assembly), Err(singular));
                assert_eq!(circle_circle_squared(a * a, b * b, c, assembly), Err(singular));
            }
        }
    }

    #[test]
    fn one_unit_in_the_last_place_decides() {
        let inside = Plane::new(7.0_f64.next_down(), 0.0);
        let (first, _) = circle_circle(3.0, 4.0, inside, Assembly::Open).unwrap();
        assert!(first.y > 0.0);
        let outside = Plane::new(7.0_f64.next_up(), 0.0);
        assert!(circle_circle(3.0, 4.0, outside, Assembly::Open).is_err());
        let far = Plane::new(7.0 * (1.0 + 1e-13), 0.0);
        assert!(matches!(
            circle_circle(3.0, 4.0, far, Assembly::Open),
            Err(Failure::OutOfReach { .. })
        ));
    }

    #[test]
    fn coinciding_ends_have_no_direction() {
        // A folded parallelogram, in which the joint may lie anywhere.
        for d in [0.0, 1e-200, 1e-160, 1e-155] {
            let c = Plane::new(d, 0.0);
            assert!(matches!(
                circle_circle(1.0, 1.0, c, Assembly::Open),
                Err(Failure::Singular { .. })
            ));
            assert!(matches!(
                circle_circle_squared(1.0, 1.0, c, Assembly::Open),
                Err(Failure::Singular { .. })
            ));
            assert!(matches!(
                circle_circle(2.0, 1.0, c, Assembly::Open),
                Err(Failure::OutOfReach { .. })
            ));
        }
    }

    #[test]
    fn nothing_that_is_not_finite_comes_out() {
        let odd = [
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            1e200,
            1e-200,
            f64::MAX,
            5e-324,
        ];
        for value in odd {
            for index in 0..4 {
                let mut arguments = [1.0, 1.0, 1.0, 0.5];
                arguments[index] = value;
                let [a, b, x, y] = arguments;
                for assembly in Assembly::BOTH {
                    for result in [
                        circle_circle(a, b, Plane::new(x, y), assembly).map(|(first, _)| first),
                        circle_circle_squared(a, b, Plane::new(x, y), assembly),
                    ] {
                        if let Ok(first) = result {
                            for part in [first.x, first.y, x - first.x, y - first.y] {
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

    #[test]
    fn a_square_may_not_be_negative() {
        assert_eq!(
            circle_circle_squared(-4.0, 1.0, Plane::new(1.0, 1.0), Assembly::Open),
            Err(Failure::OutOfReach { margin: -2.0 })
        );
    }

    #[test]
    fn single_precision_closes_to_single_precision() {
        let c = Plane::new(5.0, 0.0);
        let (first, _) = circle_circle(3.0_f32, 4.0, c, Assembly::Crossed).unwrap();
        assert!((first.x - 1.8).abs() < 1e-6 && (first.y + 2.4).abs() < 1e-6);
        assert_eq!(
            circle_circle(3.0_f32, 4.0, Plane::new(7.0, 0.0), Assembly::Open),
            Err(Failure::Singular { determinant: 0.0 })
        );
    }
}
