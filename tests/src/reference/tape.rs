//! A number type for closures: a place on a tape of series.
//!
//! A [`Scalar`] is copied, and a number of many digits cannot be. So the values stand on a tape, one for each thread,
//! and the number is its place there.

use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

use kin_core::Scalar;
use kin_precise::Number;

use super::series::Series;

struct Tape {
    /// How many coefficients are kept.
    count: usize,
    values: Vec<Series>,
}

thread_local! {
    static TAPE: RefCell<Tape> = const { RefCell::new(Tape { count: 1, values: Vec::new() }) };
}

/// The place of a series on this thread's tape.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place(usize);

/// The result of a computation with `count` coefficients, on an empty tape.
pub(super) fn with_count<R>(count: usize, computation: impl FnOnce() -> R) -> R {
    TAPE.with_borrow_mut(|tape| {
        tape.count = count;
        tape.values.clear();
    });
    computation()
}

impl Place {
    /// Writes a series.
    pub(super) fn of(series: Series) -> Self {
        TAPE.with_borrow_mut(|tape| {
            let place = tape.values.len();
            tape.values.push(series.cut(tape.count));
            Self(place)
        })
    }

    /// Reads it.
    pub(super) fn series(self) -> Series {
        TAPE.with_borrow(|tape| tape.values[self.0].clone())
    }

    fn map(self, function: impl FnOnce(&Series, usize) -> Series) -> Self {
        let value = TAPE.with_borrow(|tape| function(&tape.values[self.0], tape.count));
        Self::of(value)
    }

    /// Hyperbolic sine and cosine.
    fn sinh_cosh(self) -> (Self, Self) {
        let (sine, cosine) = TAPE.with_borrow(|tape| tape.values[self.0].sinh_cosh(tape.count));
        (Self::of(sine), Self::of(cosine))
    }

    fn join(self, other: Self, function: impl FnOnce(&Series, &Series, usize) -> Series) -> Self {
        let value = TAPE.with_borrow(|tape| function(&tape.values[self.0], &tape.values[other.0], tape.count));
        Self::of(value)
    }
}

impl Add for Place {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.join(other, |own, other, _| own.plus(other))
    }
}

impl Sub for Place {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.join(other, |own, other, _| own.minus(other))
    }
}

impl Mul for Place {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        self.join(other, Series::times)
    }
}

impl Div for Place {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        self.join(other, Series::over)
    }
}

impl Neg for Place {
    type Output = Self;

    fn neg(self) -> Self {
        self.map(|own, _| own.negated())
    }
}

impl kin_core::Number for Place {
    const EPSILON: f64 = f64::EPSILON;

    /// π for the nearest `f64`, and the number itself for any other.
    fn constant(value: f64) -> Self {
        Self::of(Series::constant(if value == std::f64::consts::PI {
            Number::pi()
        } else {
            Number::exactly(value)
        }))
    }

    fn real(self) -> f64 {
        self.series().coefficient(0).nearest()
    }

    fn is_finite(self) -> bool {
        true
    }

    fn sqrt(self) -> Self {
        self.map(Series::sqrt)
    }

    fn sin_cos(self) -> (Self, Self) {
        let (sine, cosine) = TAPE.with_borrow(|tape| tape.values[self.0].sin_cos(tape.count));
        (Self::of(sine), Self::of(cosine))
    }

    fn asin(self) -> Self {
        let one = Self::constant(1.0);
        self.atan2(((one - self) * (one + self)).sqrt())
    }

    fn acos(self) -> Self {
        let one = Self::constant(1.0);
        ((one - self) * (one + self)).sqrt().atan2(self)
    }

    fn atan(self) -> Self {
        self.atan2(Self::constant(1.0))
    }

    fn atan2(self, x: Self) -> Self {
        self.join(x, Series::atan2)
    }

    fn sinh(self) -> Self {
        self.sinh_cosh().0
    }

    fn cosh(self) -> Self {
        self.sinh_cosh().1
    }

    fn tanh(self) -> Self {
        let (sine, cosine) = self.sinh_cosh();
        sine / cosine
    }

    fn asinh(self) -> Self {
        self.map(Series::asinh)
    }

    fn acosh(self) -> Self {
        self.map(Series::acosh)
    }

    fn atanh(self) -> Self {
        self.map(Series::atanh)
    }

    fn exp(self) -> Self {
        self.map(Series::exp)
    }

    fn ln(self) -> Self {
        self.map(Series::ln)
    }
}

impl Scalar for Place {}
