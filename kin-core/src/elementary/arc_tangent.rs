//! The angle of a point, by one division.
//!
//! Up to tan(π/8) of one axis the fraction is y / x or -x / y, and between them it is that of the point turned back by
//! π/4, (y - x) / (y + x): in all cases at most tan(π/8). The angle is the corresponding multiple of π/4 and the arctangent
//! of the fraction.

use core::f64::consts::FRAC_PI_4;

use num_traits::Float;

use super::polynomial::polynomial;
use crate::scalar::single;

/// tan(π/8), where one fraction takes over from the other; a little off does no harm.
const EIGHTH: f64 = 0.414_213_562;

/// π/4 as a multiple of 2⁻²⁶, and the rest.
const HALF_RIGHT_ANGLE: [f64; 2] = [0.785_398_155_450_820_9, 7.946_627_386_764_098e-9];

/// Adding and subtracting it rounds to a multiple of 2⁻²⁷.
const ROUNDING: f64 = 50_331_648.0;

/// The sizes for which no product overflows and none loses bits by underflow: 2⁻⁴⁰⁰, 2⁴⁰⁰.
const ORDINARY: [f64; 2] = [3.872_591_914_849_318_3e-121, 2.582_249_878_086_908_6e120];

/// (t - atan t) / t³ in powers of t², |t| ≤ tan(π/8). The relative error of the arctangent is 2⁻⁵⁹·⁴.
const ARC_TANGENT: [f64; 11] = [
    0.333_333_333_333_332,
    -0.199_999_999_999_532_5,
    0.142_857_142_801_666_45,
    -0.111_111_107_821_579_12,
    0.090_908_977_253_045_59,
    -0.076_920_597_179_229_64,
    0.066_630_992_052_098_41,
    -0.058_478_592_586_183_85,
    0.050_391_902_637_713_15,
    -0.038_062_133_684_014_12,
    0.017_905_030_704_074_08,
];

/// As [`ARC_TANGENT`], with a relative error of 2⁻³⁰·⁴.
const ARC_TANGENT_SINGLE: [f64; 5] = [
    0.333_333_151_881_528_6,
    -0.199_984_714_895_870_27,
    0.142_435_328_593_682_66,
    -0.105_938_101_064_083_51,
    0.060_782_121_120_395_69,
];

/// The angle from the x axis to (`x`, `y`), in -π ..= π, with the signs of zeros of IEEE 754.
#[inline(always)]
pub(crate) fn arc_tangent(y: f64, x: f64) -> f64 {
    let (angle, ordinary) = ordinary_arc_tangent(y, x);
    if ordinary { angle } else { beyond(y, x) }
}

/// [`arc_tangent`] without a branch, and whether it holds for this point: not for the origin, for what is not finite, and
/// where a product would overflow or lose bits by underflow.
#[inline(always)]
pub(crate) fn ordinary_arc_tangent(y: f64, x: f64) -> (f64, bool) {
    let (height, width) = (y.abs(), x.abs());
    let turned = Turned::of(height, width);
    let size = turned.along;
    let ordinary = (size >= ORDINARY[0]) & (size <= ORDINARY[1]) & ((height >= width * ORDINARY[0]) | (height == 0.0));

    let side = 1.0_f64.copysign(x);
    let multiple = turned.multiple(side);
    let fraction = side * turned.across / size;

    // The fraction as `short`, a multiple of 2⁻²⁷, and the rest: across - short along is exact to its last few bits, and so is
    // the sum of short and the multiple of π/4.
    let short = (fraction + ROUNDING) - ROUNDING;
    let (cosine, sine) = (side * turned.cosine, side * turned.sine);
    let by_height = cosine - turned.sine * short;
    let by_width = sine + turned.cosine * short;
    let rest = difference_of_products(height, by_height, width, by_width) / size;

    let z = fraction * fraction;
    let small = (multiple * HALF_RIGHT_ANGLE[1] + rest) - (fraction * z) * polynomial(ARC_TANGENT, z);
    let angle = (multiple * HALF_RIGHT_ANGLE[0] + short + small).copysign(y);
    (angle, ordinary)
}

/// [`arc_tangent`] in single precision, computed in double precision.
#[inline(always)]
pub(crate) fn arc_tangent_single(y: f32, x: f32) -> f32 {
    let (height, width) = (f64::from(y).abs(), f64::from(x).abs());
    let turned = Turned::of(height, width);
    let ordinary = turned.along > 0.0 && turned.along < f64::INFINITY;
    if !ordinary {
        return beyond(y, x);
    }
    let fraction = turned.across / turned.along;
    let z = fraction * fraction;
    let angle = fraction - fraction * (z * polynomial(ARC_TANGENT_SINGLE, z));
    let side = 1.0_f64.copysign(f64::from(x));
    let wide = turned.multiple(side) * FRAC_PI_4 + side * angle;
    single(wide).copysign(y)
}

#[cold]
#[inline(never)]
fn beyond<T: Float>(y: T, x: T) -> T {
    y.atan2(x)
}

/// A point of the first quadrant, turned back by a multiple of π/4 to near the x axis, and away from the origin by a
/// factor that does not matter: its product with the complex number `cosine` - i `sine`, each of them 0 or 1.
struct Turned {
    cosine: f64,
    sine: f64,
    along: f64,
    across: f64,
}

impl Turned {
    #[inline(always)]
    fn of(height: f64, width: f64) -> Self {
        let flat = height <= EIGHTH * width;
        let steep = width < EIGHTH * height;
        let cosine = if steep { 0.0 } else { 1.0 };
        let sine = if flat { 0.0 } else { 1.0 };
        // Products and not selections, which would become branches.
        Self {
            cosine,
            sine,
            along: cosine * width + sine * height,
            across: cosine * height - sine * width,
        }
    }

    /// The multiple of π/4 from which the angle counts, forwards from the positive x axis or, where `side` is -1 instead of 1,
    /// back from the negative one.
    #[inline(always)]
    fn multiple(&self, side: f64) -> f64 {
        2.0 - side * (1.0 + self.cosine - self.sine)
    }
}

/// `value` to 25 bits (Veltkamp).
#[inline(always)]
fn upper(value: f64) -> f64 {
    let multiple = value * 268_435_457.0;
    multiple - (multiple - value)
}

/// a u - b v, where u and v have at most 28 bits and the products cancel to some 24 bits: as good as exact.
///
/// Splitting the factors, as Dekker did, *A floating-point technique for extending the available precision* (1971).
#[inline(always)]
fn difference_of_products(a: f64, u: f64, b: f64, v: f64) -> f64 {
    let (upper_a, upper_b) = (upper(a), upper(b));
    (upper_a * u - upper_b * v) + ((a - upper_a) * u - (b - upper_b) * v)
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_4, PI};

    use super::{arc_tangent, arc_tangent_single};
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
                f64::exp2(-390.0 * (f * 977.0).fract()) * (1.0 + f),
                1.0 + (f * 331.0).fract(),
            )
        })
    }

    fn worst(points: impl Iterator<Item = (f64, f64)>) -> f64 {
        points.fold(0.0, |worst, (y, x)| {
            let error = units(arc_tangent(y, x), reference::arc_tangent(y, x), 53, f64::from_bits(1));
            worst.max(error)
        })
    }

    #[test]
    fn errors_are_within_one_unit_in_the_last_place() {
        for error in [worst(around()), worst(near_the_axes()), worst(slight())] {
            assert!(error <= 1.0, "{error}");
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
}
