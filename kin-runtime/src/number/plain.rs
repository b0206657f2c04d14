//! Numbers of programs among numbers that carry derivatives: `2.0 * x`, `x + 1.0`.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Sub};

use crate::number::Number;

/// Calls a macro with the types of numbers that calculate with an `f64` as with a constant, and their parameters.
macro_rules! with_derivatives {
    ($then:ident) => {
        $then!([const K: usize] $crate::number::series::Series<K>);
        $then!([S: $crate::number::Number] $crate::number::Changing<S>);
    };
}

pub(crate) use with_derivatives;

/// The four operations with an `f64` on either side.
macro_rules! plain {
    ([$($parameter:tt)*] $number:ty) => {
        plain!(@operation [$($parameter)*] $number, Add add);
        plain!(@operation [$($parameter)*] $number, Sub sub);
        plain!(@operation [$($parameter)*] $number, Mul mul);
        plain!(@operation [$($parameter)*] $number, Div div);
    };
    (@operation [$($parameter:tt)*] $number:ty, $operation:ident $method:ident) => {
        /// A plain number is a constant.
        impl<$($parameter)*> $operation<f64> for $number {
            type Output = Self;

            fn $method(self, constant: f64) -> Self {
                $operation::$method(self, Self::constant(constant))
            }
        }

        /// A plain number is a constant.
        impl<$($parameter)*> $operation<$number> for f64 {
            type Output = $number;

            fn $method(self, number: $number) -> $number {
                $operation::$method(<$number>::constant(self), number)
            }
        }
    };
}

with_derivatives!(plain);

/// What is chosen by a comparison. At a tie the derivatives of the first operand hold, as at a kink.
macro_rules! chosen {
    ([$($parameter:tt)*] $number:ty) => {
        /// A plain number is a constant.
        impl<$($parameter)*> From<f64> for $number {
            fn from(constant: f64) -> Self {
                Self::constant(constant)
            }
        }

        impl<$($parameter)*> $number {
            /// The size: the number itself, or its negative if its value is below zero. At zero it has a kink.
            #[must_use]
            pub fn abs(self) -> Self {
                if self.real() < 0.0 { -self } else { self }
            }

            /// The larger of two, by their values. The other one may be a plain number. NaN if one of them is.
            #[must_use]
            pub fn max(self, other: impl Into<Self>) -> Self {
                let other = other.into();
                if self.real() >= other.real() || self.real().is_nan() {
                    self
                } else {
                    other
                }
            }

            /// The smaller of two, by their values. The other one may be a plain number. NaN if one of them is.
            #[must_use]
            pub fn min(self, other: impl Into<Self>) -> Self {
                let other = other.into();
                if self.real() <= other.real() || self.real().is_nan() {
                    self
                } else {
                    other
                }
            }
        }
    };
}

with_derivatives!(chosen);

/// Comparisons compare the values, whatever the derivatives: with numbers of the same type, and with an `f64` on either
/// side.
macro_rules! compared {
    ([$($parameter:tt)*] $number:ty) => {
        compared!(@sides [$($parameter)*] $number, $number: |one, other| (one.real(), other.real()));
        compared!(@sides [$($parameter)*] $number, f64: |one, other| (one.real(), *other));
        compared!(@sides [$($parameter)*] f64, $number: |one, other| (*one, other.real()));
    };
    (@sides [$($parameter:tt)*] $one:ty, $other:ty: |$left:ident, $right:ident| $values:expr) => {
        /// Whether the values are equal; derivatives may differ.
        impl<$($parameter)*> PartialEq<$other> for $one {
            fn eq(&self, $right: &$other) -> bool {
                let $left = self;
                let (one, other): (f64, f64) = $values;
                one == other
            }
        }

        /// The order of the values.
        impl<$($parameter)*> PartialOrd<$other> for $one {
            fn partial_cmp(&self, $right: &$other) -> Option<Ordering> {
                let $left = self;
                let (one, other): (f64, f64) = $values;
                one.partial_cmp(&other)
            }
        }
    };
}

with_derivatives!(compared);

#[cfg(test)]
mod tests {
    use core::cmp::Ordering;

    use crate::number::series::Series;
    use crate::number::{Changing, Number};

    type Third = Series<3>;

    const X: Third = Series::from_coefficients([2.0, 3.0, -1.0]);

    #[test]
    fn a_plain_number_is_a_constant() {
        let two = Third::constant(2.0);
        for (plain, constant) in [
            (X + 2.0, X + two),
            (2.0 + X, two + X),
            (X - 2.0, X - two),
            (2.0 - X, two - X),
            (X * 2.0, X * two),
            (2.0 * X, two * X),
            (X / 2.0, X / two),
            (2.0 / X, two / X),
        ] {
            assert_eq!(plain.coefficients(), constant.coefficients());
        }
        let changing = Changing::new(4.0, 3.0);
        let found = 1.0 - 2.0 * changing / 8.0 + 0.5;
        assert_eq!((found.value, found.change), (0.5, -0.75));
        let of_series = Changing::new(X, X) * 2.0;
        assert_eq!(of_series.change.coefficients(), [4.0, 6.0, -2.0]);
    }

    #[test]
    fn values_are_compared() {
        let steeper = Third::from_coefficients([2.0, 30.0, 0.0]);
        assert_eq!(X.partial_cmp(&steeper), Some(Ordering::Equal));
        assert_eq!(X, steeper);
        assert_eq!(X, 2.0);
        assert_eq!(2.0, X);
        for is_so in [X < 2.5, 2.5 > X, 1.0 < X, X <= 2.0, X < Third::constant(2.5)] {
            assert!(is_so);
        }
        for is_so in [X < 2.0, X > 2.0, 2.0 > X, 2.5 <= X] {
            assert!(!is_so);
        }
        let nothing = Third::constant(f64::NAN);
        assert_eq!((nothing.partial_cmp(&X), nothing.partial_cmp(&0.0)), (None, None));
        assert_ne!(nothing, nothing);
        assert!(Changing::new(2.0, 1.0) < Changing::new(3.0, -1.0));
        assert!(Changing::new(2.0, 1.0) > 1.0);
    }

    #[test]
    fn the_larger_one_keeps_its_derivatives() {
        let other = Third::from_coefficients([-3.0, 1.0, 0.5]);
        assert_eq!(X.max(other).coefficients(), X.coefficients());
        assert_eq!(X.min(other).coefficients(), other.coefficients());
        assert_eq!(other.abs().coefficients(), [3.0, -1.0, -0.5]);
        assert_eq!(X.abs().coefficients(), X.coefficients());
        // where one is not known, nothing is
        for known in [X, other] {
            let nothing = Third::constant(f64::NAN);
            assert!(nothing.max(known).real().is_nan() && known.max(nothing).real().is_nan());
            assert!(nothing.min(known).real().is_nan() && known.min(nothing).real().is_nan());
        }
        assert_eq!(other.max(-4.0).coefficients(), other.coefficients());
        assert_eq!(other.max(1.0).coefficients(), [1.0, 0.0, 0.0]);
        assert_eq!(other.min(1.0).coefficients(), other.coefficients());
        let falling = Changing::new(-2.0, 5.0);
        assert_eq!((falling.abs().value, falling.abs().change), (2.0, -5.0));
    }
}
