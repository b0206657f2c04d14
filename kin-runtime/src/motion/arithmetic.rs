//! Sums, products and quotients of motions, by the rules of differentiation.

use core::array;
use core::iter::Sum;
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Motion, leibniz};
use crate::geometry::{Plane, Space};
use crate::number::Number;
use crate::number::plain::with_derivatives;

impl<T: Copy + Add<Output = T>, const N: usize> Add for Motion<T, N> {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(array::from_fn(|order| {
            self.derivatives[order] + other.derivatives[order]
        }))
    }
}

impl<T: Copy + Sub<Output = T>, const N: usize> Sub for Motion<T, N> {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(array::from_fn(|order| {
            self.derivatives[order] - other.derivatives[order]
        }))
    }
}

impl<T: Neg<Output = T>, const N: usize> Neg for Motion<T, N> {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        self.map(Neg::neg)
    }
}

/// Leibniz's rule for the derivatives of a product.
impl<T: Number, const N: usize> Mul for Motion<T, N> {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(array::from_fn(|order| {
            leibniz(&self.derivatives[..=order], &other.derivatives[..=order])
        }))
    }
}

/// Leibniz's rule, solved for one factor: of each derivative of quotient times divisor, all terms but the highest
/// derivative of the quotient are known.
///
/// Where the divisor's value is zero, the entries are infinite or NaN, as for numbers.
///
/// ```
/// use kin_core::Motion;
///
/// // 1 / (1 + t) at t = 0
/// let quotient = Motion::constant(1.0) / Motion::from([1.0, 1.0, 0.0, 0.0]);
/// assert_eq!(quotient.derivatives(), [1.0, -1.0, 2.0, -6.0]);
/// ```
impl<T: Number, const N: usize> Div for Motion<T, N> {
    type Output = Self;

    #[inline]
    fn div(self, other: Self) -> Self {
        let divisor = other.value();
        let mut quotient = [T::constant(0.0); N];
        for order in 0..N {
            // the entry of this order is still zero
            let known = leibniz(&quotient[..=order], &other.derivatives[..=order]);
            quotient[order] = (self.derivatives[order] - known) / divisor;
        }
        Self::new(quotient)
    }
}

/// A number is constant, so it changes the value alone.
impl<T: Number, const N: usize> Add<T> for Motion<T, N> {
    type Output = Self;

    #[inline]
    fn add(mut self, constant: T) -> Self {
        self[0] = self[0] + constant;
        self
    }
}

/// A number is constant, so it changes the value alone.
impl<T: Number, const N: usize> Sub<T> for Motion<T, N> {
    type Output = Self;

    #[inline]
    fn sub(mut self, constant: T) -> Self {
        self[0] = self[0] - constant;
        self
    }
}

impl<T: Number, const N: usize> Sum for Motion<T, N> {
    #[inline]
    fn sum<I: Iterator<Item = Self>>(motions: I) -> Self {
        motions.fold(Self::constant(T::constant(0.0)), Add::add)
    }
}

impl<'a, T: Number, const N: usize> Sum<&'a Self> for Motion<T, N> {
    #[inline]
    fn sum<I: Iterator<Item = &'a Self>>(motions: I) -> Self {
        motions.copied().sum()
    }
}

/// Products with numbers, and quotients. A product has the same value in either order.
macro_rules! scaled {
    ($($entry:ty),+) => {
        $(
            impl<T: Number, const N: usize> Mul<T> for Motion<$entry, N> {
                type Output = Self;

                #[inline]
                fn mul(self, factor: T) -> Self {
                    self.map(|entry| entry * factor)
                }
            }

            impl<T: Number, const N: usize> Div<T> for Motion<$entry, N> {
                type Output = Self;

                #[inline]
                fn div(self, divisor: T) -> Self {
                    self.map(|entry| entry / divisor)
                }
            }
        )+
    };
}

scaled!(T, Plane<T>, Space<T>);

/// Products and quotients of moving vectors and moving numbers, by Leibniz's rule for each coordinate, and sums.
macro_rules! moving_vector {
    ($vector:ident: $from_coordinates:ident, $($axis:ident),+) => {
        /// Leibniz's rule for each coordinate.
        impl<T: Number, const N: usize> Mul<Motion<T, N>> for Motion<$vector<T>, N> {
            type Output = Self;

            #[inline]
            fn mul(self, factor: Motion<T, N>) -> Self {
                Self::$from_coordinates($(self.$axis() * factor),+)
            }
        }

        /// Leibniz's rule for each coordinate.
        impl<T: Number, const N: usize> Mul<Motion<$vector<T>, N>> for Motion<T, N> {
            type Output = Motion<$vector<T>, N>;

            #[inline]
            fn mul(self, vector: Motion<$vector<T>, N>) -> Motion<$vector<T>, N> {
                vector * self
            }
        }

        /// Leibniz's rule for each coordinate, solved for the quotient.
        impl<T: Number, const N: usize> Div<Motion<T, N>> for Motion<$vector<T>, N> {
            type Output = Self;

            #[inline]
            fn div(self, divisor: Motion<T, N>) -> Self {
                Self::$from_coordinates($(self.$axis() / divisor),+)
            }
        }

        impl<T: Number, const N: usize> Sum for Motion<$vector<T>, N> {
            #[inline]
            fn sum<I: Iterator<Item = Self>>(motions: I) -> Self {
                motions.fold(Self::new([$vector::zero(); N]), Add::add)
            }
        }

        impl<'a, T: Number, const N: usize> Sum<&'a Self> for Motion<$vector<T>, N> {
            #[inline]
            fn sum<I: Iterator<Item = &'a Self>>(motions: I) -> Self {
                motions.copied().sum()
            }
        }
    };
}

moving_vector!(Plane: from_coordinates, x, y);
moving_vector!(Space: from_three_coordinates, x, y, z);

/// The operators whose left side is a number.
macro_rules! number_first {
    ($($number:ident)+) => {
        $(
            impl<const N: usize> Add<Motion<$number, N>> for $number {
                type Output = Motion<$number, N>;

                #[inline]
                fn add(self, motion: Motion<$number, N>) -> Motion<$number, N> {
                    motion + self
                }
            }

            impl<const N: usize> Sub<Motion<$number, N>> for $number {
                type Output = Motion<$number, N>;

                #[inline]
                fn sub(self, motion: Motion<$number, N>) -> Motion<$number, N> {
                    -motion + self
                }
            }

            impl<const N: usize> Div<Motion<$number, N>> for $number {
                type Output = Motion<$number, N>;

                #[inline]
                fn div(self, motion: Motion<$number, N>) -> Motion<$number, N> {
                    Motion::constant(self) / motion
                }
            }

            number_first!(@product $number: $number, Plane<$number>, Space<$number>);
        )+
    };
    (@product $number:ident: $($entry:ty),+) => {
        $(
            impl<const N: usize> Mul<Motion<$entry, N>> for $number {
                type Output = Motion<$entry, N>;

                #[inline]
                fn mul(self, motion: Motion<$entry, N>) -> Motion<$entry, N> {
                    motion * self
                }
            }
        )+
    };
}

number_first!(f32 f64);

/// Motions of numbers with derivatives, such as those of a sweep, with plain numbers, which are constants.
macro_rules! with_plain_numbers {
    ([$($parameter:tt)*] $number:ty) => {
        with_plain_numbers!(@sum [$($parameter)*] $number, Add add);
        with_plain_numbers!(@sum [$($parameter)*] $number, Sub sub);
        with_plain_numbers!(@product [$($parameter)*] $number);
        with_plain_numbers!(@product [$($parameter)*] Plane<$number>);
        with_plain_numbers!(@product [$($parameter)*] Space<$number>);

        impl<$($parameter)*, const N: usize> Div<Motion<$number, N>> for f64 {
            type Output = Motion<$number, N>;

            fn div(self, motion: Motion<$number, N>) -> Motion<$number, N> {
                Motion::constant(<$number>::constant(self)) / motion
            }
        }
    };
    (@sum [$($parameter:tt)*] $number:ty, $operation:ident $method:ident) => {
        impl<$($parameter)*, const N: usize> $operation<f64> for Motion<$number, N> {
            type Output = Self;

            fn $method(self, constant: f64) -> Self {
                $operation::$method(self, <$number>::constant(constant))
            }
        }

        impl<$($parameter)*, const N: usize> $operation<Motion<$number, N>> for f64 {
            type Output = Motion<$number, N>;

            fn $method(self, motion: Motion<$number, N>) -> Motion<$number, N> {
                $operation::$method(Motion::constant(<$number>::constant(self)), motion)
            }
        }
    };
    (@product [$($parameter:tt)*] $entry:ty) => {
        impl<$($parameter)*, const N: usize> Mul<f64> for Motion<$entry, N> {
            type Output = Self;

            fn mul(self, factor: f64) -> Self {
                self.map(|entry| entry * factor)
            }
        }

        impl<$($parameter)*, const N: usize> Mul<Motion<$entry, N>> for f64 {
            type Output = Motion<$entry, N>;

            fn mul(self, motion: Motion<$entry, N>) -> Motion<$entry, N> {
                motion * self
            }
        }

        impl<$($parameter)*, const N: usize> Div<f64> for Motion<$entry, N> {
            type Output = Self;

            fn div(self, divisor: f64) -> Self {
                self.map(|entry| entry / divisor)
            }
        }
    };
}

with_derivatives!(with_plain_numbers);

#[cfg(test)]
mod tests {
    use crate::geometry::{Plane, Space};
    use crate::motion::Motion;
    use crate::number::series::Series;
    use crate::number::{Changing, Number};

    const X: Motion<f64, 4> = Motion::new([2.0, 3.0, -1.0, 0.5]);
    const Y: Motion<f64, 4> = Motion::new([4.0, -2.0, 6.0, 1.0]);

    #[test]
    fn a_number_moves_the_value_and_scales_all_entries() {
        assert_eq!(X + 1.0, Motion::from([3.0, 3.0, -1.0, 0.5]));
        assert_eq!(1.0 + X, X + 1.0);
        assert_eq!(X - 1.0, Motion::from([1.0, 3.0, -1.0, 0.5]));
        assert_eq!(1.0 - X, -(X - 1.0));
        assert_eq!(X * 2.0, Motion::from([4.0, 6.0, -2.0, 1.0]));
        assert_eq!(2.0 * X, X * 2.0);
        assert_eq!(X / 2.0, Motion::from([1.0, 1.5, -0.5, 0.25]));
        let single = Motion::from([2.0_f32, 3.0]);
        assert_eq!(2.0 * single, single + single);
    }

    #[test]
    fn a_number_is_a_constant_motion() {
        let two = Motion::constant(2.0);
        assert_eq!(X + 2.0, X + two);
        assert_eq!(2.0 - X, two - X);
        assert_eq!(X * 2.0, X * two);
        assert_eq!(X / 2.0, X / two);
        assert_eq!(2.0 / X, two / X);
    }

    /// All entries are small integers times powers of two, so there is no rounding.
    #[test]
    fn a_quotient_times_its_divisor_is_the_dividend() {
        let power_of_two = Motion::from([4.0, -2.0, 6.0, 1.0]);
        assert_eq!(X / power_of_two * power_of_two, X);
        assert_eq!(X * power_of_two / power_of_two, X);
        let infinite = X / Motion::from([0.0, 1.0, 0.0, 0.0]);
        assert_eq!(infinite.value(), f64::INFINITY);
        assert!(!infinite.is_finite());
    }

    #[test]
    fn moving_vectors_are_multiplied_coordinate_by_coordinate() {
        let plane = Motion::from_coordinates(X, Y);
        assert_eq!((plane * Y).x(), X * Y);
        assert_eq!((plane * Y).y(), Y * Y);
        assert_eq!(Y * plane, plane * Y);
        assert_eq!(plane * Y / Y, plane);
        assert_eq!(2.0 * plane, Motion::from_coordinates(X * 2.0, Y * 2.0));
        assert_eq!(plane * 2.0 / 2.0, plane);

        let space = Motion::from_three_coordinates(X, Y, -X);
        assert_eq!((Y * space).z(), -X * Y);
        assert_eq!(2.0 * space, space * 2.0);
        assert_eq!(space * Y / Y, space);
    }

    #[test]
    fn plain_numbers_are_constants_among_series() {
        type Second = Series<2>;
        let series = |entry: f64| Second::from_coefficients([entry, 10.0 * entry]);
        let motion = X.map(series);
        let two = Second::constant(2.0);
        let numbers = |motion: Motion<Second, 4>| motion.map(|entry| entry.coefficients());
        for (plain, constant) in [
            (motion + 2.0, motion + two),
            (2.0 + motion, motion + two),
            (motion - 2.0, motion - two),
            (2.0 - motion, -(motion - two)),
            (motion * 2.0, motion * two),
            (2.0 * motion, motion * two),
            (motion / 2.0, motion / two),
            (2.0 / motion, Motion::constant(two) / motion),
        ] {
            assert_eq!(numbers(plain), numbers(constant));
        }
        let point = Motion::from_coordinates(motion, -motion);
        assert_eq!(numbers((2.0 * point / 4.0).x()), numbers(motion * 0.5));
        assert_eq!((0.5 * point[1]).y.coefficients(), [-1.5, -15.0]);
        // numbers with a change, as loads see them
        let changing = Motion::from([Changing::new(2.0, 1.0), Changing::new(3.0, 0.0)]);
        assert_eq!((1.0 - 3.0 * changing)[0].value, -5.0);
        assert_eq!((1.0 - 3.0 * changing)[0].change, -3.0);
    }

    /// The chain rule, against the series of the same function.
    #[test]
    fn functions_of_motions_follow_the_chain_rule() {
        let series = Series::from_derivatives(X.derivatives());
        for (motion, series) in [
            (X.sin(), series.sin()),
            (X.cos(), series.cos()),
            (X.sqrt(), series.sqrt()),
            ((-X).abs(), series),
            (X.max(Y), Series::from_derivatives(Y.derivatives())),
            (X.min(Y), series),
        ] {
            for (one, other) in motion.derivatives().into_iter().zip(series.derivatives()) {
                assert!(
                    (one - other).abs() <= 1e-14 * (1.0 + other.abs()),
                    "{motion:?} {series:?}"
                );
            }
        }
        assert!(
            (X * X)
                .sqrt()
                .derivatives()
                .iter()
                .zip(X.derivatives())
                .all(|(a, b)| (a - b).abs() < 1e-15)
        );
    }

    #[test]
    fn sums_of_no_motion_are_zero() {
        assert_eq!([X, Y, X].iter().sum::<Motion<f64, 4>>(), X + Y + X);
        assert_eq!([X, Y].into_iter().sum::<Motion<f64, 4>>(), X + Y);
        assert_eq!([X; 0].iter().sum::<Motion<f64, 4>>(), Motion::constant(0.0));
        let plane = Motion::from_coordinates(X, Y);
        assert_eq!([plane, plane].iter().sum::<Motion<Plane, 4>>(), 2.0 * plane);
        let none: [Motion<Space, 2>; 0] = [];
        assert_eq!(none.iter().sum::<Motion<Space, 2>>(), Motion::from([Space::zero(); 2]));
    }
}
