//! Polynomials evaluated in pairs, so that fewer steps wait for each other.

use num_traits::Float;

/// Whether multiply-add is one instruction wherever the program runs. Elsewhere the exact function is slow.
///
/// A function compiled for a machine with that instruction, and called only there, may choose fusion even where this is
/// false.
pub(crate) const FUSED: bool = cfg!(all(
    feature = "std",
    any(target_feature = "fma", target_arch = "aarch64")
));

/// The number a b + c, rounded once if `FUSED`.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn multiply_add<const FUSED: bool, E: Float>(a: E, b: E, c: E) -> E {
    if FUSED { a.mul_add(b, c) } else { a * b + c }
}

/// The value at `z` of the polynomial with these coefficients, lowest power first.
///
/// Estrin's scheme joins neighbours first, then pairs by z², then fours by z⁴.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn polynomial<const FUSED: bool, const N: usize, E: Float>(coefficients: [E; N], z: E) -> E {
    if FUSED {
        return by_halves(coefficients, z);
    }
    let mut terms = coefficients;
    let mut power = z;
    let mut count = N;
    while count > 1 {
        let half = count / 2;
        for pair in 0..half {
            terms[pair] = multiply_add::<FUSED, E>(terms[2 * pair + 1], power, terms[2 * pair]);
        }
        if count % 2 == 1 {
            terms[half] = terms[count - 1];
        }
        count -= half;
        power = power * power;
    }
    terms[0]
}

/// The value computed from the even and the odd powers, each by Horner's scheme in z². This takes one instruction per
/// coefficient where multiply-add is one instruction.
#[cfg_attr(not(debug_assertions), inline(always))]
fn by_halves<const N: usize, E: Float>(coefficients: [E; N], z: E) -> E {
    let square = z * z;
    let (mut even, mut odd) = if N.is_multiple_of(2) {
        (coefficients[N - 2], coefficients[N - 1])
    } else {
        (coefficients[N - 1], E::zero())
    };
    let mut index = if N.is_multiple_of(2) { N - 2 } else { N - 1 };
    while index >= 2 {
        odd = multiply_add::<true, E>(odd, square, coefficients[index - 1]);
        even = multiply_add::<true, E>(even, square, coefficients[index - 2]);
        index -= 2;
    }
    multiply_add::<true, E>(odd, z, even)
}

#[cfg(test)]
mod tests {
    use super::polynomial;

    fn is_exact<const N: usize>() {
        let digits = [3.0, -1.0, 4.0, 1.0, -5.0, 9.0, -2.0, 6.0, 5.0, -3.0, 5.0, 8.0];
        let coefficients: [f64; N] = core::array::from_fn(|power| digits[power]);
        for z in [0.0, 1.0, -2.0, 3.0, 0.5] {
            let expected = coefficients
                .iter()
                .rev()
                .fold(0.0, |sum, coefficient| sum * z + coefficient);
            assert_eq!(polynomial::<false, N, f64>(coefficients, z), expected, "{N} {z}");
            assert_eq!(polynomial::<true, N, f64>(coefficients, z), expected, "{N} {z}, fused");
        }
    }

    /// Small whole numbers are never rounded, so every order of evaluation must give the same result.
    #[test]
    fn all_orders_of_evaluation_agree() {
        is_exact::<1>();
        is_exact::<2>();
        is_exact::<3>();
        is_exact::<4>();
        is_exact::<5>();
        is_exact::<6>();
        is_exact::<7>();
        is_exact::<11>();
        is_exact::<12>();
    }
}
