//! Vectors in space.

use core::ops::{Add, Neg, Sub};

use crate::number::Number;

/// A vector in space: its coordinates along the three axes of a right-handed frame.
///
/// All coordinates have the same unit.
///
/// ```
/// use kin_core::Space;
///
/// let arm = Space::new(1.0, 2.0, 2.0);
/// let axis = Space::new(0.0, 0.0, 1.0);
/// assert_eq!(arm.norm(), 3.0);
/// assert_eq!(arm.dot(axis), 2.0);
/// assert_eq!(axis.cross(arm), Space::new(-2.0, 1.0, 0.0));
/// ```
#[doc(alias = "Vec3")]
#[doc(alias = "Point3")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Space<T = f64> {
    /// The first coordinate.
    pub x: T,
    /// The second coordinate.
    pub y: T,
    /// The third coordinate.
    pub z: T,
}

impl<T> Space<T> {
    /// The vector with the coordinates `x`, `y` and `z`.
    #[inline]
    #[must_use]
    pub const fn new(x: T, y: T, z: T) -> Self {
        Self { x, y, z }
    }
}

impl<T: Number> Space<T> {
    /// The vector of length 0.
    #[cfg_attr(not(debug_assertions), inline(always))]
    #[must_use]
    pub fn zero() -> Self {
        Self::new(T::constant(0.0), T::constant(0.0), T::constant(0.0))
    }

    /// The scalar product `x₁ x₂ + y₁ y₂ + z₁ z₂`. Its unit is the product of the units.
    #[inline]
    #[must_use]
    pub fn dot(self, other: Self) -> T {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The vector product, at right angles to both factors. Seen from its tip, the rotation from the first factor to
    /// the second is counter-clockwise. Its unit is the product of the units.
    #[inline]
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// This vector, multiplied by `factor`.
    #[inline]
    #[must_use]
    pub fn scale(self, factor: T) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }

    /// The square of the length.
    #[inline]
    #[must_use]
    pub fn norm_squared(self) -> T {
        self.dot(self)
    }

    /// The length. Its square must lie in the range of the number type.
    #[inline]
    #[must_use]
    pub fn norm(self) -> T {
        self.norm_squared().sqrt()
    }
}

impl<T: Number> Add for Space<T> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<T: Number> Sub for Space<T> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<T: Number> Neg for Space<T> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self::new(-self.x, -self.y, -self.z)
    }
}

impl<T> From<[T; 3]> for Space<T> {
    #[inline]
    fn from([x, y, z]: [T; 3]) -> Self {
        Self::new(x, y, z)
    }
}

impl<T> From<Space<T>> for [T; 3] {
    #[inline]
    fn from(vector: Space<T>) -> Self {
        [vector.x, vector.y, vector.z]
    }
}

#[cfg(test)]
mod tests {
    use super::Space;

    const A: Space = Space::new(2.0, -1.0, 3.0);
    const B: Space = Space::new(3.0, 5.0, -2.0);

    #[test]
    fn sums_and_differences() {
        assert_eq!(A + B, Space::new(5.0, 4.0, 1.0));
        assert_eq!(A - B, Space::new(-1.0, -6.0, 5.0));
        assert_eq!(-A, Space::new(-2.0, 1.0, -3.0));
        assert_eq!(A.scale(3.0), Space::new(6.0, -3.0, 9.0));
    }

    #[test]
    fn vector_product_is_normal_and_as_long_as_the_area() {
        let normal = A.cross(B);
        assert_eq!(normal, Space::new(-13.0, 13.0, 13.0));
        assert_eq!((normal.dot(A), normal.dot(B)), (0.0, 0.0));
        // Lagrange's identity
        assert_eq!(
            normal.norm_squared(),
            A.norm_squared() * B.norm_squared() - A.dot(B) * A.dot(B)
        );
        assert_eq!(B.cross(A), -normal);
    }

    #[test]
    fn arrays_convert_both_ways() {
        assert_eq!(<[f64; 3]>::from(Space::from([1.0, 2.0, 3.0])), [1.0, 2.0, 3.0]);
        assert_eq!(Space::<f32>::default(), Space::new(0.0, 0.0, 0.0));
    }
}
