//! Comparisons within a tolerance, by the traits of `approx`: every coordinate and every derivative by itself.

use approx::{AbsDiffEq, RelativeEq};

use crate::geometry::{Plane, Space};
use crate::motion::Motion;

/// Compares the numbers of two values one by one. Both have the same count.
macro_rules! entry_by_entry {
    ([$($generics:tt)*] $kind:ty, $entry:ident, $numbers:ident) => {
        impl<$($generics)*> AbsDiffEq for $kind
        where
            $entry: AbsDiffEq,
            $entry::Epsilon: Copy,
        {
            type Epsilon = $entry::Epsilon;

            fn default_epsilon() -> $entry::Epsilon {
                $entry::default_epsilon()
            }

            fn abs_diff_eq(&self, other: &Self, epsilon: $entry::Epsilon) -> bool {
                $numbers(self)
                    .into_iter()
                    .zip($numbers(other))
                    .all(|(one, other)| one.abs_diff_eq(other, epsilon))
            }
        }

        impl<$($generics)*> RelativeEq for $kind
        where
            $entry: RelativeEq,
            $entry::Epsilon: Copy,
        {
            fn default_max_relative() -> $entry::Epsilon {
                $entry::default_max_relative()
            }

            fn relative_eq(&self, other: &Self, epsilon: $entry::Epsilon, max_relative: $entry::Epsilon) -> bool {
                $numbers(self)
                    .into_iter()
                    .zip($numbers(other))
                    .all(|(one, other)| one.relative_eq(other, epsilon, max_relative))
            }
        }
    };
}

fn of_plane<T>(vector: &Plane<T>) -> [&T; 2] {
    [&vector.x, &vector.y]
}

fn of_space<T>(vector: &Space<T>) -> [&T; 3] {
    [&vector.x, &vector.y, &vector.z]
}

fn of_motion<T, const N: usize>(motion: &Motion<T, N>) -> &[T] {
    motion.as_slice()
}

entry_by_entry!([T] Plane<T>, T, of_plane);
entry_by_entry!([T] Space<T>, T, of_space);
entry_by_entry!([T, const N: usize] Motion<T, N>, T, of_motion);

#[cfg(test)]
mod tests {
    use approx::{abs_diff_eq, assert_abs_diff_eq, assert_relative_eq, relative_eq};

    use crate::geometry::{Plane, Space};
    use crate::motion::Motion;

    #[test]
    fn every_number_must_be_close() {
        let plane = Plane::new(1.0, 2.0);
        assert_abs_diff_eq!(plane, Plane::new(1.0, 2.0 + 1e-9), epsilon = 1e-8);
        assert!(!abs_diff_eq!(plane, Plane::new(1.0, 2.0 + 1e-7), epsilon = 1e-8));
        let space = Space::new(1.0, 2.0, 1e6);
        assert_relative_eq!(space, Space::new(1.0, 2.0, 1e6 + 1e-3), max_relative = 1e-8);
        assert!(!relative_eq!(space, Space::new(1.0, 2.1, 1e6), max_relative = 1e-8));
    }

    #[test]
    fn motions_of_points_are_compared_order_by_order() {
        let motion = Motion::from([Plane::new(1.0, 2.0), Plane::new(3.0, 4.0)]);
        assert_abs_diff_eq!(motion, motion);
        let other = Motion::from([Plane::new(1.0, 2.0), Plane::new(3.0, 5.0)]);
        assert!(!abs_diff_eq!(motion, other, epsilon = 0.5));
        assert_abs_diff_eq!(motion, other, epsilon = 1.0);
    }
}
