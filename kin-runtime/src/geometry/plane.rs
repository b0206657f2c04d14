//! Vectors in the plane, represented as complex numbers.

use core::ops::{Add, Neg, Sub};

use crate::number::Number;

/// A vector in the plane, or the complex number `x + i y`.
///
/// Both coordinates have the same unit. A direction is a vector of length 1: the cosine and sine of its angle.
/// [`times`](Plane::times) rotates one vector by another.
///
/// ```
/// use kin_core::Plane;
///
/// let arm = Plane::new(3.0, 4.0);
/// let quarter_turn = Plane::new(0.0, 1.0);
/// assert_eq!(arm.norm_squared(), 25.0);
/// assert_eq!(arm.times(quarter_turn), Plane::new(-4.0, 3.0));
/// assert_eq!(arm.cross(Plane::new(-4.0, 3.0)), 25.0);
/// ```
#[doc(alias = "Vec2")]
#[doc(alias = "Point")]
#[doc(alias = "Complex")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Plane<T = f64> {
    /// The first coordinate, or the real part.
    pub x: T,
    /// The second coordinate, or the imaginary part.
    pub y: T,
}

impl<T> Plane<T> {
    /// The vector with the coordinates `x` and `y`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub const fn new(x: T, y: T) -> Self {
        Self { x, y }
    }
}

impl<T: Number> Plane<T> {
    /// The vector of length 0.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn zero() -> Self {
        Self::new(T::constant(0.0), T::constant(0.0))
    }

    /// The unit vector at an angle, in radians: the complex number cos + i sin.
    ///
    /// ```
    /// use kin_core::Plane;
    ///
    /// assert_eq!(Plane::cis(0.0_f64), Plane::new(1.0, 0.0));
    /// ```
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn cis(angle: T) -> Self {
        let (sine, cosine) = angle.sin_cos();
        Self::new(cosine, sine)
    }

    /// The vector with a given length and angle, in radians.
    ///
    /// ```
    /// use kin_core::Plane;
    ///
    /// let link = Plane::polar(2.0_f64, core::f64::consts::FRAC_PI_2);
    /// assert!((link - Plane::new(0.0, 2.0)).norm() < 1e-15);
    /// ```
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn polar(length: T, angle: T) -> Self {
        Self::cis(angle).scale(length)
    }

    /// The scalar product `x₁ x₂ + y₁ y₂`. Its unit is the product of the units.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn dot(self, other: Self) -> T {
        self.x * other.x + self.y * other.y
    }

    /// The vector product `x₁ y₂ - y₁ x₂`: the component normal to the plane. It is positive if `other` lies
    /// counter-clockwise from this vector.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn cross(self, other: Self) -> T {
        self.x * other.y - self.y * other.x
    }

    /// This vector, multiplied by `factor`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn scale(self, factor: T) -> Self {
        Self::new(self.x * factor, self.y * factor)
    }

    /// The square of the length.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn norm_squared(self) -> T {
        self.dot(self)
    }

    /// The length. Its square must lie in the range of the number type.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn norm(self) -> T {
        self.norm_squared().sqrt()
    }

    /// The product of complex numbers: lengths multiply, angles add.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        Self::new(self.x * other.x - self.y * other.y, self.x * other.y + self.y * other.x)
    }
}

impl<T: Number> Add for Plane<T> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y)
    }
}

impl<T: Number> Sub for Plane<T> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y)
    }
}

impl<T: Number> Neg for Plane<T> {
    type Output = Self;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y)
    }
}

impl<T> From<[T; 2]> for Plane<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn from([x, y]: [T; 2]) -> Self {
        Self::new(x, y)
    }
}

impl<T> From<Plane<T>> for [T; 2] {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn from(vector: Plane<T>) -> Self {
        [vector.x, vector.y]
    }
}

#[cfg(test)]
mod tests {
    use super::Plane;

    const A: Plane = Plane::new(2.0, -1.0);
    const B: Plane = Plane::new(3.0, 5.0);

    #[test]
    fn sums_and_differences() {
        assert_eq!(A + B, Plane::new(5.0, 4.0));
        assert_eq!(A - B, Plane::new(-1.0, -6.0));
        assert_eq!(-A, Plane::new(-2.0, 1.0));
        assert_eq!(A.scale(3.0), Plane::new(6.0, -3.0));
        assert_eq!(Plane::new(3.0, -4.0).norm(), 5.0);
    }

    #[test]
    fn conjugate_product_holds_both_products() {
        let product = Plane::new(A.x, -A.y).times(B);
        assert_eq!(product, Plane::new(A.dot(B), A.cross(B)));
    }

    #[test]
    fn arrays_convert_both_ways() {
        assert_eq!(<[f64; 2]>::from(Plane::from([1.0, 2.0])), [1.0, 2.0]);
        assert_eq!(Plane::<f32>::default(), Plane::new(0.0, 0.0));
    }
}
