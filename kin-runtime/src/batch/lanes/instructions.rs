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
    __m128, __m128d, _mm_add_pd, _mm_add_ps, _mm_div_pd, _mm_div_ps, _mm_mul_pd, _mm_mul_ps, _mm_set1_pd, _mm_set1_ps,
    _mm_sqrt_pd, _mm_sqrt_ps, _mm_sub_pd, _mm_sub_ps, _mm_xor_pd, _mm_xor_ps,
};
#[cfg(all(feature = "std", target_arch = "x86_64"))]
use core::arch::x86_64::{
    __m256, __m256d, __m512, __m512d, _mm256_add_pd, _mm256_add_ps, _mm256_div_pd, _mm256_div_ps, _mm256_fmadd_pd,
    _mm256_fmadd_ps, _mm256_fnmadd_pd, _mm256_fnmadd_ps, _mm256_mul_pd, _mm256_mul_ps, _mm256_set1_pd, _mm256_set1_ps,
    _mm256_sqrt_pd, _mm256_sqrt_ps, _mm256_sub_pd, _mm256_sub_ps, _mm256_xor_pd, _mm256_xor_ps, _mm512_add_pd,
    _mm512_add_ps, _mm512_div_pd, _mm512_div_ps, _mm512_fmadd_pd, _mm512_fmadd_ps, _mm512_fnmadd_pd, _mm512_fnmadd_ps,
    _mm512_mul_pd, _mm512_mul_ps, _mm512_set1_pd, _mm512_set1_ps, _mm512_sqrt_pd, _mm512_sqrt_ps, _mm512_sub_pd,
    _mm512_sub_ps, _mm512_xor_pd, _mm512_xor_ps,
};
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
use core::mem::MaybeUninit;

use num_traits::Float;

/// Whether vectors of so many bits come with multiply-add as one instruction.
pub(super) const fn is_fused(bits: usize) -> bool {
    bits > 128
}

/// Operations on `W` numbers, lane by lane, with vectors of `BITS` bits. The numbers may fill several vectors.
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
        }
    };
    (
        $kind:ident: $float:ty, $vector:ident, $features:literal;
        $add:ident, $subtract:ident, $multiply:ident, $divide:ident, $xor:ident, $splat:ident, $square_root:ident;
        |$a:ident, $b:ident, $c:ident| $plus_product:expr, $minus_product:expr;
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
        }
    };
}

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
vectors! {
    Doubles128: f64, __m128d, "sse2";
    _mm_add_pd, _mm_sub_pd, _mm_mul_pd, _mm_div_pd, _mm_xor_pd, _mm_set1_pd, _mm_sqrt_pd;
    |a, b, c| _mm_add_pd(a, _mm_mul_pd(b, c)), _mm_sub_pd(a, _mm_mul_pd(b, c));
}

#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
vectors! {
    Singles128: f32, __m128, "sse2";
    _mm_add_ps, _mm_sub_ps, _mm_mul_ps, _mm_div_ps, _mm_xor_ps, _mm_set1_ps, _mm_sqrt_ps;
    |a, b, c| _mm_add_ps(a, _mm_mul_ps(b, c)), _mm_sub_ps(a, _mm_mul_ps(b, c));
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
vectors! {
    Doubles256: f64, __m256d, "avx2,fma";
    _mm256_add_pd, _mm256_sub_pd, _mm256_mul_pd, _mm256_div_pd, _mm256_xor_pd, _mm256_set1_pd, _mm256_sqrt_pd;
    |a, b, c| _mm256_fmadd_pd(b, c, a), _mm256_fnmadd_pd(b, c, a);
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
vectors! {
    Singles256: f32, __m256, "avx2,fma";
    _mm256_add_ps, _mm256_sub_ps, _mm256_mul_ps, _mm256_div_ps, _mm256_xor_ps, _mm256_set1_ps, _mm256_sqrt_ps;
    |a, b, c| _mm256_fmadd_ps(b, c, a), _mm256_fnmadd_ps(b, c, a);
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
vectors! {
    Doubles512: f64, __m512d, "avx512f,avx512dq,avx512vl,avx2,fma";
    _mm512_add_pd, _mm512_sub_pd, _mm512_mul_pd, _mm512_div_pd, _mm512_xor_pd, _mm512_set1_pd, _mm512_sqrt_pd;
    |a, b, c| _mm512_fmadd_pd(b, c, a), _mm512_fnmadd_pd(b, c, a);
}

#[cfg(all(feature = "std", target_arch = "x86_64"))]
vectors! {
    Singles512: f32, __m512, "avx512f,avx512dq,avx512vl,avx2,fma";
    _mm512_add_ps, _mm512_sub_ps, _mm512_mul_ps, _mm512_div_ps, _mm512_xor_ps, _mm512_set1_ps, _mm512_sqrt_ps;
    |a, b, c| _mm512_fmadd_ps(b, c, a), _mm512_fnmadd_ps(b, c, a);
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
        }
    };
}

instructions!(f64, Doubles128, Doubles256, Doubles512);
instructions!(f32, Singles128, Singles256, Singles512);

#[cfg(test)]
mod tests {
    use num_traits::Float;

    use super::{Instructions, is_fused};
    use crate::batch::Vectors;

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

    /// Whether two results are the same number, both of which may be NaN.
    fn are_same<E: Float>(found: E, expected: E) -> bool {
        found.is_nan() && expected.is_nan()
            || found == expected && found.is_sign_negative() == expected.is_sign_negative()
    }

    /// An operation on three numbers alone.
    type Alone<'a, E> = &'a dyn Fn(E, E, E) -> E;

    /// Each operation has the result that it has for each number alone.
    fn agree<const W: usize, const BITS: usize, E: Float + Instructions + core::fmt::Debug>() {
        for first in 0..11 {
            for second in 0..11 {
                let [a, b, c] =
                    [first, second, first + 3 * second].map(|start| core::array::from_fn(|lane| number(start + lane)));
                let fused = |a: E, b: E, c: E| if is_fused(BITS) { b.mul_add(c, a) } else { a + b * c };
                let operations: [([E; W], Alone<'_, E>); 8] = [
                    (E::sum::<W, BITS>(&a, &b), &|a, b, _| a + b),
                    (E::difference::<W, BITS>(&a, &b), &|a, b, _| a - b),
                    (E::product::<W, BITS>(&a, &b), &|a, b, _| a * b),
                    (E::quotient::<W, BITS>(&a, &b), &|a, b, _| a / b),
                    (E::opposite::<W, BITS>(&a), &|a, _, _| -a),
                    (E::square_root::<W, BITS>(&a), &|a, _, _| a.sqrt()),
                    (E::plus_product::<W, BITS>(&a, &b, &c), &fused),
                    (E::minus_product::<W, BITS>(&a, &b, &c), &|a, b, c| fused(a, -b, c)),
                ];
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
