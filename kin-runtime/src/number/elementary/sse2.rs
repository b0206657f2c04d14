//! Two numbers in one register, for pairs that need the same steps: a sine and a cosine, or two arctangents.
//!
//! The steps are those of [`near_sine_cosine`](super::near_sine_cosine) and
//! [`ordinary_arc_tangent`](super::ordinary_arc_tangent), to the last bit, in half as many instructions. A compiler
//! finds only some of the pairs, and it joins and splits them along the way.
#![expect(
    unsafe_code,
    reason = "a function that uses these instructions is safe only for callers that declare them; every machine of \
              this module has them"
)]

use core::arch::x86_64::{
    __m128, __m128d, _mm_add_epi64, _mm_add_pd, _mm_and_pd, _mm_and_si128, _mm_andnot_pd, _mm_castpd_si128,
    _mm_castsi128_pd, _mm_cmpgt_pd, _mm_cmpunord_pd, _mm_cvtpd_ps, _mm_cvtps_pd, _mm_cvtsd_f64, _mm_cvtss_f32,
    _mm_div_pd, _mm_max_pd, _mm_min_pd, _mm_movemask_pd, _mm_mul_pd, _mm_or_pd, _mm_set_epi64x, _mm_set_pd, _mm_set_ps,
    _mm_set1_epi64x, _mm_set1_pd, _mm_setzero_si128, _mm_shuffle_pd, _mm_shuffle_ps, _mm_slli_epi64, _mm_sub_epi64,
    _mm_sub_pd, _mm_unpackhi_pd, _mm_xor_pd,
};

use core::f64::consts::FRAC_PI_4;

use super::arc_tangent::{ARC_TANGENT, ARC_TANGENT_SINGLE, HALF_RIGHT_ANGLE};
use super::sine_cosine::{COSINE, COSINE_SINGLE, Reduced, ReducedSingle, SINE, SINE_SINGLE};

/// The sine and the cosine of an angle that [is near](super::is_near).
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn sine_cosine(angle: f64) -> (f64, f64) {
    // SAFETY: `sine_beside_cosine` takes and returns numbers and reads no memory by address. Its only precondition is
    // its `target_feature`: the machine must have SSE2. This module is compiled only under
    // `cfg(target_feature = "sse2")`, so the whole program is compiled for machines that have it.
    unsafe { sine_beside_cosine(Reduced::new::<false>(angle)) }
}

/// The arctangents of two points, and whether both points are ordinary.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn arc_tangents(y: [f64; 2], x: [f64; 2]) -> ([f64; 2], bool) {
    // SAFETY: as above, `arc_tangents_side_by_side` takes and returns numbers and needs SSE2, which every machine has
    // for which this module is compiled. Both functions call only SSE2 intrinsics that work on registers.
    unsafe { arc_tangents_side_by_side(y, x) }
}

/// The sine and the cosine of an angle of single precision that [is near](super::is_near), computed in double
/// precision.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn sine_cosine_single(angle: f64) -> (f32, f32) {
    // SAFETY: as above, `single_sine_beside_cosine` takes and returns numbers and needs SSE2.
    unsafe { single_sine_beside_cosine(ReducedSingle::new::<false>(angle)) }
}

/// The arctangents of two points of single precision, and whether both points are ordinary, computed in double
/// precision.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn arc_tangents_single(y: [f32; 2], x: [f32; 2]) -> ([f32; 2], bool) {
    // SAFETY: as above, `single_arc_tangents_side_by_side` takes and returns numbers and needs SSE2.
    unsafe { single_arc_tangents_side_by_side(y, x) }
}

#[inline]
#[target_feature(enable = "sse2")]
fn sine_beside_cosine(Reduced { r, tail, shifted }: Reduced<f64>) -> (f64, f64) {
    let square = r * r;
    let z = _mm_set1_pd(square);
    // The cosine's polynomial is subtracted, the sine's is added.
    let coefficient = |k: usize| _mm_set_pd(-COSINE[k], SINE[k]);
    let term = |k: usize| _mm_add_pd(coefficient(k), _mm_mul_pd(coefficient(k + 1), z));
    let z2 = _mm_mul_pd(z, z);
    let polynomial = plus_product(plus_product(term(0), term(2), z2), term(4), _mm_mul_pd(z2, z2));

    // r - (r z p + tail) and 1 - (z / 2 - z² q)
    let factor = _mm_mul_pd(_mm_set_pd(square, r), z);
    let subtrahend = plus_product(_mm_set_pd(0.5 * square, tail), factor, polynomial);
    let reduced = _mm_sub_pd(_mm_set_pd(1.0, r), subtrahend);

    let [sine, cosine] = parts(in_quadrant(shifted, reduced));
    (sine, cosine)
}

/// As [`sine_beside_cosine`], with shorter polynomials and without a tail.
#[inline]
#[target_feature(enable = "sse2")]
fn single_sine_beside_cosine(ReducedSingle { r, shifted }: ReducedSingle) -> (f32, f32) {
    let square = r * r;
    let z = _mm_set1_pd(square);
    let higher = _mm_mul_pd(_mm_set_pd(0.0, SINE_SINGLE[3]), z);
    let higher = _mm_add_pd(_mm_set_pd(-COSINE_SINGLE[2], SINE_SINGLE[2]), higher);
    let lower = _mm_mul_pd(_mm_set_pd(-COSINE_SINGLE[1], SINE_SINGLE[1]), z);
    let lower = _mm_add_pd(_mm_set_pd(-COSINE_SINGLE[0], SINE_SINGLE[0]), lower);
    let polynomial = plus_product(lower, higher, _mm_mul_pd(z, z));

    // r - r z p and 1 - (z / 2 - z² q)
    let factor = _mm_mul_pd(_mm_set_pd(square, r), z);
    let subtrahend = plus_product(_mm_set_pd(0.5 * square, 0.0), factor, polynomial);
    let reduced = _mm_sub_pd(_mm_set_pd(1.0, r), subtrahend);
    let [sine, cosine] = single_parts(_mm_cvtpd_ps(in_quadrant(shifted, reduced)));
    (sine, cosine)
}

/// A sine and a cosine, rotated by the number of right angles in the lowest bits of `shifted`.
#[inline]
#[target_feature(enable = "sse2")]
fn in_quadrant(shifted: f64, reduced: __m128d) -> __m128d {
    // An odd number of right angles exchanges the sine and the cosine.
    let quarters = _mm_castpd_si128(_mm_set1_pd(shifted));
    let odd = _mm_sub_epi64(_mm_setzero_si128(), _mm_and_si128(quarters, _mm_set1_epi64x(1)));
    let exchanged = selected(_mm_castsi128_pd(odd), _mm_shuffle_pd::<1>(reduced, reduced), reduced);
    let signs = _mm_slli_epi64::<62>(_mm_add_epi64(quarters, _mm_set_epi64x(1, 0)));
    _mm_xor_pd(exchanged, sign(_mm_castsi128_pd(signs)))
}

#[inline]
#[target_feature(enable = "sse2")]
fn arc_tangents_side_by_side(y: [f64; 2], x: [f64; 2]) -> ([f64; 2], bool) {
    let (y, x) = (_mm_set_pd(y[1], y[0]), _mm_set_pd(x[1], x[0]));
    let Folded {
        fraction,
        z,
        multiple,
        ordinary,
    } = folded(y, x);
    let coefficient = |k: usize| _mm_set1_pd(ARC_TANGENT[k]);
    let term = |k: usize| _mm_add_pd(coefficient(k), _mm_mul_pd(coefficient(k + 1), z));
    let z2 = _mm_mul_pd(z, z);
    let term = |k: usize| plus_product(term(k), term(k + 2), z2);
    let z4 = _mm_mul_pd(z2, z2);
    let polynomial = plus_product(plus_product(term(0), term(4), z4), term(8), _mm_mul_pd(z4, z4));
    let low = _mm_mul_pd(multiple, _mm_set1_pd(HALF_RIGHT_ANGLE[1]));
    let rest = _mm_sub_pd(low, _mm_mul_pd(_mm_mul_pd(fraction, z), polynomial));
    let angle = plus_product(_mm_add_pd(fraction, rest), multiple, _mm_set1_pd(HALF_RIGHT_ANGLE[0]));
    (parts(_mm_or_pd(magnitude(angle), sign(y))), ordinary)
}

/// As [`arc_tangents_side_by_side`], with a shorter polynomial.
#[inline]
#[target_feature(enable = "sse2")]
fn single_arc_tangents_side_by_side(y: [f32; 2], x: [f32; 2]) -> ([f32; 2], bool) {
    let wide = |[one, other]: [f32; 2]| _mm_cvtps_pd(_mm_set_ps(0.0, 0.0, other, one));
    let (y, x) = (wide(y), wide(x));
    let Folded {
        fraction,
        z,
        multiple,
        ordinary,
    } = folded(y, x);
    let coefficient = |k: usize| _mm_set1_pd(ARC_TANGENT_SINGLE[k]);
    let term = |k: usize| _mm_add_pd(coefficient(k), _mm_mul_pd(coefficient(k + 1), z));
    let z2 = _mm_mul_pd(z, z);
    let polynomial = plus_product(plus_product(term(0), term(2), z2), term(4), _mm_mul_pd(z2, z2));
    let angle = _mm_sub_pd(fraction, _mm_mul_pd(fraction, _mm_mul_pd(z, polynomial)));
    let angle = plus_product(angle, multiple, _mm_set1_pd(FRAC_PI_4));
    let angle = _mm_or_pd(magnitude(angle), sign(y));
    (single_parts(_mm_cvtpd_ps(angle)), ordinary)
}

/// Two points that have been rotated and mirrored close to the positive x axis.
struct Folded {
    /// The fraction of the coordinates, with the sense in which the angle counts.
    fraction: __m128d,
    /// The square of the fraction.
    z: __m128d,
    /// The multiple of π/4 from which the angle counts.
    multiple: __m128d,
    /// Whether both points are ordinary.
    ordinary: bool,
}

#[inline]
#[target_feature(enable = "sse2")]
fn folded(y: __m128d, x: __m128d) -> Folded {
    let (height, width) = (magnitude(y), magnitude(x));
    let (greater, lesser) = (_mm_max_pd(height, width), _mm_min_pd(width, height));
    let slanting = _mm_cmpgt_pd(lesser, _mm_sub_pd(greater, lesser));
    let sense = sign(_mm_xor_pd(x, _mm_sub_pd(width, height)));
    let one = _mm_set1_pd(1.0);
    let side = _mm_or_pd(sign(x), one);
    // The multiple is 0, 2 or 4 at the nearest axis, and 1 or 3 at a diagonal.
    let multiple = _mm_sub_pd(
        _mm_sub_pd(_mm_set1_pd(2.0), side),
        _mm_andnot_pd(slanting, _mm_or_pd(sense, one)),
    );
    let across = _mm_sub_pd(lesser, _mm_and_pd(slanting, greater));
    let along = _mm_add_pd(greater, _mm_and_pd(slanting, lesser));

    let fraction = _mm_div_pd(across, along);
    let check = _mm_mul_pd(along, fraction);
    Folded {
        fraction: _mm_xor_pd(fraction, sense),
        z: _mm_mul_pd(fraction, fraction),
        multiple,
        ordinary: _mm_movemask_pd(_mm_cmpunord_pd(check, check)) == 0,
    }
}

#[inline]
#[target_feature(enable = "sse2")]
fn plus_product(c: __m128d, a: __m128d, b: __m128d) -> __m128d {
    _mm_add_pd(c, _mm_mul_pd(a, b))
}

#[inline]
#[target_feature(enable = "sse2")]
fn sign(numbers: __m128d) -> __m128d {
    _mm_and_pd(numbers, _mm_set1_pd(-0.0))
}

#[inline]
#[target_feature(enable = "sse2")]
fn magnitude(numbers: __m128d) -> __m128d {
    _mm_andnot_pd(_mm_set1_pd(-0.0), numbers)
}

#[inline]
#[target_feature(enable = "sse2")]
fn selected(condition: __m128d, yes: __m128d, no: __m128d) -> __m128d {
    _mm_or_pd(_mm_and_pd(condition, yes), _mm_andnot_pd(condition, no))
}

#[inline]
#[target_feature(enable = "sse2")]
fn parts(numbers: __m128d) -> [f64; 2] {
    [_mm_cvtsd_f64(numbers), _mm_cvtsd_f64(_mm_unpackhi_pd(numbers, numbers))]
}

#[inline]
#[target_feature(enable = "sse2")]
fn single_parts(numbers: __m128) -> [f32; 2] {
    [
        _mm_cvtss_f32(numbers),
        _mm_cvtss_f32(_mm_shuffle_ps::<1>(numbers, numbers)),
    ]
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::{arc_tangents, arc_tangents_single, sine_cosine};
    use crate::number::elementary::{arc_tangent_single, near_sine_cosine, ordinary_arc_tangent, reference::fractions};
    use crate::number::single;

    #[test]
    fn it_is_the_same_to_the_last_bit() {
        let bits = |(sine, cosine): (f64, f64)| [sine.to_bits(), cosine.to_bits()];
        let wide = fractions(100_000).map(|f| (2.0 * f - 1.0) * 1e5);
        let narrow = fractions(100_000).map(|f| (2.0 * f - 1.0) * 3.2);
        let slight = fractions(10_000).flat_map(|f| [f64::exp2(-1074.0 * f), -f64::exp2(-1074.0 * f)]);
        for angle in wide.chain(narrow).chain(slight).chain([0.0, -0.0]) {
            assert_eq!(
                bits(sine_cosine(angle)),
                bits(near_sine_cosine::<false, false, f64>(angle)),
                "{angle:e}"
            );
        }
        assert!(sine_cosine(f64::NAN).0.is_nan() && sine_cosine(f64::NAN).1.is_nan());
    }

    #[test]
    fn so_are_two_arctangents_where_both_are_ordinary() {
        let sizes = [
            0.0,
            5e-324,
            1e-300,
            0.3,
            0.5,
            1.0,
            1.7,
            2.0,
            1e300,
            f64::MAX,
            f64::INFINITY,
            f64::NAN,
        ];
        let values = || sizes.into_iter().flat_map(|size| [size, -size]);
        let points: Vec<[f64; 2]> = values()
            .flat_map(|y| values().map(move |x| [y, x]))
            .chain(fractions(20_000).map(|f| {
                let (sine, cosine) = (7.0 * f - 3.5).sin_cos();
                let size = f64::exp2(600.0 * ((f * 977.0).fract() - 0.5));
                [size * sine, size * cosine]
            }))
            .collect();
        for (first, second) in points.iter().zip(points.iter().rev()) {
            let (found, ordinary) = arc_tangents([first[0], second[0]], [first[1], second[1]]);
            let expected = [first, second].map(|[y, x]| ordinary_arc_tangent::<false, false, f64>(*y, *x));
            assert_eq!(
                ordinary,
                expected.iter().all(|(_, ordinary)| *ordinary),
                "{first:?} {second:?}"
            );
            for (found, (expected, is_ordinary)) in found.iter().zip(expected) {
                assert!(
                    !is_ordinary || found.to_bits() == expected.to_bits(),
                    "{first:?} {second:?}"
                );
            }
        }
    }

    /// The accuracy of single precision is tested where it is declared. Here, each point has the angle that it has
    /// alone.
    #[test]
    fn points_of_single_precision_have_their_own_angles() {
        let sizes = [
            0.0,
            f32::from_bits(1),
            f32::MIN_POSITIVE,
            1e-20,
            0.5,
            1.0,
            1.7,
            2.0,
            f32::MAX,
        ];
        let values = || sizes.into_iter().flat_map(|size| [size, -size]);
        let points: Vec<[f32; 2]> = values()
            .flat_map(|y| values().map(move |x| [y, x]))
            .chain(fractions(20_000).map(|f| {
                let (sine, cosine) = (7.0 * f - 3.5).sin_cos();
                let size = f64::exp2(60.0 * ((f * 977.0).fract() - 0.5));
                [single(size * sine), single(size * cosine)]
            }))
            .collect();
        let is_origin = |[y, x]: [f32; 2]| y == 0.0 && x == 0.0;
        for (&first, &second) in points.iter().zip(points.iter().rev()) {
            let (found, ordinary) = arc_tangents_single([first[0], second[0]], [first[1], second[1]]);
            assert_eq!(
                ordinary,
                !is_origin(first) && !is_origin(second),
                "{first:?} {second:?}"
            );
            for (found, point) in found.into_iter().zip([first, second]) {
                let expected = arc_tangent_single(point[0], point[1]);
                assert!(is_origin(point) || found.to_bits() == expected.to_bits(), "{point:?}");
            }
        }
    }
}
