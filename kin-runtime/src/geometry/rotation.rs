//! Rotations in space.

use crate::geometry::Space;
use crate::number::Number;

/// A rotation in space about an axis through the origin, as a matrix.
///
/// Angles are in radians, counter-clockwise when the axis points towards the viewer.
///
/// ```
/// use core::f64::consts::FRAC_PI_2;
/// use kin_core::{Rotation, Space};
///
/// // a quarter revolution about z takes x to y, one about x takes that on to z
/// let rotation = Rotation::about_x(FRAC_PI_2).times(Rotation::about_z(FRAC_PI_2));
/// let rotated = rotation.rotate(Space::new(1.0, 0.0, 0.0));
/// assert!((rotated - Space::new(0.0, 0.0, 1.0)).norm() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation<T = f64> {
    rows: [Space<T>; 3],
}

impl<T> Rotation<T> {
    /// The rotation with this matrix, which must be one of a rotation.
    #[doc(hidden)]
    pub const fn from_rows(rows: [Space<T>; 3]) -> Self {
        Self { rows }
    }

    /// The rows of the matrix, for any kind of number.
    #[cfg(feature = "serde")]
    pub(crate) const fn as_rows(&self) -> &[Space<T>; 3] {
        &self.rows
    }
}

impl<T: Number> Rotation<T> {
    /// The rotation about the x axis.
    #[must_use]
    pub fn about_x(angle: T) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        Self {
            rows: [
                Space::new(one, zero, zero),
                Space::new(zero, cosine, -sine),
                Space::new(zero, sine, cosine),
            ],
        }
    }

    /// The rotation about the y axis.
    #[must_use]
    pub fn about_y(angle: T) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        Self {
            rows: [
                Space::new(cosine, zero, sine),
                Space::new(zero, one, zero),
                Space::new(-sine, zero, cosine),
            ],
        }
    }

    /// The rotation about the z axis.
    #[must_use]
    pub fn about_z(angle: T) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        Self {
            rows: [
                Space::new(cosine, -sine, zero),
                Space::new(sine, cosine, zero),
                Space::new(zero, zero, one),
            ],
        }
    }

    /// The rotation about any axis. Only the direction of the axis matters; its length may be anything but zero.
    ///
    /// This is Rodrigues' formula: with the unit vector u of the axis, a vector v becomes v cos θ + (u × v) sin θ + u
    /// (u · v) (1 - cos θ).
    #[must_use]
    pub fn about(axis: Space<T>, angle: T) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let (zero, one) = (T::constant(0.0), T::constant(1.0));
        let unit = axis.scale(one / axis.norm());
        let column =
            |v: Space<T>| v.scale(cosine) + unit.cross(v).scale(sine) + unit.scale(unit.dot(v) * (one - cosine));
        Self {
            rows: [
                column(Space::new(one, zero, zero)),
                column(Space::new(zero, one, zero)),
                column(Space::new(zero, zero, one)),
            ],
        }
        .transposed()
    }

    fn transposed(self) -> Self {
        let [a, b, c] = self.rows;
        Self {
            rows: [
                Space::new(a.x, b.x, c.x),
                Space::new(a.y, b.y, c.y),
                Space::new(a.z, b.z, c.z),
            ],
        }
    }

    /// The vector, rotated.
    #[must_use]
    pub fn rotate(self, vector: Space<T>) -> Space<T> {
        let [x, y, z] = self.rows.map(|row| row.dot(vector));
        Space::new(x, y, z)
    }

    /// The product: the other rotation comes first, then this one.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        let columns = other.transposed().rows;
        Self {
            rows: self.rows.map(|row| {
                let [x, y, z] = columns.map(|column| row.dot(column));
                Space::new(x, y, z)
            }),
        }
    }

    /// The rows of the matrix. Their scalar products with a vector are the coordinates of the rotated vector.
    #[must_use]
    pub const fn rows(&self) -> [Space<T>; 3] {
        self.rows
    }
}

#[cfg(test)]
mod tests {
    use super::Rotation;
    use crate::geometry::Space;

    const X: Space = Space::new(1.0, 0.0, 0.0);
    const Y: Space = Space::new(0.0, 1.0, 0.0);
    const Z: Space = Space::new(0.0, 0.0, 1.0);

    /// Each coordinate may differ by a few ε times the length of the vector.
    fn assert_near(found: Space, expected: Space) {
        let bound = 8.0 * f64::EPSILON * expected.norm().max(1.0);
        assert!((found - expected).norm() <= bound, "{found:?} instead of {expected:?}");
    }

    #[test]
    fn quarter_turns_take_each_axis_to_the_next() {
        let quarter = core::f64::consts::FRAC_PI_2;
        assert_near(Rotation::about_x(quarter).rotate(Y), Z);
        assert_near(Rotation::about_y(quarter).rotate(Z), X);
        assert_near(Rotation::about_z(quarter).rotate(X), Y);
    }

    #[test]
    fn any_axis_agrees_with_the_three_at_any_length() {
        for angle in [-2.0, 0.3, 1.5] {
            for length in [1.0, 0.25, 7.0] {
                for v in [X, Y, Z, Space::new(0.3, -2.0, 1.1)] {
                    assert_near(
                        Rotation::about(X.scale(length), angle).rotate(v),
                        Rotation::about_x(angle).rotate(v),
                    );
                    assert_near(
                        Rotation::about(Y.scale(length), angle).rotate(v),
                        Rotation::about_y(angle).rotate(v),
                    );
                    assert_near(
                        Rotation::about(Z.scale(length), angle).rotate(v),
                        Rotation::about_z(angle).rotate(v),
                    );
                }
            }
        }
    }

    #[test]
    fn the_axis_stays_and_lengths_are_kept() {
        let (axis, v) = (Space::new(1.0, -2.0, 0.5), Space::new(0.3, -2.0, 1.1));
        let rotation = Rotation::about(axis, 0.7);
        assert_near(rotation.rotate(axis), axis);
        let rotated = rotation.rotate(v);
        assert!((rotated.norm() - v.norm()).abs() <= 8.0 * f64::EPSILON * v.norm());
        // The inverse rotation restores the vector, and a third of a revolution about the diagonal takes x to y.
        assert_near(Rotation::about(axis, -0.7).rotate(rotated), v);
        let third = Rotation::about(Space::new(1.0, 1.0, 1.0), 2.0 * core::f64::consts::FRAC_PI_3);
        assert_near(third.rotate(X), Y);
    }

    #[test]
    fn products_turn_by_the_second_factor_first() {
        let (first, second) = (Rotation::about_x(0.4), Rotation::about_y(-1.1));
        let v = Space::new(0.3, -2.0, 1.1);
        assert_near(first.times(second).rotate(v), first.rotate(second.rotate(v)));
    }
}
