//! Sine and cosine together.

use num_traits::{Float, One, WrappingAdd, WrappingNeg, Zero};

use super::bits::{Binary, sign_flipped};
use super::polynomial::{FUSED, multiply_add, polynomial};
use super::precision::Elementary;
use crate::number::single;

/// The largest angle reduced here. Up to it, the multiple of π/2 has 16 bits and its products with [`RIGHT_ANGLE`] are
/// exact: 2¹⁶ π/2 = 102943.
pub(crate) const LIMIT: f64 = 1e5;

/// π/2 as a sum of 37, 37 and 53 bits, for the reduction in parts of Cody and Waite, *Software Manual for the
/// Elementary Functions* (1980).
///
/// No double up to [`LIMIT`] is closer to a multiple of π/2 than 6·10⁻¹⁹. At that distance the reduced angle has a
/// relative error of 2⁻⁶³.
pub(crate) const RIGHT_ANGLE: [f64; 3] = [
    1.570_796_326_792_333_3,
    2.563_344_151_583_955_8e-12,
    1.056_299_906_698_742_8e-23,
];

/// A number whose addition rounds to an integer and leaves that integer in the lowest bits.
pub(crate) const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// (r - sin r) / r³ in powers of r², |r| ≤ π/4. The relative error of the sine is 2⁻⁵⁷·⁹.
pub(crate) const SINE: [f64; 6] = [
    0.166_666_666_666_666_3,
    -0.008_333_333_333_322_118,
    0.000_198_412_698_295_891_21,
    -2.755_731_362_125_163_3e-6,
    2.505_074_774_278_626e-8,
    -1.589_622_902_741_217_6e-10,
];

/// (cos r - 1 + r²/2) / r⁴ in powers of r², |r| ≤ π/4. The relative error of the cosine is 2⁻⁶³·⁹.
pub(crate) const COSINE: [f64; 6] = [
    0.041_666_666_666_666_595,
    -0.001_388_888_888_887_305_6,
    2.480_158_728_885_143_6e-5,
    -2.755_731_417_922_292e-7,
    2.087_570_083_222_872_3e-9,
    -1.135_853_602_718_916_5e-11,
];

/// The coefficients of [`SINE`] for single precision, with a relative error of 2⁻³⁷·⁵.
pub(crate) const SINE_SINGLE: [f64; 4] = [
    0.166_666_666_407_964_6,
    -0.008_333_329_304_745_389,
    0.000_198_393_122_371_727_66,
    -2.718_121_328_822_166e-6,
];

/// The coefficients of [`COSINE`] for single precision, with a relative error of 2⁻³³.
pub(crate) const COSINE_SINGLE: [f64; 3] = [
    0.041_666_645_682_931_17,
    -0.001_388_731_625_073_425_1,
    2.443_315_653_731_113_7e-5,
];

/// The sine and cosine of an angle in radians, in this order.
#[inline]
pub(crate) fn sine_cosine(angle: f64) -> (f64, f64) {
    if !is_near(angle) {
        return far(angle);
    }
    #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
    if !FUSED {
        return super::sse2::sine_cosine(angle);
    }
    near_sine_cosine::<FUSED, false, f64>(angle)
}

/// [`sine_cosine`] in single precision, computed in double precision.
#[inline]
pub(crate) fn sine_cosine_single(angle: f32) -> (f32, f32) {
    let wide = f64::from(angle);
    if !is_near(wide) {
        return far(angle);
    }
    #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
    if !FUSED {
        return super::sse2::sine_cosine_single(wide);
    }
    let (sine, cosine) = near_single(wide);
    (single(sine), single(cosine))
}

#[cold]
#[inline(never)]
fn far<T: Float>(angle: T) -> (T, T) {
    angle.sin_cos()
}

/// Whether [`near_sine_cosine`] accepts this angle: the angle is finite and not large.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn is_near<E: Elementary>(angle: E) -> bool {
    angle.size() <= E::LIMIT
}

/// [`sine_cosine`] of an angle that [is near](is_near), without a branch: by products, or with `SELECT` by selection.
/// Both results are NaN if the angle is NaN.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn near_sine_cosine<const FUSED: bool, const SELECT: bool, E: Elementary>(angle: E) -> (E, E) {
    let (one, half) = (E::one(), E::from_single(0.5));
    let Reduced { r, tail, shifted } = Reduced::new::<FUSED>(angle);
    let z = r * r;
    // The subtracted number is a positive zero where the angle is zero, so the sine keeps the sign of the angle. The
    // cosine can ignore the tail, which is less than half a unit in the last place of the angle.
    let sine = r - multiply_add::<FUSED, E>(r * z, E::sine_series::<FUSED>(z), tail);
    let quartic = E::cosine_series::<FUSED>(z);
    let cosine = if FUSED {
        multiply_add::<FUSED, E>(-z, multiply_add::<FUSED, E>(-z, quartic, half), one)
    } else {
        // Half of the square is exact. A product with a difference would be rounded once more.
        one - (half * z - z * z * quartic)
    };
    if SELECT {
        in_quadrant_by_selection(shifted, sine, cosine)
    } else {
        in_quadrant::<FUSED, E>(shifted, sine, cosine)
    }
}

/// An angle minus the nearest whole number of right angles.
pub(super) struct Reduced<E> {
    pub(super) r: E,
    /// The amount by which r is too large.
    pub(super) tail: E,
    /// The number of right angles, in the lowest bits.
    pub(super) shifted: E,
}

impl<E: Elementary> Reduced<E> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new<const FUSED: bool>(angle: E) -> Self {
        let shifted = multiply_add::<FUSED, E>(angle, E::QUARTERS_PER_RADIAN, E::ROUNDING);
        let right_angles = shifted - E::ROUNDING;
        // The first difference is exact. The tail receives what the second one loses.
        let first = multiply_add::<FUSED, E>(-right_angles, E::RIGHT_ANGLE[0], angle);
        let second = right_angles * E::RIGHT_ANGLE[1];
        let r = first - second;
        let tail = multiply_add::<FUSED, E>(right_angles, E::RIGHT_ANGLE[2], second - (first - r));
        Self { r, tail, shifted }
    }
}

/// [`Reduced`] for an angle of single precision, which needs no tail.
pub(super) struct ReducedSingle {
    pub(super) r: f64,
    /// The number of right angles, in the lowest bits.
    pub(super) shifted: f64,
}

impl ReducedSingle {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new<const FUSED: bool>(angle: f64) -> Self {
        let shifted = multiply_add::<FUSED, f64>(angle, core::f64::consts::FRAC_2_PI, ROUNDING);
        let right_angles = shifted - ROUNDING;
        let r = (angle - right_angles * RIGHT_ANGLE[0]) - right_angles * RIGHT_ANGLE[1];
        Self { r, shifted }
    }
}

#[inline]
fn near_single(angle: f64) -> (f64, f64) {
    let ReducedSingle { r, shifted } = ReducedSingle::new::<FUSED>(angle);
    let z = r * r;
    let sine = r * (1.0 - z * polynomial::<FUSED, 4, f64>(SINE_SINGLE, z));
    let cosine = (1.0 - 0.5 * z) + z * z * polynomial::<FUSED, 3, f64>(COSINE_SINGLE, z);
    in_quadrant::<FUSED, f64>(shifted, sine, cosine)
}

/// The sine and cosine of the reduced angle, rotated by the number of right angles in the lowest bits of `shifted`.
///
/// The rotation is a product with the sine and cosine of these right angles, which are 0 or ±1, so nothing is rounded.
/// Exchanging the two numbers would move them out of the floating-point registers and back.
#[cfg_attr(not(debug_assertions), inline(always))]
fn in_quadrant<const FUSED: bool, E: Binary>(shifted: E, sine: E, cosine: E) -> (E, E) {
    let quarters = shifted.bits();
    let (lowest, highest) = (quarters & E::Bits::one(), E::FROM_SECOND_TO_SIGN);
    let odd = lowest.wrapping_neg();
    let along = E::of_bits((!odd & E::ONE) | (quarters << highest & E::SIGN));
    // A negative zero if there is no rotation, because that keeps the sign of a sine that is zero.
    let before = quarters.wrapping_add(&!E::Bits::zero());
    let across = E::of_bits((odd & E::ONE) | (before << highest & E::SIGN));
    (
        multiply_add::<FUSED, E>(sine, along, cosine * across),
        multiply_add::<FUSED, E>(cosine, along, -(sine * across)),
    )
}

/// [`in_quadrant`] with `SELECT`: selection exchanges the two numbers, and signs are flipped as bits.
#[cfg_attr(not(debug_assertions), inline(always))]
fn in_quadrant_by_selection<E: Binary>(shifted: E, sine: E, cosine: E) -> (E, E) {
    let quarters = shifted.bits();
    let (one, highest) = (E::Bits::one(), E::FROM_SECOND_TO_SIGN);
    let odd = quarters & one != E::Bits::zero();
    (
        sign_flipped(if odd { cosine } else { sine }, quarters << highest),
        sign_flipped(if odd { sine } else { cosine }, quarters.wrapping_add(&one) << highest),
    )
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use super::{LIMIT, is_near, near_sine_cosine, sine_cosine, sine_cosine_single};
    use crate::number::{
        elementary::reference::{self, THINNED, fractions, units},
        single,
    };

    /// The largest errors of sine and cosine, in units in the last place.
    fn worst(angles: impl Iterator<Item = f64>, sine_cosine: impl Fn(f64) -> (f64, f64)) -> [f64; 2] {
        angles.fold([0.0; 2], |worst, angle| {
            let found = sine_cosine(angle);
            let [sine, cosine] = reference::sine_cosine(angle);
            let tiny = f64::from_bits(1);
            [
                worst[0].max(units(found.0, sine, 53, tiny)),
                worst[1].max(units(found.1, cosine, 53, tiny)),
            ]
        })
    }

    fn worst_single(angles: impl Iterator<Item = f64>) -> f64 {
        angles.fold(0.0, |worst, angle| {
            let angle = single(angle);
            let found = sine_cosine_single(angle);
            let [sine, cosine] = reference::sine_cosine(f64::from(angle));
            let tiny = f64::from(f32::from_bits(1));
            let errors = [
                units(f64::from(found.0), sine, 24, tiny),
                units(f64::from(found.1), cosine, 24, tiny),
            ];
            errors.into_iter().fold(worst, f64::max)
        })
    }

    /// The doubles next to every multiple of π/2 up to the limit, or next to every `step`-th multiple.
    fn near_the_axes(step: usize) -> impl Iterator<Item = f64> {
        (1_u32..63_662).step_by(step * THINNED as usize).flat_map(|quarters| {
            // The third part of π/2 is too small to change the nearest double.
            let angle = f64::from(quarters) * FRAC_PI_2;
            [angle, angle.next_down(), angle.next_up(), -angle]
        })
    }

    #[test]
    fn errors_are_within_one_and_a_third_units_in_the_last_place() {
        const COUNT: u32 = 50_000;
        let angles = || fractions(COUNT).map(|f| (2.0 * f - 1.0) * PI);
        let quarter = || fractions(COUNT).map(|f| (2.0 * f - 1.0) * PI / 4.0);
        let range = || fractions(COUNT).map(|f| (2.0 * f - 1.0) * LIMIT);
        let tiny = || fractions(10_000).map(|f| f64::exp2(-1074.0 * f));
        let fused = near_sine_cosine::<true, true, f64>;
        for [sine, cosine] in [
            worst(angles(), sine_cosine),
            worst(quarter(), sine_cosine),
            worst(range(), sine_cosine),
            worst(tiny(), sine_cosine),
            worst(near_the_axes(1), sine_cosine),
            worst(angles(), fused),
            worst(range(), fused),
            worst(tiny(), fused),
            worst(near_the_axes(7), fused),
        ] {
            assert!(sine <= 4.0 / 3.0 && cosine <= 4.0 / 3.0, "{sine} {cosine}");
        }
    }

    #[test]
    fn without_a_branch_nothing_comes_of_what_is_no_number() {
        for angle in [f64::NAN, -f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert!(!is_near(angle));
            for (sine, cosine) in [
                near_sine_cosine::<false, true, f64>(angle),
                near_sine_cosine::<true, true, f64>(angle),
            ] {
                assert!(sine.is_nan() && cosine.is_nan());
            }
        }
    }

    #[test]
    fn single_precision_is_rounded_from_more() {
        const COUNT: u32 = 50_000;
        let angles = fractions(COUNT).map(|f| (2.0 * f - 1.0) * PI);
        let range = fractions(COUNT).map(|f| (2.0 * f - 1.0) * LIMIT);
        let tiny = fractions(10_000).map(|f| f64::exp2(-149.0 * f));
        for error in [
            worst_single(angles),
            worst_single(range),
            worst_single(tiny),
            worst_single(near_the_axes(1)),
        ] {
            assert!(error <= 0.6, "{error}");
        }
    }

    #[test]
    fn special_values_are_those_of_the_library() {
        let far = [LIMIT.next_up(), 1e6, 1e22, f64::MAX, f64::INFINITY, f64::NAN];
        let near = [0.0, f64::from_bits(1), f64::MIN_POSITIVE, 1e-20];
        for angle in far.into_iter().chain(near).flat_map(|angle| [angle, -angle]) {
            let (found, expected) = (sine_cosine(angle), angle.sin_cos());
            assert_eq!(found.0.to_bits(), expected.0.to_bits(), "{angle}");
            assert_eq!(found.1.to_bits(), expected.1.to_bits(), "{angle}");
            let angle = single(angle);
            let (found, expected) = (sine_cosine_single(angle), angle.sin_cos());
            assert_eq!(found.0.to_bits(), expected.0.to_bits(), "{angle}");
            assert_eq!(found.1.to_bits(), expected.1.to_bits(), "{angle}");
        }
    }

    #[test]
    fn sine_is_odd_and_cosine_even() {
        for angle in fractions(1000).map(|f| 100.0 * f) {
            let (sine, cosine) = sine_cosine(angle);
            assert_eq!(sine_cosine(-angle), (-sine, cosine));
        }
    }
}
