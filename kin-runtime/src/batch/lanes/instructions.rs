//! Vector instructions for the operations of lanes.
//!
//! Lanes are arrays. A loop over an array is compiled to vector instructions only if the compiler finds them again,
//! among thousands of operations, and it may find narrower ones. So each operation names its instruction, on x86-64.
//! Other machines get the loop.
#![cfg_attr(
    all(target_arch = "x86_64", target_feature = "sse2"),
    expect(
        unsafe_code,
        reason = "operations read whole vectors from arrays, and wide vectors are chosen only where a machine has them"
    )
)]

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
use core::arch::x86_64::{
    __m128, __m128d, _mm_add_pd, _mm_add_ps, _mm_and_pd, _mm_and_ps, _mm_andnot_pd, _mm_andnot_ps, _mm_cmpeq_pd,
    _mm_cmpeq_ps, _mm_cmpge_pd, _mm_cmpge_ps, _mm_cmpgt_pd, _mm_cmpgt_ps, _mm_div_pd, _mm_div_ps, _mm_max_pd,
    _mm_max_ps, _mm_movemask_pd, _mm_movemask_ps, _mm_mul_pd, _mm_mul_ps, _mm_or_pd, _mm_or_ps, _mm_set1_pd,
    _mm_set1_ps, _mm_sqrt_pd, _mm_sqrt_ps, _mm_sub_pd, _mm_sub_ps, _mm_xor_pd, _mm_xor_ps,
};
#[cfg(all(feature = "std", target_arch = "x86_64"))]
use core::arch::x86_64::{
    __m256, __m256d, __m512, __m512d, _CMP_EQ_OQ, _CMP_GE_OQ, _CMP_GT_OQ, _mm256_add_pd, _mm256_add_ps, _mm256_and_pd,
    _mm256_and_ps, _mm256_andnot_pd, _mm256_andnot_ps, _mm256_blendv_pd, _mm256_blendv_ps, _mm256_cmp_pd,
    _mm256_cmp_ps, _mm256_div_pd, _mm256_div_ps, _mm256_fmadd_pd, _mm256_fmadd_ps, _mm256_fnmadd_pd, _mm256_fnmadd_ps,
    _mm256_max_pd, _mm256_max_ps, _mm256_movemask_pd, _mm256_movemask_ps, _mm256_mul_pd, _mm256_mul_ps, _mm256_or_pd,
    _mm256_or_ps, _mm256_set1_pd, _mm256_set1_ps, _mm256_sqrt_pd, _mm256_sqrt_ps, _mm256_sub_pd, _mm256_sub_ps,
    _mm256_xor_pd, _mm256_xor_ps, _mm512_add_pd, _mm512_add_ps, _mm512_and_pd, _mm512_and_ps, _mm512_andnot_pd,
    _mm512_andnot_ps, _mm512_castpd_si512, _mm512_castps_si512, _mm512_castsi512_pd, _mm512_castsi512_ps,
    _mm512_cmp_pd_mask, _mm512_cmp_ps_mask, _mm512_div_pd, _mm512_div_ps, _mm512_fmadd_pd, _mm512_fmadd_ps,
    _mm512_fnmadd_pd, _mm512_fnmadd_ps, _mm512_mask_blend_pd, _mm512_mask_blend_ps, _mm512_max_pd, _mm512_max_ps,
    _mm512_movepi32_mask, _mm512_movepi64_mask, _mm512_movm_epi32, _mm512_movm_epi64, _mm512_mul_pd, _mm512_mul_ps,
    _mm512_or_pd, _mm512_or_ps, _mm512_set1_pd, _mm512_set1_ps, _mm512_sqrt_pd, _mm512_sqrt_ps, _mm512_sub_pd,
    _mm512_sub_ps, _mm512_xor_pd, _mm512_xor_ps,
};
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
use core::mem::MaybeUninit;

use num_traits::{Float, Zero};

use crate::number::elementary::Elementary;

/// Whether vectors of so many bits come with multiply-add as one instruction.
pub(super) const fn is_fused(bits: usize) -> bool {
    bits > 128
}

/// Operations on `W` numbers or masks, lane by lane, with vectors of `BITS` bits. The numbers may fill several vectors.
pub trait Instructions: Copy {
    fn sum<const W: usize, const BITS: usize>(a: &[Self; W], b: &[Self; W]) -> [Self; W];
    fn difference<const W: usize, const BITS: usize>(a: &[Self; W], b: &[Self; W]) -> [Self; W];
    fn product<const W: usize, const BITS: usize>(a: &[Self; W], b: &[Self; W]) -> [Self; W];
    fn quotient<const W: usize, const BITS: usize>(a: &[Self; W], b: &[Self; W]) -> [Self; W];
    fn opposite<const W: usize, const BITS: usize>(a: &[Self; W]) -> [Self; W];
    fn square_root<const W: usize, const BITS: usize>(a: &[Self; W]) -> [Self; W];

    /// a + b c, rounded once if the vectors [are fused](is_fused).
    fn plus_product<const W: usize, const BITS: usize>(a: &[Self; W], b: &[Self; W], c: &[Self; W]) -> [Self; W];

    /// a - b c, rounded once if the vectors [are fused](is_fused).
    fn minus_product<const W: usize, const BITS: usize>(a: &[Self; W], b: &[Self; W], c: &[Self; W]) -> [Self; W];

    /// b if it is greater than a, otherwise a.
    fn larger<const W: usize, const BITS: usize>(a: &[Self; W], b: &[Self; W]) -> [Self; W];

    fn absolute_value<const W: usize, const BITS: usize>(a: &[Self; W]) -> [Self; W];

    /// The mask of a ≥ b: all bits in the lanes where it holds, and none in the others.
    fn at_least<const W: usize, const BITS: usize>(a: &[Self; W], b: &[Self; W]) -> [Self; W];

    /// The mask of a > b.
    fn exceeding<const W: usize, const BITS: usize>(a: &[Self; W], b: &[Self; W]) -> [Self; W];

    /// The mask of a = b.
    fn equal<const W: usize, const BITS: usize>(a: &[Self; W], b: &[Self; W]) -> [Self; W];

    /// The mask of both masks.
    fn conjunction<const W: usize, const BITS: usize>(a: &[Self; W], b: &[Self; W]) -> [Self; W];

    /// The mask of either mask.
    fn disjunction<const W: usize, const BITS: usize>(a: &[Self; W], b: &[Self; W]) -> [Self; W];

    /// The mask b without the mask a.
    fn exclusion<const W: usize, const BITS: usize>(a: &[Self; W], b: &[Self; W]) -> [Self; W];

    /// b where the mask a is set, and c elsewhere.
    fn selection<const W: usize, const BITS: usize>(a: &[Self; W], b: &[Self; W], c: &[Self; W]) -> [Self; W];

    /// Whether the mask is set in any lane.
    fn is_any<const W: usize, const BITS: usize>(a: &[Self; W]) -> bool;
}

/// The operations for vectors of one kind.
///
/// The compiler optimises each of these functions before it inlines them. A kernel calls them thousands of times: with
/// a loop at each call, it takes a compiler twice as long. Only the instructions and the two products with a sum differ
/// from kind to kind, and are given; the operations stand in the second arm.
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
macro_rules! vectors {
    (
        $kind:ident: $float:ty, $vector:ident, $features:literal;
        $($name:ident($($operand:ident),+): $instruction:expr;)+
        |$mask:ident, $more:ident| $disjunction:expr, $is_any:expr;
    ) => {
        struct $kind;

        impl $kind {
            /// The numbers in a vector.
            const COUNT: usize = size_of::<$vector>() / size_of::<$float>();

            $(
                /// # Safety
                /// `W` must be a multiple of the count, and the machine must have the vectors.
                #[inline]
                #[target_feature(enable = $features)]
                unsafe fn $name<const W: usize>($($operand: &[$float; W]),+) -> [$float; W] {
                    let mut result = MaybeUninit::<[$float; W]>::uninit();
                    let mut first = 0;
                    while first < W {
                        $(
                            // SAFETY: a whole vector lies between `first`, which is a multiple of its count, and `W`,
                            // which is another one.
                            let $operand = unsafe { $operand.as_ptr().add(first).cast::<$vector>().read_unaligned() };
                        )+
                        let vector = $instruction;
                        // SAFETY: as above.
                        unsafe {
                            result.as_mut_ptr().cast::<$float>().add(first).cast::<$vector>().write_unaligned(vector);
                        }
                        first += Self::COUNT;
                    }
                    // SAFETY: every vector has been written.
                    unsafe { result.assume_init() }
                }
            )+

            /// # Safety
            /// As above.
            #[inline]
            #[target_feature(enable = $features)]
            unsafe fn is_any<const W: usize>(mask: &[$float; W]) -> bool {
                // SAFETY: as above, for all vectors.
                let vector = |first| unsafe { mask.as_ptr().add(first).cast::<$vector>().read_unaligned() };
                let mut $mask = vector(0);
                let mut first = Self::COUNT;
                while first < W {
                    let $more = vector(first);
                    $mask = $disjunction;
                    first += Self::COUNT;
                }
                $is_any
            }
        }
    };
    (
        $kind:ident: $float:ty, $vector:ident, $features:literal;
        $add:ident, $subtract:ident, $multiply:ident, $divide:ident, $xor:ident, $splat:ident, $square_root:ident;
        $max:ident, $and:ident, $and_not:ident, $or:ident;
        |$a:ident, $b:ident, $c:ident|
        $plus_product:expr, $minus_product:expr,
        $at_least:expr, $exceeding:expr, $equal:expr, $selection:expr, $is_any:expr;
    ) => {
        vectors! {
            $kind: $float, $vector, $features;
            sum($a, $b): $add($a, $b);
            difference($a, $b): $subtract($a, $b);
            product($a, $b): $multiply($a, $b);
            quotient($a, $b): $divide($a, $b);
            opposite($a): $xor($a, $splat(-0.0));
            square_root($a): $square_root($a);
            plus_product($a, $b, $c): $plus_product;
            minus_product($a, $b, $c): $minus_product;
            larger($a, $b): $max($b, $a);
            absolute_value($a): $and_not($splat(-0.0), $a);
            at_least($a, $b): $at_least;
            exceeding($a, $b): $exceeding;
            equal($a, $b): $equal;
            conjunction($a, $b): $and($a, $b);
            disjunction($a, $b): $or($a, $b);
            exclusion($a, $b): $and_not($a, $b);
            selection($a, $b, $c): $selection;
            |$a, $b| $or($a, $b), $is_any;
        }
    };
}

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
vectors! {
    Doubles128: f64, __m128d, "sse2";
    _mm_add_pd, _mm_sub_pd, _mm_mul_pd, _mm_div_pd, _mm_xor_pd, _mm_set1_pd, _mm_sqrt_pd;
    _mm_max_pd, _mm_and_pd, _mm_andnot_pd, _mm_or_pd;
    |a, b, c|
    _mm_add_pd(a, _mm_mul_pd(b, c)), _mm_sub_pd(a, _mm_mul_pd(b, c)),
    _mm_cmpge_pd(a, b),
    _mm_cmpgt_pd(a, b),
    _mm_cmpeq_pd(a, b),
    _mm_or_pd(_mm_and_pd(a, b), _mm_andnot_pd(a, c)),
    _mm_movemask_pd(a) != 0;
}

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
vectors! {
    Singles128: f32, __m128, "sse2";
    _mm_add_ps, _mm_sub_ps, _mm_mul_ps, _mm_div_ps, _mm_xor_ps, _mm_set1_ps, _mm_sqrt_ps;
    _mm_max_ps, _mm_and_ps, _mm_andnot_ps, _mm_or_ps;
    |a, b, c|
    _mm_add_ps(a, _mm_mul_ps(b, c)), _mm_sub_ps(a, _mm_mul_ps(b, c)),
    _mm_cmpge_ps(a, b),
    _mm_cmpgt_ps(a, b),
    _mm_cmpeq_ps(a, b),
    _mm_or_ps(_mm_and_ps(a, b), _mm_andnot_ps(a, c)),
    _mm_movemask_ps(a) != 0;
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
vectors! {
    Doubles256: f64, __m256d, "avx2,fma";
    _mm256_add_pd, _mm256_sub_pd, _mm256_mul_pd, _mm256_div_pd, _mm256_xor_pd, _mm256_set1_pd, _mm256_sqrt_pd;
    _mm256_max_pd, _mm256_and_pd, _mm256_andnot_pd, _mm256_or_pd;
    |a, b, c|
    _mm256_fmadd_pd(b, c, a), _mm256_fnmadd_pd(b, c, a),
    _mm256_cmp_pd::<_CMP_GE_OQ>(a, b),
    _mm256_cmp_pd::<_CMP_GT_OQ>(a, b),
    _mm256_cmp_pd::<_CMP_EQ_OQ>(a, b),
    _mm256_blendv_pd(c, b, a),
    _mm256_movemask_pd(a) != 0;
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
vectors! {
    Singles256: f32, __m256, "avx2,fma";
    _mm256_add_ps, _mm256_sub_ps, _mm256_mul_ps, _mm256_div_ps, _mm256_xor_ps, _mm256_set1_ps, _mm256_sqrt_ps;
    _mm256_max_ps, _mm256_and_ps, _mm256_andnot_ps, _mm256_or_ps;
    |a, b, c|
    _mm256_fmadd_ps(b, c, a), _mm256_fnmadd_ps(b, c, a),
    _mm256_cmp_ps::<_CMP_GE_OQ>(a, b),
    _mm256_cmp_ps::<_CMP_GT_OQ>(a, b),
    _mm256_cmp_ps::<_CMP_EQ_OQ>(a, b),
    _mm256_blendv_ps(c, b, a),
    _mm256_movemask_ps(a) != 0;
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
vectors! {
    Doubles512: f64, __m512d, "avx512f,avx512dq,avx512vl,avx2,fma";
    _mm512_add_pd, _mm512_sub_pd, _mm512_mul_pd, _mm512_div_pd, _mm512_xor_pd, _mm512_set1_pd, _mm512_sqrt_pd;
    _mm512_max_pd, _mm512_and_pd, _mm512_andnot_pd, _mm512_or_pd;
    |a, b, c|
    _mm512_fmadd_pd(b, c, a), _mm512_fnmadd_pd(b, c, a),
    _mm512_castsi512_pd(_mm512_movm_epi64(_mm512_cmp_pd_mask::<_CMP_GE_OQ>(a, b))),
    _mm512_castsi512_pd(_mm512_movm_epi64(_mm512_cmp_pd_mask::<_CMP_GT_OQ>(a, b))),
    _mm512_castsi512_pd(_mm512_movm_epi64(_mm512_cmp_pd_mask::<_CMP_EQ_OQ>(a, b))),
    _mm512_mask_blend_pd(_mm512_movepi64_mask(_mm512_castpd_si512(a)), c, b),
    _mm512_movepi64_mask(_mm512_castpd_si512(a)) != 0;
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
vectors! {
    Singles512: f32, __m512, "avx512f,avx512dq,avx512vl,avx2,fma";
    _mm512_add_ps, _mm512_sub_ps, _mm512_mul_ps, _mm512_div_ps, _mm512_xor_ps, _mm512_set1_ps, _mm512_sqrt_ps;
    _mm512_max_ps, _mm512_and_ps, _mm512_andnot_ps, _mm512_or_ps;
    |a, b, c|
    _mm512_fmadd_ps(b, c, a), _mm512_fnmadd_ps(b, c, a),
    _mm512_castsi512_ps(_mm512_movm_epi32(_mm512_cmp_ps_mask::<_CMP_GE_OQ>(a, b))),
    _mm512_castsi512_ps(_mm512_movm_epi32(_mm512_cmp_ps_mask::<_CMP_GT_OQ>(a, b))),
    _mm512_castsi512_ps(_mm512_movm_epi32(_mm512_cmp_ps_mask::<_CMP_EQ_OQ>(a, b))),
    _mm512_mask_blend_ps(_mm512_movepi32_mask(_mm512_castps_si512(a)), c, b),
    _mm512_movepi32_mask(_mm512_castps_si512(a)) != 0;
}

/// The operations of a plain number, by the vectors of 128, 256 and 512 bits, or in a loop.
macro_rules! instructions {
    (
        $float:ty, $of_128:ident, $of_256:ident, $of_512:ident;
        $($name:ident($($operand:ident),+): $scalar:expr;)+
    ) => {
        impl Instructions for $float {
            $(
                #[cfg_attr(not(debug_assertions), inline(always))]
                fn $name<const W: usize, const BITS: usize>($($operand: &[Self; W]),+) -> [Self; W] {
                    #[inline]
                    fn in_a_loop<const W: usize>($($operand: &[$float; W]),+) -> [$float; W] {
                        let mut result = [0.0; W];
                        for_each_lane!(lane in 0..W {
                            $(let $operand = $operand[lane];)+
                            result[lane] = $scalar;
                        });
                        result
                    }

                    #[cfg(all(feature = "std", target_arch = "x86_64"))]
                    if BITS == 512 && W.is_multiple_of($of_512::COUNT) {
                        // SAFETY: only `dispatch` chooses vectors of 512 bits, on a machine that has them.
                        return unsafe { $of_512::$name($($operand),+) };
                    }
                    #[cfg(all(feature = "std", target_arch = "x86_64"))]
                    if BITS == 256 && W.is_multiple_of($of_256::COUNT) {
                        // SAFETY: as above, for vectors of 256 bits.
                        return unsafe { $of_256::$name($($operand),+) };
                    }
                    #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
                    if BITS == 128 && W.is_multiple_of($of_128::COUNT) {
                        // SAFETY: the program is compiled for machines that have vectors of 128 bits.
                        return unsafe { $of_128::$name($($operand),+) };
                    }
                    in_a_loop($($operand),+)
                }
            )+

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn is_any<const W: usize, const BITS: usize>(a: &[Self; W]) -> bool {
                #[cfg(all(feature = "std", target_arch = "x86_64"))]
                if BITS == 512 && W.is_multiple_of($of_512::COUNT) {
                    // SAFETY: as above.
                    return unsafe { $of_512::is_any(a) };
                }
                #[cfg(all(feature = "std", target_arch = "x86_64"))]
                if BITS == 256 && W.is_multiple_of($of_256::COUNT) {
                    // SAFETY: as above.
                    return unsafe { $of_256::is_any(a) };
                }
                #[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
                if BITS == 128 && W.is_multiple_of($of_128::COUNT) {
                    // SAFETY: as above.
                    return unsafe { $of_128::is_any(a) };
                }
                a.iter().any(|lane| lane.to_bits() != 0)
            }
        }
    };
    ($float:ty, $of_128:ident, $of_256:ident, $of_512:ident) => {
        instructions! {
            $float, $of_128, $of_256, $of_512;
            sum(a, b): a + b;
            difference(a, b): a - b;
            product(a, b): a * b;
            quotient(a, b): a / b;
            opposite(a): -a;
            square_root(a): Float::sqrt(a);
            plus_product(a, b, c): a + b * c;
            minus_product(a, b, c): a - b * c;
            larger(a, b): if b > a { b } else { a };
            absolute_value(a): a.abs();
            at_least(a, b): mask(a >= b);
            exceeding(a, b): mask(a > b);
            equal(a, b): mask(a == b);
            conjunction(a, b): <$float>::from_bits(a.to_bits() & b.to_bits());
            disjunction(a, b): <$float>::from_bits(a.to_bits() | b.to_bits());
            exclusion(a, b): <$float>::from_bits(!a.to_bits() & b.to_bits());
            selection(a, b, c): if a.to_bits() == 0 { c } else { b };
        }
    };
}

/// All bits if a condition holds, and none otherwise.
fn mask<E: Elementary>(holds: bool) -> E {
    E::of_bits(if holds { !E::Bits::zero() } else { E::Bits::zero() })
}

instructions!(f64, Doubles128, Doubles256, Doubles512);
instructions!(f32, Singles128, Singles256, Singles512);

#[cfg(test)]
mod tests {
    use num_traits::Float;

    use super::{Instructions, is_fused, mask};
    use crate::batch::Vectors;
    use crate::number::elementary::Elementary;

    /// A number of zeros, infinities, NaN and ordinary numbers, another for each lane.
    fn number<E: Float>(index: usize) -> E {
        let some = [
            0.0,
            -0.0,
            1.5,
            -0.7,
            3e10,
            -2e-8,
            f64::INFINITY,
            f64::NAN,
            1.1,
            -6.25,
            0.3,
        ];
        E::from(some[index % some.len()]).expect("each type holds them, or infinity")
    }

    /// Whether two results are the same number, both of which may be NaN, or masks.
    fn are_same<E: Float>(found: E, expected: E) -> bool {
        found.is_nan() && expected.is_nan()
            || found == expected && found.is_sign_negative() == expected.is_sign_negative()
    }

    /// An operation on three numbers alone.
    type Alone<'a, E> = &'a dyn Fn(E, E, E) -> E;

    /// Each operation has the result that it has for each number alone.
    fn agree<const W: usize, const BITS: usize, E: Elementary + Instructions + core::fmt::Debug>() {
        for first in 0..11 {
            for second in 0..11 {
                let [a, b, c] =
                    [first, second, first + 3 * second].map(|start| core::array::from_fn(|lane| number(start + lane)));
                let fused = |a: E, b: E, c: E| if is_fused(BITS) { b.mul_add(c, a) } else { a + b * c };
                let set = |holds: bool| if holds { mask::<E>(true) } else { E::zero() };
                let (at_least, exceeding) = (E::at_least::<W, BITS>(&a, &b), E::exceeding::<W, BITS>(&b, &c));
                let operations: [([E; W], Alone<'_, E>); 17] = [
                    (E::sum::<W, BITS>(&a, &b), &|a, b, _| a + b),
                    (E::difference::<W, BITS>(&a, &b), &|a, b, _| a - b),
                    (E::product::<W, BITS>(&a, &b), &|a, b, _| a * b),
                    (E::quotient::<W, BITS>(&a, &b), &|a, b, _| a / b),
                    (E::opposite::<W, BITS>(&a), &|a, _, _| -a),
                    (E::square_root::<W, BITS>(&a), &|a, _, _| a.sqrt()),
                    (E::plus_product::<W, BITS>(&a, &b, &c), &fused),
                    (E::minus_product::<W, BITS>(&a, &b, &c), &|a, b, c| fused(a, -b, c)),
                    (E::larger::<W, BITS>(&a, &b), &|a, b, _| if b > a { b } else { a }),
                    (E::absolute_value::<W, BITS>(&a), &|a, _, _| a.abs()),
                    (at_least, &|a, b, _| set(a >= b)),
                    (exceeding, &|_, b, c| set(b > c)),
                    (E::equal::<W, BITS>(&a, &b), &|a, b, _| set(a == b)),
                    (E::conjunction::<W, BITS>(&at_least, &exceeding), &|a, b, c| {
                        set(a >= b && b > c)
                    }),
                    (E::disjunction::<W, BITS>(&at_least, &exceeding), &|a, b, c| {
                        set(a >= b || b > c)
                    }),
                    (E::exclusion::<W, BITS>(&at_least, &exceeding), &|a, b, c| {
                        let is_at_least = a >= b;
                        set(b > c && !is_at_least)
                    }),
                    (E::selection::<W, BITS>(&at_least, &b, &c), &|a, b, c| {
                        if a >= b { b } else { c }
                    }),
                ];
                let is_any = (0..W).any(|lane| a[lane] >= b[lane]);
                assert_eq!(E::is_any::<W, BITS>(&at_least), is_any);
                for (operation, (found, expected)) in operations.into_iter().enumerate() {
                    for lane in 0..W {
                        let expected = expected(a[lane], b[lane], c[lane]);
                        let found = found[lane];
                        assert!(are_same(found, expected), "{operation} {BITS}: {found:?} {expected:?}");
                    }
                }
            }
        }
    }

    #[test]
    fn vectors_calculate_as_numbers_alone() {
        agree::<4, 128, f64>();
        agree::<8, 128, f32>();
        // fewer numbers than a vector holds, and more than a whole vector
        agree::<3, 128, f64>();
        agree::<6, 128, f32>();
        if Vectors::Avx2.are_there() {
            agree::<8, 256, f64>();
            agree::<16, 256, f32>();
        }
        if Vectors::Avx512.are_there() {
            agree::<8, 512, f64>();
            agree::<16, 512, f64>();
            agree::<16, 512, f32>();
        }
    }
}
