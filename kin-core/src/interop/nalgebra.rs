//! Vectors of the plane as nalgebra's vectors and points, and back.

use nalgebra::{Point2, Scalar, Vector2};

use crate::Plane;

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

#[cfg(test)]
mod tests {
    use super::{Plane, Point2, Vector2};

    #[test]
    fn coordinates_keep_their_order() {
        let vector = Plane::new(1.0, 2.0);
        assert_eq!(Vector2::from(vector), Vector2::new(1.0, 2.0));
        assert_eq!(Plane::from(Vector2::new(1.0, 2.0)), vector);
        assert_eq!(Point2::from(vector), Point2::new(1.0, 2.0));
        assert_eq!(Plane::from(Point2::new(1.0, 2.0)), vector);
    }
}
