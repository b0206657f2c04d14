//! The inverses of the hyperbolic cosine and tangent.
//!
//! The standard library computes these functions by logarithms that lose digits: near 1 the inverse cosine takes the
//! logarithm of a number near 1, and near -1 the inverse tangent takes the logarithm of a number near 0. The formulas
//! here come from the C library fdlibm.

use num_traits::Float;

/// The non-negative number whose hyperbolic cosine is `x`; NaN for x < 1.
pub(super) fn area_hyperbolic_cosine<F: Float>(x: F) -> F {
    let one = F::one();
    let two = one + one;
    let beyond = x - one;
    if x < one {
        F::nan()
    } else if x < two {
        // The difference x - 1 is exact.
        (beyond + (beyond * (x + one)).sqrt()).ln_1p()
    } else if x < one / F::epsilon() {
        (x + (beyond * (x + one)).sqrt()).ln()
    } else {
        // The product 2 x could overflow.
        x.ln() + two.ln()
    }
}

/// The number whose hyperbolic tangent is `x`; NaN for |x| > 1.
pub(super) fn area_hyperbolic_tangent<F: Float>(x: F) -> F {
    let size = x.abs();
    let ratio = (size + size) / (F::one() - size);
    (ratio.ln_1p() / (F::one() + F::one())).copysign(x)
}

#[cfg(test)]
mod tests {
    use super::{area_hyperbolic_cosine, area_hyperbolic_tangent};

    /// The expected values were computed to fifty digits and rounded.
    #[test]
    fn digits_are_kept_near_the_ends() {
        for (x, expected) in [
            (1.0, 0.0),
            (1.0 + 1.0 / 1_099_511_627_776.0, 1.348_699_152_348_506_8e-6),
            (1.5, 0.962_423_650_119_206_9),
            (2.0, 1.316_957_896_924_816_8),
            (1e300, 691.468_675_078_773_7),
            (f64::MAX, 710.475_860_073_944),
        ] {
            let found: f64 = area_hyperbolic_cosine(x);
            assert!(
                (found - expected).abs() <= 2.0 * f64::EPSILON * expected,
                "{x}: {found:e} {expected:e}"
            );
        }
        for (x, expected) in [
            (1e-300, 1e-300),
            (1e-9, 1e-9),
            (0.5, 0.549_306_144_334_054_9),
            (1.0 - 1.0 / 1_099_511_627_776.0, 14.209_517_201_478_65),
        ] {
            for sign in [1.0, -1.0] {
                let found: f64 = area_hyperbolic_tangent(sign * x);
                let expected: f64 = sign * expected;
                assert!(
                    (found - expected).abs() <= 2.0 * f64::EPSILON * expected.abs(),
                    "{x}: {found:e} {expected:e}"
                );
            }
        }
    }

    #[test]
    fn outside_they_are_not_defined() {
        for x in [1.0 - f64::EPSILON, 0.0, -2.0, f64::NAN] {
            assert!(area_hyperbolic_cosine(x).is_nan());
        }
        for x in [1.0 + f64::EPSILON, -1.5, f64::NAN] {
            assert!(area_hyperbolic_tangent(x).is_nan());
        }
        assert_eq!(area_hyperbolic_tangent(1.0_f64), f64::INFINITY);
        assert_eq!(area_hyperbolic_cosine(f64::INFINITY), f64::INFINITY);
    }
}
