//! The constants of the functions in each precision.

use super::arc_tangent::{ARC_TANGENT, HALF_RIGHT_ANGLE};
use super::bits::Binary;
use super::polynomial::polynomial;
use super::sine_cosine::{COSINE, LIMIT, RIGHT_ANGLE, ROUNDING, SINE};

/// A plain number with sine, cosine and arctangent as straight-line code, calculated in its precision.
pub trait Elementary: Binary {
    /// The largest angle that is reduced.
    const LIMIT: Self;

    /// 2/π.
    const QUARTERS_PER_RADIAN: Self;

    /// π/2 as a sum. The products of the first two parts with the number of right angles are exact.
    const RIGHT_ANGLE: [Self; 3];

    /// A number whose addition rounds to an integer and leaves that integer in the lowest bits.
    const ROUNDING: Self;

    /// π/4 as a sum. The product of the first part with a number up to 4 is exact.
    const HALF_RIGHT_ANGLE: [Self; 2];

    /// (r - sin r) / r³ for z = r², |r| ≤ π/4.
    fn sine_series<const FUSED: bool>(z: Self) -> Self;

    /// (cos r - 1 + r²/2) / r⁴ for z = r², |r| ≤ π/4.
    fn cosine_series<const FUSED: bool>(z: Self) -> Self;

    /// (t - atan t) / t³ for z = t², |t| ≤ 1/2.
    fn arc_tangent_series<const FUSED: bool>(z: Self) -> Self;
}

impl Elementary for f64 {
    const LIMIT: Self = LIMIT;
    const QUARTERS_PER_RADIAN: Self = core::f64::consts::FRAC_2_PI;
    const RIGHT_ANGLE: [Self; 3] = RIGHT_ANGLE;
    const ROUNDING: Self = ROUNDING;
    const HALF_RIGHT_ANGLE: [Self; 2] = HALF_RIGHT_ANGLE;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sine_series<const FUSED: bool>(z: Self) -> Self {
        polynomial::<FUSED, 6, f64>(SINE, z)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn cosine_series<const FUSED: bool>(z: Self) -> Self {
        polynomial::<FUSED, 6, f64>(COSINE, z)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn arc_tangent_series<const FUSED: bool>(z: Self) -> Self {
        polynomial::<FUSED, 12, f64>(ARC_TANGENT, z)
    }
}

/// The coefficients were rounded to single precision one after the other, the lowest power first, and the others fitted
/// again each time.
impl Elementary for f32 {
    /// Up to it, the multiple of π/2 has 10 bits.
    const LIMIT: Self = 1000.0;
    const QUARTERS_PER_RADIAN: Self = core::f32::consts::FRAC_2_PI;

    /// π/2 as a sum of 14, 14 and 24 bits. The number up to [`LIMIT`](Self::LIMIT) that is closest to a multiple of π/2
    /// is 4·10⁻⁹ away from it. At that distance the reduced angle has a relative error of 2⁻²².
    const RIGHT_ANGLE: [Self; 3] = [1.570_800_8, -4.454_516e-6, 6.077_100_6e-11];
    const ROUNDING: Self = 12_582_912.0;

    /// π/4 as a multiple of 2⁻²², and the rest.
    const HALF_RIGHT_ANGLE: [Self; 2] = [0.785_398_24, -8.146_034e-8];

    /// The relative error of the sine is 2⁻²⁷·⁹.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sine_series<const FUSED: bool>(z: Self) -> Self {
        polynomial::<FUSED, 3, f32>([0.166_666_55, -0.008_332_189, 0.000_195_182_9], z)
    }

    /// The relative error of the cosine is 2⁻³³.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn cosine_series<const FUSED: bool>(z: Self) -> Self {
        polynomial::<FUSED, 3, f32>([0.041_666_646, -0.001_388_731, 2.443_232_7e-5], z)
    }

    /// The relative error of the arctangent is 2⁻²⁷·⁵.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn arc_tangent_series<const FUSED: bool>(z: Self) -> Self {
        let coefficients = [0.333_332_33, -0.199_941_68, 0.141_742_13, -0.101_558_29, 0.051_251_7];
        polynomial::<FUSED, 5, f32>(coefficients, z)
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};

    use super::Elementary;
    use crate::number::elementary::reference::THINNED;
    use crate::number::elementary::{is_near, near_sine_cosine, ordinary_arc_tangent};
    use crate::number::samples;

    /// The literals stand for the numbers that were fitted: parts of few bits, whose sum is π/2 or π/4.
    #[test]
    fn parts_of_an_angle_have_few_bits_in_single_precision() {
        let [first, second, third] = f32::RIGHT_ANGLE;
        assert_eq!(first * 8192.0, (first * 8192.0).round());
        assert_eq!(second * 2.0_f32.powi(31), (second * 2.0_f32.powi(31)).round());
        assert_eq!(f64::from(first) + f64::from(second) + f64::from(third), FRAC_PI_2);
        let [first, second] = f32::HALF_RIGHT_ANGLE;
        assert_eq!(first * 2.0_f32.powi(22), (first * 2.0_f32.powi(22)).round());
        assert!((f64::from(first) + f64::from(second) - FRAC_PI_4).abs() < 1e-14);
    }

    /// The error in units in the last place of single precision. The expected value has an error of about 1e-9 of
    /// these.
    fn units(found: f32, expected: f64) -> f64 {
        let size = expected.abs().max(f64::from(f32::MIN_POSITIVE));
        // The bits of a double that say which power of two it lies above.
        let power = f64::from_bits(size.to_bits() & (0x7ff << 52));
        (f64::from(found) - expected).abs() / (power * f64::from(f32::EPSILON))
    }

    /// The positive numbers between two, each `step`-th of them.
    fn numbers(range: core::ops::RangeInclusive<f32>, step: u32) -> impl Iterator<Item = f32> {
        let step = step * if THINNED > 1 { 1 << 14 } else { 1 };
        (range.start().to_bits()..=range.end().to_bits())
            .step_by(step as usize)
            .map(f32::from_bits)
    }

    /// The largest errors of sine and cosine.
    fn worst_of(angles: impl Iterator<Item = f32>, sine_cosine: impl Fn(f32) -> (f32, f32)) -> [f64; 2] {
        angles.fold([0.0; 2], |[sine, cosine], angle| {
            let (found, expected) = (sine_cosine(angle), f64::from(angle).sin_cos());
            assert_eq!(sine_cosine(-angle), (-found.0, found.1));
            [
                f64::max(sine, units(found.0, expected.0)),
                f64::max(cosine, units(found.1, expected.1)),
            ]
        })
    }

    /// The numbers next to every multiple of π/2 up to the limit.
    fn near_the_axes() -> impl Iterator<Item = f32> {
        (1_u16..637).flat_map(|quarters| {
            let angle = crate::number::single(f64::from(quarters) * FRAC_PI_2);
            [angle, angle.next_down(), angle.next_up()]
        })
    }

    /// The largest error of the arctangent, at points on rays of all slopes.
    fn angled(step: u32, arc_tangent: impl Fn(f32, f32) -> (f32, bool)) -> f64 {
        let mut worst = 0.0;
        for (index, slope) in (0_u8..=255).cycle().zip(numbers(1e-30..=1.0, step)) {
            // Distances whose products with the slope are rounded, so that the fraction is.
            let x = 1.0 + f32::from(index) / 199.0;
            let y = slope * x;
            for (y, x) in [(y, x), (x, y), (x, -y), (y, -x)] {
                let (found, ordinary) = arc_tangent(y, x);
                assert!(ordinary, "{y:e} {x:e}");
                assert_eq!(arc_tangent(-y, x), (-found, true));
                worst = f64::max(worst, units(found, f64::from(y).atan2(f64::from(x))));
            }
        }
        worst
    }

    /// Every 997th number, or every 9973rd, and all numbers next to multiples of π/2. With `KIN_ALL_SINGLES` every
    /// number is tested, which takes half an hour in a release build.
    #[test]
    fn errors_in_single_precision() {
        let step = if std::env::var_os("KIN_ALL_SINGLES").is_some() {
            1
        } else if samples::are_all() {
            997
        } else {
            9973
        };
        std::println!("largest errors, in units in the last place | multiply-add | multiplication and addition");
        let fused = near_sine_cosine::<true, true, f32>;
        let unfused = near_sine_cosine::<false, false, f32>;
        let range = || numbers(f32::from_bits(1)..=1000.0, step);
        let (axes, unfused_axes) = (worst_of(near_the_axes(), fused), worst_of(near_the_axes(), unfused));
        let (all, unfused_all) = (worst_of(range(), fused), worst_of(range(), unfused));
        for (name, index) in [("sine", 0), ("cosine", 1)] {
            let [fused, unfused] = [all[index].max(axes[index]), unfused_all[index].max(unfused_axes[index])];
            std::println!("{name}, up to 1000 rad | {fused:.2} | {unfused:.2}");
            assert!(fused <= 2.0 && unfused <= 2.0, "{name}: {fused} {unfused}");
        }
        let fused = angled(step, ordinary_arc_tangent::<true, true, f32>);
        let unfused = angled(step, ordinary_arc_tangent::<false, false, f32>);
        std::println!("arctangent | {fused:.2} | {unfused:.2}");
        assert!(fused <= 2.0 && unfused <= 2.0, "arctangent: {fused} {unfused}");
    }

    /// What the polynomials do not cover is reported, and is NaN in lanes.
    #[test]
    fn what_is_out_of_range_is_reported_in_single_precision() {
        for angle in [1000.1, f32::MAX, f32::INFINITY, f32::NAN] {
            assert!(!is_near(angle) && !is_near(-angle));
        }
        let max = f32::MAX;
        for (y, x) in [
            (0.0, 0.0),
            (max, max),
            (f32::INFINITY, 1.0),
            (1.0, f32::NAN),
            (f32::NAN, f32::NAN),
        ] {
            let (angle, ordinary) = ordinary_arc_tangent::<true, true, f32>(y, x);
            assert!(angle.is_nan() && !ordinary, "{y:e} {x:e}");
            assert!(!ordinary_arc_tangent::<false, false, f32>(y, x).1);
        }
    }
}
