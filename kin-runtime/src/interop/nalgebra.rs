//! Vectors of the plane and of space, converted to and from nalgebra's vectors and points.

use nalgebra::{Point2, Point3, Scalar, Vector2, Vector3};

use crate::geometry::{Plane, Space};

impl<T> From<Plane<T>> for Vector2<T> {
    fn from(vector: Plane<T>) -> Self {
        Self::new(vector.x, vector.y)
    }
}

impl<T> From<Vector2<T>> for Plane<T> {
    fn from(vector: Vector2<T>) -> Self {
        let [[x, y]] = vector.data.0;
        Self::new(x, y)
    }
}

impl<T: Scalar> From<Plane<T>> for Point2<T> {
    fn from(point: Plane<T>) -> Self {
        Self::new(point.x, point.y)
    }
}

impl<T: Scalar> From<Point2<T>> for Plane<T> {
    fn from(point: Point2<T>) -> Self {
        Self::from(point.coords)
    }
}

impl<T> From<Space<T>> for Vector3<T> {
    fn from(vector: Space<T>) -> Self {
        Self::new(vector.x, vector.y, vector.z)
    }
}

impl<T> From<Vector3<T>> for Space<T> {
    fn from(vector: Vector3<T>) -> Self {
        let [[x, y, z]] = vector.data.0;
        Self::new(x, y, z)
    }
}

impl<T: Scalar> From<Space<T>> for Point3<T> {
    fn from(point: Space<T>) -> Self {
        Self::new(point.x, point.y, point.z)
    }
}

impl<T: Scalar> From<Point3<T>> for Space<T> {
    fn from(point: Point3<T>) -> Self {
        Self::from(point.coords)
    }
}

#[cfg(test)]
mod tests {
    use super::{Plane, Point2, Point3, Space, Vector2, Vector3};

    #[test]
    fn coordinates_keep_their_order() {
        let vector = Plane::new(1.0, 2.0);
        assert_eq!(Vector2::from(vector), Vector2::new(1.0, 2.0));
        assert_eq!(Plane::from(Vector2::new(1.0, 2.0)), vector);
        assert_eq!(Point2::from(vector), Point2::new(1.0, 2.0));
        assert_eq!(Plane::from(Point2::new(1.0, 2.0)), vector);
    }

    #[test]
    fn three_coordinates_keep_their_order() {
        let vector = Space::new(1.0, 2.0, 3.0);
        assert_eq!(Vector3::from(vector), Vector3::new(1.0, 2.0, 3.0));
        assert_eq!(Space::from(Vector3::new(1.0, 2.0, 3.0)), vector);
        assert_eq!(Point3::from(vector), Point3::new(1.0, 2.0, 3.0));
        assert_eq!(Space::from(Point3::new(1.0, 2.0, 3.0)), vector);
    }
}
