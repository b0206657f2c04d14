//! The primitive number types.

use num_traits::Float;

use crate::number::{
    Number,
    elementary::{
        FUSED, arc_tangent, arc_tangent_single, arc_tangents, arc_tangents_single, sine_cosine, sine_cosine_single,
    },
    hyperbolic::{area_hyperbolic_cosine, area_hyperbolic_tangent},
    single,
};

macro_rules! primitive {
    ($float:ty, $from_f64:expr, $sine_cosine:expr, $arc_tangent:expr, $arc_tangents:expr) => {
        impl Number for $float {
            const EPSILON: f64 = <$float>::EPSILON as f64;
            const SMALLEST_DIVISOR: f64 = 2.0 * <$float>::MIN_POSITIVE as f64;

            #[inline]
            fn constant(value: f64) -> Self {
                $from_f64(value)
            }

            #[inline]
            fn real(self) -> f64 {
                f64::from(self)
            }

            #[inline]
            fn is_finite(self) -> bool {
                <$float>::is_finite(self)
            }

            /// Tests the sum, which is not finite if one of the numbers is not. The numbers themselves are tested only
            /// if the sum is not finite, because the sum alone may overflow.
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn are_finite(numbers: &[Self]) -> bool {
                let mut sum = -0.0;
                for index in 0..numbers.len() {
                    sum += numbers[index];
                }
                <$float>::is_finite(sum) || numbers.iter().all(|number| number.is_finite())
            }

            #[inline]
            fn sqrt(self) -> Self {
                Float::sqrt(self)
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                $sine_cosine(self)
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn plus_product(self, a: Self, b: Self) -> Self {
                if FUSED {
                    Float::mul_add(a, b, self)
                } else {
                    self + a * b
                }
            }

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn minus_product(self, a: Self, b: Self) -> Self {
                if FUSED {
                    Float::mul_add(-a, b, self)
                } else {
                    self - a * b
                }
            }

            #[inline]
            fn asin(self) -> Self {
                Float::asin(self)
            }

            #[inline]
            fn acos(self) -> Self {
                Float::acos(self)
            }

            #[inline]
            fn atan(self) -> Self {
                Float::atan(self)
            }

            #[inline]
            fn atan2(self, x: Self) -> Self {
                $arc_tangent(self, x)
            }

            #[inline]
            fn atan2_of_two(y: [Self; 2], x: [Self; 2]) -> [Self; 2] {
                $arc_tangents(y, x)
            }

            #[inline]
            fn sinh(self) -> Self {
                Float::sinh(self)
            }

            #[inline]
            fn cosh(self) -> Self {
                Float::cosh(self)
            }

            #[inline]
            fn tanh(self) -> Self {
                Float::tanh(self)
            }

            #[inline]
            fn asinh(self) -> Self {
                Float::asinh(self)
            }

            #[inline]
            fn acosh(self) -> Self {
                area_hyperbolic_cosine(self)
            }

            #[inline]
            fn atanh(self) -> Self {
                area_hyperbolic_tangent(self)
            }

            #[inline]
            fn exp(self) -> Self {
                Float::exp(self)
            }

            #[inline]
            fn ln(self) -> Self {
                Float::ln(self)
            }
        }
    };
}

primitive!(f64, core::convert::identity, sine_cosine, arc_tangent, arc_tangents);
primitive!(f32, single, sine_cosine_single, arc_tangent_single, arc_tangents_single);

#[cfg(test)]
mod tests {
    use super::Number;

    #[test]
    fn large_angles_are_reduced_exactly() {
        // The expected values are sin(10^6) and cos(10^6) to 20 digits.
        let (sine, cosine) = Number::sin_cos(1.0e6_f64);
        assert!((sine - -0.349_993_502_171_292_95).abs() < 1e-16);
        assert!((cosine - 0.936_752_127_533_144_8).abs() < 2e-16);
    }

    #[test]
    fn constants_are_rounded_to_the_precision_at_hand() {
        let tenth = <f32 as Number>::constant(0.1);
        assert_eq!(tenth.to_bits(), 0.1_f32.to_bits());
        assert!(!<f32 as Number>::is_finite(Number::constant(1e300)));
    }

    #[test]
    fn numbers_are_finite_together_if_each_is() {
        assert!(f64::are_finite(&[]) && f64::are_finite(&[1.0]));
        assert!(
            f64::are_finite(&[f64::MAX, f64::MAX, -f64::MAX]),
            "though their sum is not"
        );
        for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for wrong_at in 0..4 {
                let mut numbers = [1.0, f64::MAX, -3.0, 0.0];
                numbers[wrong_at] = wrong;
                assert!(!f64::are_finite(&numbers), "{numbers:?}");
            }
        }
        assert!(!f64::are_finite(&[f64::INFINITY, f64::NEG_INFINITY]));
    }

    #[test]
    fn real_parts_widen_without_loss() {
        assert_eq!(0.1_f32.real().to_bits(), f64::from(0.1_f32).to_bits());
    }
}
