//! Numbers, and rows of them.

mod changing;
#[doc(hidden)]
#[cfg(feature = "std")]
pub mod count;
pub(crate) mod elementary;
#[cfg(feature = "alloc")]
mod gauss;
mod hyperbolic;
#[cfg(feature = "alloc")]
mod number_row;
mod operations;
pub(crate) mod plain;
mod primitive;
mod range;
mod row;
#[cfg(test)]
pub(crate) mod samples;
pub(crate) mod scatter;
pub mod series;
mod single;
#[cfg(feature = "alloc")]
mod singular_values;

pub use changing::Changing;
#[cfg(feature = "alloc")]
pub(crate) use gauss::GAUSS;
#[cfg(feature = "alloc")]
pub(crate) use number_row::NumberRow;
pub use operations::Operations;
pub use range::ClosedRange;
pub use row::Row;
pub(crate) use row::at_constant_rate;
pub(crate) use single::single;
#[cfg(feature = "alloc")]
pub(crate) use singular_values::{shifted, singular_values};

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A number with the functions that kinematics needs. The trait [`Scalar`](crate::Scalar) adds decisions.
///
/// Implemented for `f32` and `f64`, for the truncated series of [`series`](crate::series), for
/// the operation counter of `count` (feature `std`), and for the dual numbers of `num-dual` (feature `num-dual`).
/// Angles are in radians.
///
/// Functions follow IEEE 754: outside their domain they return NaN. If an argument might lie outside, test its [real
/// part](Number::real) first.
///
/// ```
/// use kin_core::Number;
///
/// fn diagonal<T: Number>(width: T, height: T) -> T {
///     (width * width + height * height).sqrt()
/// }
///
/// assert_eq!(diagonal(3.0_f64, 4.0), 5.0);
/// assert_eq!(diagonal(3.0_f32, 4.0), 5.0);
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a number for which a mechanism is solved",
    label = "write `f64` or `f32`, and numbers with a decimal point: `1.0` instead of `1`"
)]
pub trait Number:
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

    /// The smallest positive real part that may be a divisor. From here up to its reciprocal, numbers and their
    /// reciprocals have full precision.
    // Twice `MIN_POSITIVE`: LLVM converts a comparison with `MIN_POSITIVE` itself into integer tests, lane by lane.
    const SMALLEST_DIVISOR: f64 = 2.0 * f64::MIN_POSITIVE;

    /// The number of successive derivatives that the number carries besides its real part: 0 for a plain number, n for
    /// a series up to the n-th power of time. Iterations continue until the highest derivative is right.
    const ORDER: usize = 0;

    /// The number with the given real part and nothing else, rounded to the precision of the type.
    #[must_use]
    fn constant(value: f64) -> Self;

    /// The real part. Errors report it, and a single pose decides by it. A number that holds several poses returns the
    /// real part of the first.
    #[must_use]
    fn real(self) -> f64;

    /// Whether every part of the number is finite, that is neither NaN nor infinite.
    ///
    /// A number that holds several poses always returns true, because each pose is tested by itself: a pose that fails
    /// becomes NaN, and the caller looks for NaN.
    #[must_use]
    fn is_finite(self) -> bool;

    /// Whether every part of all these numbers is finite.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn are_finite(numbers: &[Self]) -> bool {
        let mut are_finite = true;
        #[expect(
            clippy::needless_range_loop,
            reason = "it stands at thousands of calls, and iterators take a compiler longer"
        )]
        for index in 0..numbers.len() {
            are_finite &= numbers[index].is_finite();
        }
        are_finite
    }

    /// The non-negative square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// The sine and cosine of an angle, in this order.
    #[must_use]
    fn sin_cos(self) -> (Self, Self);

    /// The sine of an angle. [`sin_cos`](Self::sin_cos) calculates the cosine with it.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// The cosine of an angle.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn cos(self) -> Self {
        self.sin_cos().1
    }

    /// The tangent of an angle.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn tan(self) -> Self {
        let (sine, cosine) = self.sin_cos();
        sine / cosine
    }

    /// The angle in -π/2 ..= π/2 whose sine is this number.
    #[must_use]
    fn asin(self) -> Self;

    /// The angle in 0 ..= π whose cosine is this number.
    #[must_use]
    fn acos(self) -> Self;

    /// The angle between -π/2 and π/2 whose tangent is this number.
    #[must_use]
    fn atan(self) -> Self;

    /// The angle in -π ..= π from the x axis to the point (`x`, `self`).
    #[must_use]
    fn atan2(self, x: Self) -> Self;

    /// [`atan2`](Self::atan2) of two points.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn atan2_of_two(y: [Self; 2], x: [Self; 2]) -> [Self; 2] {
        [y[0].atan2(x[0]), y[1].atan2(x[1])]
    }

    /// The hyperbolic sine.
    #[must_use]
    fn sinh(self) -> Self;

    /// The hyperbolic cosine.
    #[must_use]
    fn cosh(self) -> Self;

    /// The hyperbolic tangent.
    #[must_use]
    fn tanh(self) -> Self;

    /// The number whose hyperbolic sine is this number.
    #[must_use]
    fn asinh(self) -> Self;

    /// The non-negative number whose hyperbolic cosine is this number.
    #[must_use]
    fn acosh(self) -> Self;

    /// The number whose hyperbolic tangent is this number.
    #[must_use]
    fn atanh(self) -> Self;

    /// The exponential function.
    #[must_use]
    fn exp(self) -> Self;

    /// The natural logarithm.
    #[must_use]
    fn ln(self) -> Self;

    /// An integer power, by repeated squaring.
    ///
    /// ```
    /// use kin_core::Number;
    ///
    /// assert_eq!(Number::powi(2.0_f64, 10), 1024.0);
    /// assert_eq!(Number::powi(2.0_f64, -2), 0.25);
    /// assert_eq!(Number::powi(0.0_f64, 0), 1.0);
    /// ```
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn powi(self, exponent: i32) -> Self {
        let mut product = None;
        let (mut square, mut rest) = (self, exponent.unsigned_abs());
        while rest > 0 {
            if rest & 1 == 1 {
                product = Some(product.map_or(square, |before: Self| before * square));
            }
            rest >>= 1;
            if rest > 0 {
                square = square * square;
            }
        }
        let one = Self::constant(1.0);
        let product = product.unwrap_or(one);
        if exponent < 0 { one / product } else { product }
    }

    /// The sum `self + a b`, rounded once instead of twice where the machine can.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn plus_product(self, a: Self, b: Self) -> Self {
        self + a * b
    }

    /// The difference `self - a b`, rounded once instead of twice where the machine can.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn minus_product(self, a: Self, b: Self) -> Self {
        self - a * b
    }
}

/// The real parts of some numbers. `map` of an array takes a compiler ten times as long as this loop, and each test of
/// a solver has one.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn real_parts<T: Number, const N: usize>(numbers: [T; N]) -> [f64; N] {
    let mut parts = [0.0; N];
    for index in 0..N {
        parts[index] = numbers[index].real();
    }
    parts
}
