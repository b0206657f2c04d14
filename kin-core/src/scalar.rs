//! What a number must offer to be solved with.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

use num_traits::Float;

use crate::Failure;
use crate::elementary::{
    FUSED, arc_tangent, arc_tangent_single, arc_tangents, arc_tangents_single, sine_cosine, sine_cosine_single,
};
use crate::solve::damped_root;

/// A number that a mechanism can be solved with.
///
/// Implemented for `f32` and `f64`, for the truncated series of [`series`](crate::series), for
/// the operation counter of `count` (feature `std`), and for the dual numbers of `num-dual` (feature `num-dual`).
/// Angles are in radians.
///
/// Functions follow IEEE 754: outside of their domain they return NaN. Whoever calls them with a
/// value that might lie outside asks first, on the [real part](Scalar::real).
///
/// ```
/// use kin_core::Scalar;
///
/// fn diagonal<T: Scalar>(width: T, height: T) -> T {
///     (width * width + height * height).sqrt()
/// }
///
/// assert_eq!(diagonal(3.0_f64, 4.0), 5.0);
/// assert_eq!(diagonal(3.0_f32, 4.0), 5.0);
/// ```
pub trait Scalar:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + 'static
{
    /// The distance from 1 to the next larger real part.
    const EPSILON: f64;

    /// The smallest positive real part that is divided by. From it to its reciprocal, numbers and their reciprocals have full
    /// precision.
    // Twice the smallest number that has: a comparison with that one is taken for a test of bits, and done by integers, lane by lane.
    const SMALLEST: f64 = 2.0 * f64::MIN_POSITIVE;

    /// How many successive derivatives the number carries beside its real part: 0 for a plain number, n for a series
    /// through the n-th power of time. An iteration goes on until the highest of them is right.
    const ORDER: usize = 0;

    /// The part of its terms that a sum must exceed for its sign to decide anything: zero for a number that stands for one pose, which
    /// always decides.
    ///
    /// Several poses at once are rounded differently from one pose alone, so that a sum near zero may have another sign there. Such a sum
    /// makes its pose NaN, and the solver of one pose decides about it.
    const DOUBT: f64 = 0.0;

    /// The number with the given real part and no other part, rounded to the precision at hand.
    #[must_use]
    fn constant(value: f64) -> Self;

    /// The real part: decisions are taken on it, and errors report it.
    #[must_use]
    fn real(self) -> f64;

    /// Whether every part of the number is finite, that is neither NaN nor infinite.
    #[must_use]
    fn is_finite(self) -> bool;

    /// Whether every part of all of them is finite.
    #[must_use]
    #[inline(always)]
    fn are_finite<const N: usize>(numbers: [Self; N]) -> bool {
        numbers.into_iter().all(Self::is_finite)
    }

    /// The non-negative square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// Sine and cosine of an angle, in this order.
    #[must_use]
    fn sin_cos(self) -> (Self, Self);

    /// The angle in -π/2 ..= π/2 of which this is the sine.
    #[must_use]
    fn asin(self) -> Self;

    /// The angle in 0 ..= π of which this is the cosine.
    #[must_use]
    fn acos(self) -> Self;

    /// The angle between -π/2 and π/2 of which this is the tangent.
    #[must_use]
    fn atan(self) -> Self;

    /// The angle in -π ..= π from the x axis to the point (`x`, `self`).
    #[must_use]
    fn atan2(self, x: Self) -> Self;

    /// [`atan2`](Self::atan2) of two points.
    #[must_use]
    #[inline(always)]
    fn atan2_of_two(y: [Self; 2], x: [Self; 2]) -> [Self; 2] {
        [y[0].atan2(x[0]), y[1].atan2(x[1])]
    }

    /// The exponential function.
    #[must_use]
    fn exp(self) -> Self;

    /// The natural logarithm.
    #[must_use]
    fn ln(self) -> Self;

    /// This number and the product of two others: `self + a b`, rounded once instead of twice where the machine can.
    #[must_use]
    #[inline(always)]
    fn plus_product(self, a: Self, b: Self) -> Self {
        self + a * b
    }

    /// This number less the product of two others: `self - a b`, rounded once instead of twice where the machine can.
    #[must_use]
    #[inline(always)]
    fn minus_product(self, a: Self, b: Self) -> Self {
        self - a * b
    }

    /// The number itself if all conditions on the real parts of the judges hold, and none if they do not.
    ///
    /// This and what follows are how a solver decides. A number that stands for several poses at once, as in a
    /// [batch](crate::batch), decides for each: it keeps the poses that pass, and makes the others NaN.
    #[inline(always)]
    fn provided<const N: usize, const K: usize>(
        self,
        judges: [Self; N],
        conditions: impl Fn([f64; N]) -> [bool; K],
    ) -> Option<Self> {
        let conditions = conditions(judges.map(Self::real));
        conditions.iter().all(|holds| *holds).then_some(self)
    }

    /// One value if the judges pass a test, the other one if they do not.
    #[inline(always)]
    fn either<const N: usize>(
        judges: [Self; N],
        test: impl Fn([f64; N]) -> bool,
        one: impl FnOnce() -> Self,
        other: impl FnOnce() -> Self,
    ) -> Self {
        if test(judges.map(Self::real)) { one() } else { other() }
    }

    /// This number, or its negative if the real part of the other is negative; either if that is zero.
    #[must_use]
    #[inline(always)]
    fn times_sign_of(self, other: Self) -> Self {
        Self::either([other], |[other]| other < 0.0, || -self, || self)
    }

    /// A constant that depends on the real parts of other numbers.
    #[must_use]
    #[inline(always)]
    fn constant_of<const N: usize>(judges: [Self; N], function: impl Fn([f64; N]) -> f64) -> Self {
        Self::constant(function(judges.map(Self::real)))
    }

    /// A decision for the whole of the number, on real parts. A number that stands for several poses fails if they do not agree.
    ///
    /// # Errors
    /// Those of the decision.
    #[inline(always)]
    fn decided<const N: usize, R: PartialEq>(
        judges: [Self; N],
        decision: impl Fn([f64; N]) -> Result<R, Failure>,
    ) -> Result<R, Failure> {
        decision(judges.map(Self::real))
    }

    /// The root that [`solve::newton`](crate::solve::newton()) finds; the arguments are its own.
    ///
    /// # Errors
    /// Those of the method.
    #[inline]
    fn root<const N: usize>(
        guess: [Self; N],
        sizes: [Self; N],
        evaluate: impl FnMut([Self; N]) -> ([Self; N], [[Self; N]; N]),
    ) -> Result<[Self; N], Failure> {
        damped_root(guess, sizes, evaluate)
    }
}

macro_rules! primitive_scalar {
    ($float:ty, $from_f64:expr, $sine_cosine:expr, $arc_tangent:expr, $arc_tangents:expr) => {
        impl Scalar for $float {
            const EPSILON: f64 = <$float>::EPSILON as f64;
            const SMALLEST: f64 = 2.0 * <$float>::MIN_POSITIVE as f64;

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

            /// By their sum, which is not finite if one of them is not; the numbers themselves are looked at only if the sum is
            /// not finite, which it may be by its size.
            #[inline(always)]
            fn are_finite<const N: usize>(numbers: [Self; N]) -> bool {
                let sum = numbers.into_iter().reduce(|sum, number| sum + number);
                sum.is_none_or(<$float>::is_finite) || numbers.into_iter().all(<$float>::is_finite)
            }

            #[inline]
            fn sqrt(self) -> Self {
                Float::sqrt(self)
            }

            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                $sine_cosine(self)
            }

            #[inline(always)]
            fn plus_product(self, a: Self, b: Self) -> Self {
                if FUSED {
                    Float::mul_add(a, b, self)
                } else {
                    self + a * b
                }
            }

            #[inline(always)]
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

primitive_scalar!(f64, core::convert::identity, sine_cosine, arc_tangent, arc_tangents);
primitive_scalar!(f32, single, sine_cosine_single, arc_tangent_single, arc_tangents_single);

#[expect(
    clippy::cast_possible_truncation,
    reason = "rounding to the nearest single-precision number is what is asked for"
)]
#[inline]
pub(crate) fn single(value: f64) -> f32 {
    value as f32
}

#[cfg(test)]
mod tests {
    use super::Scalar;

    #[test]
    fn large_angles_are_reduced_exactly() {
        // sin(10^6) and cos(10^6) to 20 digits.
        let (sine, cosine) = Scalar::sin_cos(1.0e6_f64);
        assert!((sine - -0.349_993_502_171_292_95).abs() < 1e-16);
        assert!((cosine - 0.936_752_127_533_144_8).abs() < 2e-16);
    }

    #[test]
    fn constants_are_rounded_to_the_precision_at_hand() {
        let tenth = <f32 as Scalar>::constant(0.1);
        assert_eq!(tenth.to_bits(), 0.1_f32.to_bits());
        assert!(!<f32 as Scalar>::is_finite(Scalar::constant(1e300)));
    }

    #[test]
    fn numbers_are_finite_together_if_each_is() {
        assert!(f64::are_finite([]) && f64::are_finite([1.0]));
        assert!(
            f64::are_finite([f64::MAX, f64::MAX, -f64::MAX]),
            "though their sum is not"
        );
        for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for place in 0..4 {
                let mut numbers = [1.0, f64::MAX, -3.0, 0.0];
                numbers[place] = wrong;
                assert!(!f64::are_finite(numbers), "{numbers:?}");
            }
        }
        assert!(!f64::are_finite([f64::INFINITY, f64::NEG_INFINITY]));
    }

    #[test]
    fn real_parts_widen_without_loss() {
        assert_eq!(0.1_f32.real().to_bits(), f64::from(0.1_f32).to_bits());
    }
}
