//! Vectors with numbers: multiples, sums of many, and text.

use core::fmt;
use core::iter::Sum;
use core::ops::{Add, Div, Mul};

use super::{Plane, Space};
use crate::number::Number;
use crate::number::plain::with_derivatives;

macro_rules! vector {
    ($vector:ident: $first:ident, $($axis:ident),+) => {
        impl<T: Number> Mul<T> for $vector<T> {
            type Output = Self;

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn mul(self, factor: T) -> Self {
                self.scale(factor)
            }
        }

        impl<T: Number> Div<T> for $vector<T> {
            type Output = Self;

            #[cfg_attr(not(debug_assertions), inline(always))]
            fn div(self, divisor: T) -> Self {
                Self::new(self.$first / divisor, $(self.$axis / divisor),+)
            }
        }

        vector!(number first: $vector f32 f64);

        impl<T: Number> Sum for $vector<T> {
            #[inline]
            fn sum<I: Iterator<Item = Self>>(vectors: I) -> Self {
                vectors.fold(Self::zero(), Add::add)
            }
        }

        impl<'a, T: Number> Sum<&'a Self> for $vector<T> {
            #[inline]
            fn sum<I: Iterator<Item = &'a Self>>(vectors: I) -> Self {
                vectors.copied().sum()
            }
        }

        /// The coordinates in parentheses. Precision, width and sign apply to each of them.
        impl<T: fmt::Display> fmt::Display for $vector<T> {
            fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
                formatter.write_str("(")?;
                self.$first.fmt(formatter)?;
                $(
                    formatter.write_str(", ")?;
                    self.$axis.fmt(formatter)?;
                )+
                formatter.write_str(")")
            }
        }
    };
    (number first: $vector:ident $($number:ident)+) => {
        $(
            impl Mul<$vector<$number>> for $number {
                type Output = $vector<$number>;

                #[cfg_attr(not(debug_assertions), inline(always))]
                fn mul(self, vector: $vector<$number>) -> $vector<$number> {
                    vector * self
                }
            }
        )+
    };
}

vector!(Plane: x, y);
vector!(Space: x, y, z);

/// Vectors of numbers with derivatives, times and over plain numbers, which are constants.
macro_rules! by_plain_numbers {
    ([$($parameter:tt)*] $number:ty) => {
        by_plain_numbers!(@vector [$($parameter)*] $number, Plane<$number>);
        by_plain_numbers!(@vector [$($parameter)*] $number, Space<$number>);
    };
    (@vector [$($parameter:tt)*] $number:ty, $vector:ty) => {
        impl<$($parameter)*> Mul<f64> for $vector {
            type Output = Self;

            fn mul(self, factor: f64) -> Self {
                self * <$number>::constant(factor)
            }
        }

        impl<$($parameter)*> Mul<$vector> for f64 {
            type Output = $vector;

            fn mul(self, vector: $vector) -> $vector {
                vector * self
            }
        }

        impl<$($parameter)*> Div<f64> for $vector {
            type Output = Self;

            fn div(self, divisor: f64) -> Self {
                self / <$number>::constant(divisor)
            }
        }
    };
}

with_derivatives!(by_plain_numbers);

#[cfg(test)]
mod tests {
    use std::format;

    use super::{Plane, Space};

    #[test]
    fn vectors_times_and_over_numbers() {
        let plane = Plane::new(2.0, -1.0);
        assert_eq!(plane * 2.0, Plane::new(4.0, -2.0));
        assert_eq!(2.0 * plane, plane * 2.0);
        assert_eq!(plane / 2.0, Plane::new(1.0, -0.5));
        let space = Space::new(2.0_f32, -1.0, 3.0);
        assert_eq!(2.0 * space / 4.0, Space::new(1.0, -0.5, 1.5));
    }

    #[test]
    fn sums_of_vectors() {
        let planes = [Plane::new(2.0, -1.0), Plane::new(3.0, 5.0)];
        assert_eq!(planes.iter().sum::<Plane>(), Plane::new(5.0, 4.0));
        assert_eq!(planes.into_iter().take(0).sum::<Plane>(), Plane::zero());
        assert_eq!(
            [Space::new(1.0, 2.0, 3.0); 2].iter().sum::<Space>(),
            Space::new(2.0, 4.0, 6.0)
        );
    }

    #[test]
    fn text_has_the_precision_that_was_asked_for() {
        assert_eq!(format!("{}", Plane::new(2.0, -1.25)), "(2, -1.25)");
        assert_eq!(format!("{:+.1}", Space::new(2.0, -1.0, 0.5)), "(+2.0, -1.0, +0.5)");
    }
}
