//! The angle of a point, by one division.
//!
//! Of the two coordinates' magnitudes, the fraction is the lesser by the greater up to a half, and beyond that of the point turned
//! back by π/4, (lesser - greater) / (lesser + greater), where the difference is exact: in both cases at most a half. The angle is the
//! corresponding multiple of π/4 and the arctangent of the fraction.

use core::f64::consts::FRAC_PI_4;

use num_traits::Float;

use super::polynomial::{FUSED, multiply_add, polynomial};
use crate::scalar::single;

/// π/4 as a multiple of 2⁻²⁶, and the rest.
const HALF_RIGHT_ANGLE: [f64; 2] = [0.785_398_155_450_820_9, 7.946_627_386_764_098e-9];

/// The sizes for which no sum overflows, with room to spare: 2⁻¹⁰⁰⁰, 2¹⁰⁰⁰.
const ORDINARY: [f64; 2] = [9.332_636_185_032_189e-302, 1.071_508_607_186_267_3e301];

/// (t - atan t) / t³ in powers of t², |t| ≤ 1/2. The relative error of the arctangent is 2⁻⁵⁷·⁷.
const ARC_TANGENT: [f64; 12] = [
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

/// As [`ARC_TANGENT`], with a relative error of 2⁻³¹·⁸.
const ARC_TANGENT_SINGLE: [f64; 6] = [
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
    let (angle, ordinary) = ordinary_arc_tangent::<FUSED>(y, x);
    if ordinary { angle } else { beyond(y, x) }
}

/// [`arc_tangent`] without a branch, and whether it holds for this point: not for the origin, for what is not finite, and
/// for what is so far out or so near to the origin that it is next to them. Of what is not a number there is no angle that is one.
#[inline(always)]
pub(crate) fn ordinary_arc_tangent<const FUSED: bool>(y: f64, x: f64) -> (f64, bool) {
    let turned = Turned::of::<FUSED>(y, x);
    let ordinary = (ORDINARY[0]..=ORDINARY[1]).contains(&turned.along);
    let fraction = turned.across / turned.along;
    let z = fraction * fraction;
    let fraction = turned.sense * fraction;
    let cubed = fraction * z;
    let rest = multiply_add::<FUSED>(
        -cubed,
        polynomial::<FUSED, 12>(ARC_TANGENT, z),
        turned.multiple * HALF_RIGHT_ANGLE[1],
    );
    let angle = multiply_add::<FUSED>(turned.multiple, HALF_RIGHT_ANGLE[0], fraction + rest);
    (angle.copysign(y), ordinary)
}

/// [`arc_tangent`] in single precision, computed in double precision.
#[inline]
pub(crate) fn arc_tangent_single(y: f32, x: f32) -> f32 {
    let turned = Turned::of::<FUSED>(f64::from(y), f64::from(x));
    let ordinary = turned.along >= ORDINARY[0] && turned.along <= ORDINARY[1];
    if !ordinary {
        return beyond(y, x);
    }
    let fraction = turned.across / turned.along;
    let z = fraction * fraction;
    let angle = fraction - fraction * (z * polynomial::<FUSED, 6>(ARC_TANGENT_SINGLE, z));
    let wide = turned.multiple * FRAC_PI_4 + turned.sense * angle;
    single(wide).copysign(y)
}

#[cold]
#[inline(never)]
fn beyond<T: Float>(y: T, x: T) -> T {
    y.atan2(x)
}

/// A point turned and mirrored to next to the positive x axis, and away from the origin by a factor that does not matter.
struct Turned {
    across: f64,
    along: f64,
    /// 1 or, where the angle counts backwards, -1.
    sense: f64,
    /// The multiple of π/4 from which it counts, if the point itself is above the x axis.
    multiple: f64,
}

impl Turned {
    #[inline(always)]
    fn of<const FUSED: bool>(y: f64, x: f64) -> Self {
        let (height, width) = (y.abs(), x.abs());
        let greater = if height > width { height } else { width };
        let lesser = if height > width { width } else { height };
        // A factor and not a selection: where one condition selects several numbers, it becomes a branch.
        let slanting = if lesser > 0.5 * greater { 1.0 } else { 0.0 };
        let side = 1.0_f64.copysign(x);
        let sense = side * 1.0_f64.copysign(width - height);
        Self {
            across: multiply_add::<FUSED>(-slanting, greater, lesser),
            along: multiply_add::<FUSED>(slanting, lesser, greater),
            sense,
            // 0, 2 or 4 from the nearest axis; and the diagonal before or after it
            multiple: (2.0 - side) - sense * (1.0 - slanting),
        }
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_4, PI};

    use super::{arc_tangent, arc_tangent_single, ordinary_arc_tangent};
    use crate::elementary::reference::{self, fractions, units};
    use crate::scalar::single;

    /// Points at an angle of -π ..= π and at distances of many sizes.
    fn around() -> impl Iterator<Item = (f64, f64)> {
        fractions(200_000).enumerate().map(|(index, f)| {
            let (sine, cosine) = ((2.0 * f - 1.0) * PI).sin_cos();
            let size = f64::exp2(300.0 * (2.0 * (f * 977.0).fract() - 1.0) * f64::from(index % 2 == 0));
            (size * sine, size * cosine)
        })
    }

    /// Points next to the axes and the diagonals, and next to where the fraction changes.
    fn near_the_axes() -> impl Iterator<Item = (f64, f64)> {
        (0..16).flat_map(|eighth| {
            fractions(5_000).flat_map(move |f| {
                let off = f64::exp2(-80.0 * f);
                [off, -off].map(|off| {
                    let (sine, cosine) = (f64::from(eighth) * FRAC_PI_4 / 2.0).sin_cos();
                    // On the axes themselves, not the rounding error of π.
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
        let fused = |y, x| ordinary_arc_tangent::<true>(y, x).0;
        for error in [
            worst(around(), arc_tangent),
            worst(near_the_axes(), arc_tangent),
            worst(slight(), arc_tangent),
            worst(around(), fused),
            worst(near_the_axes(), fused),
            worst(slight(), fused),
        ] {
            assert!(error <= 1.5, "{error}");
        }
    }

    #[test]
    fn without_a_branch_nothing_comes_of_what_is_no_number() {
        for other in [0.0, -1.0, 1e-320, f64::MAX, f64::INFINITY, f64::NAN] {
            for (y, x) in [(f64::NAN, other), (other, f64::NAN)] {
                for (angle, ordinary) in [ordinary_arc_tangent::<false>(y, x), ordinary_arc_tangent::<true>(y, x)] {
                    assert!(angle.is_nan() && !ordinary, "{y:e} {x:e}");
                }
            }
        }
    }

    #[test]
    fn what_is_not_ordinary_is_told() {
        for size in [0.0, 1e-320, 1e-305, 1e305, f64::MAX, f64::INFINITY] {
            for (y, x) in [(size, size), (-size, size), (size, 0.0), (0.0, -size)] {
                assert!(!ordinary_arc_tangent::<false>(y, x).1, "{y:e} {x:e}");
            }
        }
        assert!(ordinary_arc_tangent::<false>(1e-320, 1.0).1);
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
}
