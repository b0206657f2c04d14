//! Polynomials by pairs, which depend less on one another than one step after the other.

/// a b + c, fused where the target has the instruction: elsewhere the exact function is slow.
#[inline(always)]
pub(super) fn multiply_add(a: f64, b: f64, c: f64) -> f64 {
    #[cfg(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64")))]
    {
        num_traits::Float::mul_add(a, b, c)
    }
    #[cfg(not(all(feature = "std", any(target_feature = "fma", target_arch = "aarch64"))))]
    {
        a * b + c
    }
}

/// The value at `z` of the polynomial with these coefficients, that of the lowest power first.
///
/// Estrin's scheme: neighbours are joined, then the pairs by z², then the fours by z⁴.
#[inline(always)]
pub(super) fn polynomial<const N: usize>(coefficients: [f64; N], z: f64) -> f64 {
    let mut terms = coefficients;
    let mut power = z;
    let mut count = N;
    while count > 1 {
        let half = count / 2;
        for pair in 0..half {
            terms[pair] = multiply_add(terms[2 * pair + 1], power, terms[2 * pair]);
        }
        if count % 2 == 1 {
            terms[half] = terms[count - 1];
        }
        count -= half;
        power = power * power;
    }
    terms[0]
}
