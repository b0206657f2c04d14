//! The angle of a point, by one division.
//!
//! The lesser and the greater magnitude of the two coordinates give a fraction of at most one half. If lesser / greater
//! is at most one half, that is the fraction. Otherwise the point is rotated back by π/4 and the fraction is (lesser -
//! greater) / (lesser + greater), where the difference is exact. The angle is the corresponding multiple of π/4 plus
//! the arctangent of the fraction.

use core::f64::consts::FRAC_PI_4;

use num_traits::Float;

use super::bits::{Binary, sign_flipped};
use super::polynomial::{FUSED, multiply_add, polynomial};
use super::precision::Elementary;
use crate::number::single;

/// π/4 as a multiple of 2⁻²⁶, and the rest.
pub(crate) const HALF_RIGHT_ANGLE: [f64; 2] = [0.785_398_155_450_820_9, 7.946_627_386_764_098e-9];

/// (t - atan t) / t³ in powers of t², |t| ≤ 1/2. The relative error of the arctangent is 2⁻⁵⁷·⁷.
pub(crate) const ARC_TANGENT: [f64; 12] = [
    0.333_333_333_333_329_8,
    -0.199_999_999_999_031_62,
    0.142_857_142_763_899_88,
    -0.111_111_106_597_945_9,
    0.090_908_962_482_682_56,
    -0.076_920_739_622_134_48,
    0.066_638_110_760_430_19,
    -0.058_583_017_489_826_94,
    0.051_220_173_546_111_08,
    -0.041_865_342_967_284_065,
    0.027_435_396_925_175_61,
    -0.010_117_140_106_919_496,
];

/// The coefficients of [`ARC_TANGENT`] for single precision, with a relative error of 2⁻³¹·⁸.
pub(crate) const ARC_TANGENT_SINGLE: [f64; 6] = [
    0.333_333_269_253_162_3,
    -0.199_994_898_356_003_5,
    0.142_720_783_320_407_6,
    -0.109_409_797_693_969_32,
    0.079_840_521_288_676_07,
    -0.038_723_086_667_584_82,
];

/// The angle from the x axis to (`x`, `y`), in -π ..= π, with the signs of zeros of IEEE 754.
#[inline]
pub(crate) fn arc_tangent(y: f64, x: f64) -> f64 {
    let (angle, ordinary) = ordinary_arc_tangent::<FUSED, false, f64>(y, x);
    if ordinary { angle } else { beyond(y, x) }
}

/// [`arc_tangent`] of two points.
#[inline]
pub(crate) fn arc_tangents(y: [f64; 2], x: [f64; 2]) -> [f64; 2] {
    #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
    if !FUSED {
        let ([first, second], ordinary) = super::sse2::arc_tangents(y, x);
        let (first, second) = if ordinary {
            (first, second)
        } else {
            one_by_one((y[0], x[0]), (y[1], x[1]))
        };
        return [first, second];
    }
    [arc_tangent(y[0], x[0]), arc_tangent(y[1], x[1])]
}

/// The angles of two points, one after the other. Points and angles are pairs because pairs stay in registers; arrays
/// would be stored to memory for this call, even when it is not made.
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
#[cold]
#[inline(never)]
fn one_by_one(first: (f64, f64), second: (f64, f64)) -> (f64, f64) {
    (arc_tangent(first.0, first.1), arc_tangent(second.0, second.1))
}

/// [`one_by_one`] in single precision.
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
#[cold]
#[inline(never)]
fn singles_one_by_one(first: (f32, f32), second: (f32, f32)) -> (f32, f32) {
    (
        arc_tangent_single(first.0, first.1),
        arc_tangent_single(second.0, second.1),
    )
}

/// [`arc_tangent`] without a branch, and whether the result is valid. It is not valid for the origin, for coordinates
/// that are not finite, and for coordinates whose sum overflows.
///
/// With `SELECT` a condition selects, a sign is a bit, and an invalid angle is NaN.
#[expect(clippy::eq_op, reason = "infinity minus itself is NaN")]
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn ordinary_arc_tangent<const FUSED: bool, const SELECT: bool, E: Elementary>(y: E, x: E) -> (E, bool) {
    let folded = Folded::<SELECT, E>::of(y, x);
    let fraction = folded.across / folded.along;
    let ordinary = folded.has(fraction);
    let z = fraction * fraction;
    let fraction = folded.sense.on(fraction);
    let low = if SELECT {
        // The last operand is zero, or NaN if a coordinate is too large.
        multiply_add::<FUSED, E>(folded.multiple, E::HALF_RIGHT_ANGLE[1], folded.along - folded.along)
    } else {
        folded.multiple * E::HALF_RIGHT_ANGLE[1]
    };
    let rest = multiply_add::<FUSED, E>(-(fraction * z), E::arc_tangent_series::<FUSED>(z), low);
    let angle = multiply_add::<FUSED, E>(folded.multiple, E::HALF_RIGHT_ANGLE[0], fraction + rest);
    (angle.signed_as(y), ordinary)
}

/// [`arc_tangent`] in single precision, computed in double precision.
#[inline]
pub(crate) fn arc_tangent_single(y: f32, x: f32) -> f32 {
    let folded = Folded::<false, f64>::of(f64::from(y), f64::from(x));
    let fraction = folded.across / folded.along;
    if !folded.has(fraction) {
        return beyond(y, x);
    }
    let z = fraction * fraction;
    let angle = fraction - fraction * (z * polynomial::<FUSED, 6, f64>(ARC_TANGENT_SINGLE, z));
    let wide = folded.multiple * FRAC_PI_4 + folded.sense.on(angle);
    single(wide).copysign(y)
}

/// [`arc_tangent_single`] of two points.
#[inline]
pub(crate) fn arc_tangents_single(y: [f32; 2], x: [f32; 2]) -> [f32; 2] {
    #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
    if !FUSED {
        let ([first, second], ordinary) = super::sse2::arc_tangents_single(y, x);
        let (first, second) = if ordinary {
            (first, second)
        } else {
            singles_one_by_one((y[0], x[0]), (y[1], x[1]))
        };
        return [first, second];
    }
    [arc_tangent_single(y[0], x[0]), arc_tangent_single(y[1], x[1])]
}

#[cold]
#[inline(never)]
fn beyond<T: Float>(y: T, x: T) -> T {
    y.atan2(x)
}

/// A point that has been rotated and mirrored close to the positive x axis. Its distance from the origin changes by a
/// factor that does not matter.
struct Folded<const SELECT: bool, E> {
    across: E,
    along: E,
    /// Whether the angle counts forwards or backwards.
    sense: Sign<SELECT, E>,
    /// The multiple of π/4 from which the angle counts, if the point itself is above the x axis.
    multiple: E,
}

impl<const SELECT: bool, E: Binary> Folded<SELECT, E> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of(y: E, x: E) -> Self {
        let (one, two) = (E::one(), E::from_single(2.0));
        let (height, width) = (y.size(), x.size());
        let greater = if height > width { height } else { width };
        let lesser = if height > width { width } else { height };
        let slanting = Selection::<SELECT, E>::new(lesser > greater - lesser);
        let (side, steepness) = (Sign::of(x), Sign::of(width - height));
        let sense = side.times(steepness);
        // The multiple is 0, 2 or 4 at the nearest axis, and 1 or 3 at a diagonal.
        let multiple = if SELECT {
            two - side.on(one + slanting.unless(steepness.on(one)))
        } else {
            (two - side.0) - slanting.unless(sense.0)
        };
        Self {
            across: lesser - slanting.then(greater),
            along: greater + slanting.then(lesser),
            sense,
            multiple,
        }
    }

    /// Whether this fraction of the two coordinates is valid: neither 0/0 nor a fraction of infinities.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn has(&self, fraction: E) -> bool {
        !(self.along * fraction).is_nan()
    }
}

/// A condition that selects between a number and zero. With `SELECT` it is a real selection. Otherwise it is a factor,
/// because a condition that selects several numbers would become a branch.
#[derive(Clone, Copy)]
struct Selection<const SELECT: bool, E> {
    holds: bool,
    /// The factor 1 if the condition holds, 0 if it does not.
    factor: E,
}

impl<const SELECT: bool, E: Float> Selection<SELECT, E> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn new(holds: bool) -> Self {
        let factor = if holds { E::one() } else { E::zero() };
        Self { holds, factor }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn then(self, number: E) -> E {
        if !SELECT {
            self.factor * number
        } else if self.holds {
            number
        } else {
            E::zero()
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn unless(self, number: E) -> E {
        if !SELECT {
            (E::one() - self.factor) * number
        } else if self.holds {
            E::zero()
        } else {
            number
        }
    }
}

/// A sign. With `SELECT` it is the sign of the stored number. Otherwise the stored number is ±1 and serves as a factor,
/// because bit operations would move numbers out of the floating-point registers and back.
#[derive(Clone, Copy)]
struct Sign<const SELECT: bool, E>(E);

impl<const SELECT: bool, E: Binary> Sign<SELECT, E> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of(number: E) -> Self {
        Self(if SELECT { number } else { E::one().signed_as(number) })
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn times(self, other: Self) -> Self {
        Self(if SELECT {
            E::of_bits(self.0.bits() ^ other.0.bits())
        } else {
            self.0 * other.0
        })
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn on(self, number: E) -> E {
        if SELECT {
            sign_flipped(number, self.0.bits())
        } else {
            self.0 * number
        }
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_4, PI};

    use super::{arc_tangent, arc_tangent_single, arc_tangents, arc_tangents_single, ordinary_arc_tangent};
    use crate::number::{
        elementary::reference::{self, fractions, units},
        single,
    };

    /// Points at an angle of -π ..= π and at distances of many sizes.
    fn around() -> impl Iterator<Item = (f64, f64)> {
        fractions(200_000).enumerate().map(|(index, f)| {
            let (sine, cosine) = ((2.0 * f - 1.0) * PI).sin_cos();
            let size = f64::exp2(300.0 * (2.0 * (f * 977.0).fract() - 1.0) * f64::from(index % 2 == 0));
            (size * sine, size * cosine)
        })
    }

    /// Points next to the axes, to the diagonals, and to the points where the fraction changes.
    fn near_the_axes() -> impl Iterator<Item = (f64, f64)> {
        (0..16).flat_map(|eighth| {
            fractions(5_000).flat_map(move |f| {
                let off = f64::exp2(-80.0 * f);
                [off, -off].map(|off| {
                    let (sine, cosine) = (f64::from(eighth) * FRAC_PI_4 / 2.0).sin_cos();
                    // Points exactly on the axes, without the rounding error of π.
                    let exact = |x: f64| if x.abs() < 1e-15 { 0.0 } else { x };
                    let (sine, cosine) = (exact(sine), exact(cosine));
                    (sine + off * cosine, cosine - off * sine)
                })
            })
        })
    }

    /// Points near the positive x axis, where the angle is small.
    fn slight() -> impl Iterator<Item = (f64, f64)> {
        fractions(50_000).map(|f| {
            (
                f64::exp2(-900.0 * (f * 977.0).fract()) * (1.0 + f),
                1.0 + (f * 331.0).fract(),
            )
        })
    }

    fn worst(points: impl Iterator<Item = (f64, f64)>, arc_tangent: impl Fn(f64, f64) -> f64) -> f64 {
        points.fold(0.0, |worst, (y, x)| {
            let error = units(arc_tangent(y, x), reference::arc_tangent(y, x), 53, f64::from_bits(1));
            worst.max(error)
        })
    }

    #[test]
    fn errors_are_within_one_and_a_half_units_in_the_last_place() {
        let fused = |y, x| ordinary_arc_tangent::<true, true, f64>(y, x).0;
        let unfused = |y, x| ordinary_arc_tangent::<false, true, f64>(y, x).0;
        for error in [
            worst(around(), arc_tangent),
            worst(near_the_axes(), arc_tangent),
            worst(slight(), arc_tangent),
            worst(around(), fused),
            worst(near_the_axes(), fused),
            worst(slight(), fused),
            worst(around(), unfused),
            worst(near_the_axes(), unfused),
            worst(slight(), unfused),
        ] {
            assert!(error <= 1.5, "{error}");
        }
    }

    /// The results without fusion in scalar code, without fusion in lanes, and with fusion in lanes.
    fn all(y: f64, x: f64) -> [(f64, bool); 3] {
        [
            ordinary_arc_tangent::<false, false, f64>(y, x),
            ordinary_arc_tangent::<false, true, f64>(y, x),
            ordinary_arc_tangent::<true, true, f64>(y, x),
        ]
    }

    #[test]
    fn without_a_branch_nothing_comes_of_what_is_no_number() {
        for other in [0.0, -1.0, 1e-320, f64::MAX, f64::INFINITY, f64::NAN] {
            for (y, x) in [(f64::NAN, other), (other, f64::NAN)] {
                for (angle, ordinary) in all(y, x) {
                    assert!(angle.is_nan() && !ordinary, "{y:e} {x:e}");
                }
            }
        }
    }

    #[test]
    fn what_is_not_ordinary_is_reported_and_is_nan_in_lanes() {
        let max = f64::MAX;
        let infinite = f64::INFINITY;
        for (y, x) in [
            (0.0, 0.0),
            (max, max),
            (-max, 0.6 * max),
            (infinite, infinite),
            (1.0, infinite),
            (infinite, 1.0),
            (0.0, infinite),
        ] {
            for (y, x) in [(y, x), (y, -x), (-y, x)] {
                let [alone, lanes @ ..] = all(y, x);
                assert!(!alone.1, "{y:e} {x:e}");
                for (angle, ordinary) in lanes {
                    assert!(angle.is_nan() && !ordinary, "{y:e} {x:e}");
                }
            }
        }
    }

    #[test]
    fn the_smallest_and_the_largest_points_are_ordinary() {
        for size in [5e-324, 3e-320, 1e-308, 1e-300, 1e300, 0.4 * f64::MAX] {
            for (y, x) in [
                (size, size),
                (-size, size),
                (size, 0.0),
                (0.0, -size),
                (size, -2.0 * size),
            ] {
                let scale = f64::exp2(if size < 1.0 { 600.0 } else { -600.0 });
                let expected = reference::arc_tangent(scale * y, scale * x);
                for (angle, ordinary) in all(y, x) {
                    let error = units(angle, expected, 53, f64::from_bits(1));
                    assert!(ordinary && error <= 1.5, "{y:e} {x:e}: {angle:e}");
                }
            }
        }
    }

    #[test]
    fn single_precision_is_rounded_from_more() {
        for (y, x) in around().chain(near_the_axes()).chain(slight()) {
            let (y, x) = (single(y), single(x));
            if (x == 0.0 && y == 0.0) || !(x.is_finite() && y.is_finite()) {
                continue;
            }
            let found = f64::from(arc_tangent_single(y, x));
            let expected = reference::arc_tangent(f64::from(y), f64::from(x));
            let error = units(found, expected, 24, f64::from(f32::from_bits(1)));
            assert!(error <= 0.6, "atan2({y:e}, {x:e}) is off by {error} units");
        }
    }

    #[test]
    fn special_values_are_those_of_the_library() {
        let sizes = [
            0.0,
            f64::from_bits(1),
            f64::MIN_POSITIVE,
            1e-150,
            1.0,
            1e150,
            f64::MAX,
            f64::INFINITY,
            f64::NAN,
        ];
        let values = || sizes.into_iter().flat_map(|size| [size, -size]);
        for (y, x) in values().flat_map(|y| values().map(move |x| (y, x))) {
            let (found, expected) = (arc_tangent(y, x), y.atan2(x));
            assert_eq!(
                found.to_bits(),
                expected.to_bits(),
                "{y:e} {x:e}: {found:e} {expected:e}"
            );
            let (y, x) = (single(y), single(x));
            let (found, expected) = (arc_tangent_single(y, x), y.atan2(x));
            assert_eq!(
                found.to_bits(),
                expected.to_bits(),
                "{y:e} {x:e}: {found:e} {expected:e}"
            );
        }
    }

    #[test]
    fn signs_turn_the_angle_round() {
        for (y, x) in around() {
            assert_eq!(arc_tangent(-y, x), -arc_tangent(y, x));
        }
    }

    /// The angle of each point is independent of the other point, to the last bit.
    #[test]
    fn each_of_two_points_has_its_own_angle() {
        let sizes = [0.0, f64::from_bits(1), 1.0, 3.0, f64::MAX, f64::INFINITY];
        let values = || sizes.into_iter().flat_map(|size| [size, -size]);
        let points = || values().flat_map(|y| values().map(move |x| (y, x)));
        for (first, second) in points().zip(points().skip(5)).chain(points().zip(points().skip(71))) {
            let found = arc_tangents([first.0, second.0], [first.1, second.1]);
            let expected = [arc_tangent(first.0, first.1), arc_tangent(second.0, second.1)];
            assert_eq!(
                found.map(f64::to_bits),
                expected.map(f64::to_bits),
                "{first:?} {second:?}"
            );

            let [y, x] = [[first.0, second.0], [first.1, second.1]].map(|pair| pair.map(single));
            let found = arc_tangents_single(y, x);
            let expected = [arc_tangent_single(y[0], x[0]), arc_tangent_single(y[1], x[1])];
            assert_eq!(found.map(f32::to_bits), expected.map(f32::to_bits), "{y:?} {x:?}");
        }
    }
}
