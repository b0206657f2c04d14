//! Numbers of which arctangents cost nothing: a solver that runs on them takes as long as it would without.

use core::ops::{Add, Div, Mul, Neg, Sub};

use kin_core::Scalar;

/// A number of double precision, except that its arctangent is the number itself. The rates of a mechanism do not depend on it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Without(pub(crate) f64);

macro_rules! operators {
    ($($operator:ident $method:ident)+) => {
        $(impl $operator for Without {
            type Output = Self;

            #[inline]
            fn $method(self, other: Self) -> Self {
                Self(self.0.$method(other.0))
            }
        })+
    };
}

operators! { Add add Sub sub Mul mul Div div }

impl Neg for Without {
    type Output = Self;

    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Scalar for Without {
    const EPSILON: f64 = f64::EPSILON;

    #[inline]
    fn constant(value: f64) -> Self {
        Self(value)
    }

    #[inline]
    fn real(self) -> f64 {
        self.0
    }

    #[inline]
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    #[inline]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = Scalar::sin_cos(self.0);
        (Self(sine), Self(cosine))
    }

    #[inline]
    fn asin(self) -> Self {
        Self(self.0.asin())
    }

    #[inline]
    fn acos(self) -> Self {
        Self(self.0.acos())
    }

    #[inline]
    fn atan(self) -> Self {
        self
    }

    #[inline]
    fn atan2(self, _: Self) -> Self {
        self
    }

    #[inline]
    fn exp(self) -> Self {
        Self(self.0.exp())
    }

    #[inline]
    fn ln(self) -> Self {
        Self(self.0.ln())
    }
}
