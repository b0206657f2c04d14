//! A value and its time derivatives.

mod arithmetic;
mod chain;
mod curve;
mod degrees;
mod direction;
mod entries;
mod given;
mod link;
mod order;

pub use degrees::rpm;
pub use direction::Direction;
pub use given::IntoMotion;
pub use link::LinkMotion;
pub use order::Contains;

use core::array;
use core::ops::{Index, IndexMut};

use crate::geometry::{Plane, Space};
use crate::number::{Number, Row};

/// A value and its first `N - 1` derivatives with respect to time.
///
/// The derivative of order `n` has the unit of the value divided by the `n`-th power of the unit of time: for an angle,
/// radians, radians per second, radians per second squared and so on. The derivatives are not divided by factorials.
///
/// ```
/// use kin_core::Motion;
///
/// // position, velocity, acceleration, jerk and snap of an input
/// let crank = Motion::from((65f64.to_radians(), -10.0, 2.0, -0.5, 0.3));
/// assert_eq!(crank.velocity(), -10.0);
/// assert_eq!(crank.snap(), 0.3);
///
/// // the value alone, when no rate is sought
/// let still = Motion::from([0.5]);
/// assert_eq!(still.value(), 0.5);
///
/// // a crank at constant speed, through jerk
/// let steady: Motion<f64, 4> = Motion::at_constant_speed(0.5, 10.0);
/// assert_eq!(steady.derivatives(), [0.5, 10.0, 0.0, 0.0]);
/// ```
#[doc(alias = "derivative")]
#[doc(alias = "rate")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Motion<T = f64, const N: usize = 5> {
    derivatives: [T; N],
}

impl<T, const N: usize> Motion<T, N> {
    /// The highest order of derivative.
    pub const ORDER: usize = N - 1;

    /// The value followed by its derivatives in ascending order.
    #[inline]
    #[must_use]
    pub const fn new(derivatives: [T; N]) -> Self {
        const { assert!(N > 0, "a motion has a value at least") };
        Self { derivatives }
    }

    /// The value and the derivatives as a slice; the index is the order.
    #[inline]
    #[must_use]
    pub const fn as_slice(&self) -> &[T] {
        &self.derivatives
    }

    /// The motion with `function` applied to the value and to each derivative.
    ///
    /// Use it for linear functions, such as a change of units.
    #[inline]
    #[must_use]
    pub fn map<U>(self, function: impl FnMut(T) -> U) -> Motion<U, N> {
        Motion {
            derivatives: self.derivatives.map(function),
        }
    }
}

impl<T: Copy, const N: usize> Motion<T, N> {
    /// The value, the derivative of order 0.
    #[inline]
    #[must_use]
    pub const fn value(&self) -> T {
        const { assert!(N > 0, "a motion has a value at least") };
        self.derivatives[0]
    }

    /// The value, the derivative of order 0.
    #[inline]
    #[must_use]
    pub const fn position(&self) -> T {
        self.value()
    }

    /// The derivative of the given order, if there is one.
    #[inline]
    #[must_use]
    pub fn derivative(&self, order: usize) -> Option<T> {
        self.derivatives.get(order).copied()
    }

    /// The value followed by its derivatives in ascending order.
    #[inline]
    #[must_use]
    pub const fn derivatives(&self) -> [T; N] {
        self.derivatives
    }

    /// This motion with the first `M` entries only. Asking for more than it has is an error at compile time.
    ///
    /// ```
    /// use kin_core::Motion;
    ///
    /// let crank = Motion::from([0.5, -10.0, 2.0]);
    /// assert_eq!(crank.truncate::<2>(), Motion::from([0.5, -10.0]));
    /// ```
    #[inline]
    #[must_use]
    pub fn truncate<const M: usize>(self) -> Motion<T, M> {
        const {
            assert!(
                0 < M && M <= N,
                "a motion can be cut short, but neither to nothing nor extended"
            );
        };
        Motion {
            derivatives: array::from_fn(|order| self.derivatives[order]),
        }
    }
}

impl<T: Number, const N: usize> Motion<T, N> {
    /// A constant value: every derivative is zero.
    #[inline]
    #[must_use]
    pub fn constant(value: T) -> Self {
        Self::at_constant_speed(value, T::constant(0.0))
    }

    /// A value that changes at constant speed: every derivative beyond the first is zero.
    #[inline]
    #[must_use]
    pub fn at_constant_speed(value: T, speed: T) -> Self {
        Self::new(array::from_fn(|order| match order {
            0 => value,
            1 => speed,
            _ => T::constant(0.0),
        }))
    }

    /// The polynomial `c₀ + c₁ t + c₂ t² + …` and its derivatives at the given time. Motion laws of cams and servo
    /// drives have this form. Without coefficients, the polynomial is zero.
    ///
    /// The method is Horner's scheme, repeated for the derivatives.
    ///
    /// ```
    /// use kin_core::Motion;
    ///
    /// // 1 + t³ at t = 2
    /// let law: Motion<f64, 5> = Motion::polynomial(&[1.0, 0.0, 0.0, 1.0], 2.0);
    /// assert_eq!(law.derivatives(), [9.0, 12.0, 12.0, 6.0, 0.0]);
    /// ```
    #[must_use]
    pub fn polynomial(coefficients: &[T], time: T) -> Self {
        // Until the end, entry n is the n-th derivative divided by n factorial.
        let mut derivatives = [T::constant(0.0); N];
        for coefficient in coefficients.iter().rev() {
            let mut carried = *coefficient;
            for entry in &mut derivatives {
                let lower = *entry;
                *entry = lower * time + carried;
                carried = lower;
            }
        }
        let mut factorial = 1.0;
        let mut order = 0.0;
        for entry in derivatives.iter_mut().skip(1) {
            order += 1.0;
            factorial *= order;
            *entry = *entry * T::constant(factorial);
        }
        Self::new(derivatives)
    }

    /// Whether the value and every derivative are finite, that is neither NaN nor infinite.
    ///
    /// ```
    /// use kin_core::Motion;
    ///
    /// assert!(Motion::from([0.5, -10.0]).is_finite());
    /// assert!(!Motion::from([0.5, f64::NAN]).is_finite());
    /// ```
    #[inline]
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.derivatives.iter().all(|entry| entry.is_finite())
    }

    /// This motion, multiplied by `factor`.
    #[inline]
    #[must_use]
    pub fn scale(self, factor: T) -> Self {
        self.map(|entry| entry * factor)
    }

    /// The sine and cosine of an angle in motion, in this order.
    ///
    /// Each follows from the derivatives of the other: Leibniz's rule differentiates s' = θ' c and c' = -θ' s.
    ///
    /// ```
    /// use kin_core::Motion;
    ///
    /// let (sine, cosine) = Motion::from([0.0, 3.0, 0.0]).sin_cos();
    /// assert_eq!(sine.derivatives(), [0.0, 3.0, 0.0]);
    /// assert_eq!(cosine.derivatives(), [1.0, 0.0, -9.0]);
    /// ```
    #[must_use]
    pub fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = self.value().sin_cos();
        let mut sines = [sine; N];
        let mut cosines = [cosine; N];
        let rates = self.derivatives.get(1..).unwrap_or(&[]);
        for order in 1..N {
            sines[order] = leibniz(&cosines[..order], &rates[..order]);
            cosines[order] = -leibniz(&sines[..order], &rates[..order]);
        }
        (Self::new(sines), Self::new(cosines))
    }

    /// The sine of an angle in motion.
    #[must_use]
    pub fn sin(self) -> Self {
        self.sin_cos().0
    }

    /// The cosine of an angle in motion.
    #[must_use]
    pub fn cos(self) -> Self {
        self.sin_cos().1
    }

    /// The square root: of each derivative of the root times itself, all terms but the highest derivative are known.
    ///
    /// Where the value is zero, the derivatives are infinite or NaN.
    #[must_use]
    pub fn sqrt(self) -> Self {
        let mut root = [T::constant(0.0); N];
        root[0] = self.value().sqrt();
        for order in 1..N {
            // the entry of this order is still zero
            let known = leibniz(&root[..=order], &root[..=order]);
            root[order] = (self.derivatives[order] - known) / (root[0] + root[0]);
        }
        Self::new(root)
    }
}

/// What is chosen by the value. Numbers that hold several poses, which have no order, are left out.
impl<T: Number + PartialOrd, const N: usize> Motion<T, N> {
    /// The size: the motion itself, or its negative if its value is below zero. At zero it has a kink.
    #[must_use]
    pub fn abs(self) -> Self {
        if self.value() < T::constant(0.0) { -self } else { self }
    }

    /// The motion whose value is larger. NaN if one of the values is.
    #[must_use]
    pub fn max(self, other: Self) -> Self {
        if self.value() >= other.value() || self.value().real().is_nan() {
            self
        } else {
            other
        }
    }

    /// The motion whose value is smaller. NaN if one of the values is.
    #[must_use]
    pub fn min(self, other: Self) -> Self {
        if self.value() <= other.value() || self.value().real().is_nan() {
            self
        } else {
            other
        }
    }
}

/// The highest derivative of a product, given both factors up to that order: the sum of the binomial coefficients times
/// `first[k]` times `second[n - k]`.
pub(crate) fn leibniz<T: Number>(first: &[T], second: &[T]) -> T {
    let mut sum = T::constant(0.0);
    let mut binomial = 1.0;
    let mut below = 0.0;
    let mut above = second.len().saturating_sub(1);
    for (left, right) in first.iter().zip(second.iter().rev()) {
        sum = sum + T::constant(binomial) * *left * *right;
        below += 1.0;
        binomial = binomial * count(above) / below;
        above = above.saturating_sub(1);
    }
    sum
}

#[expect(clippy::cast_precision_loss, reason = "orders of derivatives are small numbers")]
fn count(number: usize) -> f64 {
    number as f64
}

/// The value and its derivatives; the index is the order.
impl<T, const N: usize> AsRef<[T]> for Motion<T, N> {
    #[inline]
    fn as_ref(&self) -> &[T] {
        &self.derivatives
    }
}

/// The value and its derivatives; the index is the order.
impl<T, const N: usize> AsMut<[T]> for Motion<T, N> {
    #[inline]
    fn as_mut(&mut self) -> &mut [T] {
        &mut self.derivatives
    }
}

/// The derivative of the given order. Panics if there is none, like an array index out of bounds.
impl<T, const N: usize> Index<usize> for Motion<T, N> {
    type Output = T;

    #[inline]
    fn index(&self, order: usize) -> &T {
        &self.derivatives[order]
    }
}

/// The derivative of the given order. Panics if there is none, like an array index out of bounds.
impl<T, const N: usize> IndexMut<usize> for Motion<T, N> {
    #[inline]
    fn index_mut(&mut self, order: usize) -> &mut T {
        &mut self.derivatives[order]
    }
}

impl<T: Copy, const N: usize> Row<T> for Motion<T, N> {
    const LENGTH: usize = N;

    #[inline]
    fn from_fn(function: impl FnMut(usize) -> T) -> Self {
        Self::new(Row::from_fn(function))
    }

    #[inline]
    fn splat(value: T) -> Self {
        Self::new([value; N])
    }
}

impl<T, const N: usize> From<[T; N]> for Motion<T, N> {
    #[inline]
    fn from(derivatives: [T; N]) -> Self {
        Self::new(derivatives)
    }
}

impl<T, const N: usize> From<Motion<T, N>> for [T; N] {
    #[inline]
    fn from(motion: Motion<T, N>) -> Self {
        motion.derivatives
    }
}

macro_rules! and {
    ($($length:literal -> $longer:literal: $($entry:ident)+;)+) => {
        $(
            impl<T> Motion<T, $length> {
                /// This motion with the next derivative appended.
                #[inline]
                #[must_use]
                pub fn and(self, next: T) -> Motion<T, $longer> {
                    let [$($entry),+] = self.derivatives;
                    Motion::new([$($entry),+, next])
                }
            }
        )+
    };
}

and! {
    1 -> 2: a;
    2 -> 3: a b;
    3 -> 4: a b c;
    4 -> 5: a b c d;
    5 -> 6: a b c d e;
    6 -> 7: a b c d e f;
    7 -> 8: a b c d e f g;
    8 -> 9: a b c d e f g h;
    9 -> 10: a b c d e f g h i;
    10 -> 11: a b c d e f g h i j;
    11 -> 12: a b c d e f g h i j k;
    12 -> 13: a b c d e f g h i j k l;
}

impl<T: Copy, const N: usize> Motion<Plane<T>, N> {
    /// The motion of a point in the plane, from its coordinates.
    #[inline]
    #[must_use]
    pub fn from_coordinates(x: Motion<T, N>, y: Motion<T, N>) -> Self {
        Self::new(array::from_fn(|order| {
            Plane::new(x.derivatives[order], y.derivatives[order])
        }))
    }

    /// The first coordinate of a moving point, or of a vector.
    #[inline]
    #[must_use]
    pub fn x(self) -> Motion<T, N> {
        Row::from_fn(|order| self.derivatives[order].x)
    }

    /// The second coordinate of a moving point, or of a vector.
    #[inline]
    #[must_use]
    pub fn y(self) -> Motion<T, N> {
        Row::from_fn(|order| self.derivatives[order].y)
    }
}

impl<T: Number, const N: usize> Motion<Plane<T>, N> {
    /// Whether both coordinates and all their derivatives are finite, that is neither NaN nor infinite.
    #[inline]
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.derivatives
            .iter()
            .all(|vector| T::are_finite(&[vector.x, vector.y]))
    }
}

impl<T: Copy, const N: usize> Motion<Space<T>, N> {
    /// The motion of a point in space, from its coordinates.
    #[inline]
    #[must_use]
    pub fn from_three_coordinates(x: Motion<T, N>, y: Motion<T, N>, z: Motion<T, N>) -> Self {
        Self::new(array::from_fn(|order| {
            Space::new(x.derivatives[order], y.derivatives[order], z.derivatives[order])
        }))
    }

    /// The first coordinate of a moving point, or of a vector.
    #[inline]
    #[must_use]
    pub fn x(self) -> Motion<T, N> {
        Row::from_fn(|order| self.derivatives[order].x)
    }

    /// The second coordinate of a moving point, or of a vector.
    #[inline]
    #[must_use]
    pub fn y(self) -> Motion<T, N> {
        Row::from_fn(|order| self.derivatives[order].y)
    }

    /// The third coordinate of a moving point, or of a vector.
    #[inline]
    #[must_use]
    pub fn z(self) -> Motion<T, N> {
        Row::from_fn(|order| self.derivatives[order].z)
    }
}

impl<T: Number, const N: usize> Motion<Space<T>, N> {
    /// Whether all coordinates and all their derivatives are finite, that is neither NaN nor infinite.
    #[inline]
    #[must_use]
    pub fn is_finite(&self) -> bool {
        self.derivatives
            .iter()
            .all(|vector| T::are_finite(&[vector.x, vector.y, vector.z]))
    }
}

#[cfg(test)]
mod tests {
    use super::Motion;
    use crate::geometry::{Plane, Space};

    #[test]
    fn tuples_and_arrays_of_every_length() {
        assert_eq!(Motion::from((1.0,)), Motion::from([1.0]));
        assert_eq!(Motion::from((1.0, 2.0)), Motion::from([1.0, 2.0]));
        assert_eq!(Motion::from((1.0, 2.0, 3.0)), Motion::new([1.0, 2.0, 3.0]));
        assert_eq!(Motion::from((1.0, 2.0, 3.0, 4.0)).jerk(), 4.0);
        let crank = Motion::from((65f64.to_radians(), -10.0, 2.0, -0.5, 0.3));
        assert_eq!(crank.snap(), 0.3);
        assert_eq!(Motion::<f64, 5>::ORDER, 4);
        assert_eq!(crank.derivative(4), Some(0.3));
        assert_eq!(crank.derivative(5), None);
    }

    #[test]
    fn appending_reaches_every_accessor() {
        let long = Motion::from([0.0])
            .and(1.0)
            .and(2.0)
            .and(3.0)
            .and(4.0)
            .and(5.0)
            .and(6.0);
        assert_eq!(long.position(), 0.0);
        assert_eq!(long.velocity(), 1.0);
        assert_eq!(long.acceleration(), 2.0);
        assert_eq!(long.jerk(), 3.0);
        assert_eq!(long.snap(), 4.0);
        assert_eq!(long.crackle(), 5.0);
        assert_eq!(long.pop(), 6.0);
        let longest = long.and(7.0).and(8.0).and(9.0).and(10.0).and(11.0).and(12.0);
        assert_eq!(longest.pop(), 6.0);
        assert_eq!(longest.derivative_7(), 7.0);
        assert_eq!(longest.derivative_8(), 8.0);
        assert_eq!(longest.derivative_9(), 9.0);
        assert_eq!(longest.derivative_10(), 10.0);
        assert_eq!(longest.derivative_11(), 11.0);
        assert_eq!(longest.derivative_12(), 12.0);
        assert_eq!(long.truncate::<2>(), Motion::from([0.0, 1.0]));
    }

    #[test]
    fn products_of_powers_are_powers() {
        let square = Motion::<f64, 5>::polynomial(&[0.0, 0.0, 1.0], 1.5);
        let cube = Motion::<f64, 5>::polynomial(&[0.0, 0.0, 0.0, 1.0], 1.5);
        let fifth = Motion::<f64, 5>::polynomial(&[0.0, 0.0, 0.0, 0.0, 0.0, 1.0], 1.5);
        for (product, power) in (square * cube).as_slice().iter().zip(fifth.as_slice()) {
            assert!((product - power).abs() <= 1e-13 * power.abs());
        }
        assert_eq!(Motion::<f64, 3>::polynomial(&[], 2.0), Motion::constant(0.0));
    }

    #[test]
    fn sine_and_cosine_satisfy_pythagoras_to_every_order() {
        let angle = Motion::from([0.7, -10.0, 2.0, -0.5, 0.3, 4.0]);
        let (sine, cosine) = angle.sin_cos();
        let one = sine * sine + cosine * cosine;
        let size = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5];
        for (order, (entry, size)) in one.as_slice().iter().zip(size).enumerate() {
            let expected: f64 = if order == 0 { 1.0 } else { 0.0 };
            assert!((entry - expected).abs() < 1e-13 * size * 30.0, "order {order}");
        }
        // The second derivative of the sine of an angle at constant speed.
        let (sine, _) = Motion::<f64, 3>::at_constant_speed(0.7, 2.0).sin_cos();
        assert!((sine.acceleration() + 4.0 * sine.value()).abs() < 1e-15);
    }

    #[test]
    fn points_have_coordinates() {
        let x = Motion::from([1.0, 2.0]);
        let y = Motion::from([3.0, 4.0]);
        let point = Motion::from_coordinates(x, y);
        assert_eq!(point.velocity(), Plane::new(2.0, 4.0));
        assert_eq!((point.x(), point.y()), (x, y));
        assert!(point.is_finite());
        assert!(!Motion::from_coordinates(x, y.scale(f64::INFINITY)).is_finite());
        assert_eq!((point + point - point).x(), x);
        assert_eq!((-point).y(), -y);
        assert_eq!(x.scale(2.0), x + x);
    }

    #[test]
    fn points_of_space_have_three_coordinates() {
        let [x, y, z] = [[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]].map(Motion::from);
        let point = Motion::from_three_coordinates(x, y, z);
        assert_eq!(point.velocity(), Space::new(2.0, 4.0, 6.0));
        assert_eq!((point.x(), point.y(), point.z()), (x, y, z));
        assert!(point.is_finite());
        assert!(!Motion::from_three_coordinates(x, y, z.scale(f64::INFINITY)).is_finite());
    }

    /// Coordinates may be finite though their sum is not, and each may be the one that is not.
    #[test]
    fn points_are_finite_if_their_coordinates_are() {
        let (most, none) = (Motion::from([1.0, f64::MAX]), Motion::from([1.0, f64::NAN]));
        assert!(Motion::from_coordinates(most, most).is_finite());
        assert!(Motion::from_three_coordinates(most, most, most).is_finite());
        for [x, y, z] in [[none, most, most], [most, none, most], [most, most, none]] {
            assert!(!Motion::from_three_coordinates(x, y, z).is_finite());
            assert!(!Motion::from_coordinates(x, y + z).is_finite());
        }
    }
}
