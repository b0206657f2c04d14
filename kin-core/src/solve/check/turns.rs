//! Whole turns of an angle.

use core::f64::consts::TAU;

use num_traits::Float;

use crate::solve::Scalar;
use crate::solve::check::{Check, Measure, Span};

/// The turns that bring an angle closest to a guess, in radians.
#[derive(Clone, Copy)]
pub(in crate::solve) struct NearestTurns<T> {
    pub(in crate::solve) angle: T,
    pub(in crate::solve) guess: T,
}

impl<T: Scalar> Measure<T, 2> for NearestTurns<T> {
    fn name(&self) -> &'static str {
        "turns to a guess"
    }

    #[inline(always)]
    fn operands(&self) -> [T; 2] {
        [self.angle, self.guess]
    }

    #[inline(always)]
    fn measure(&self, [angle, guess]: [f64; 2]) -> f64 {
        let turns = Float::round((guess - angle) / TAU);
        // A guess that is not finite does not move the angle.
        let turns = if turns.is_finite() { turns } else { 0.0 };
        turns * TAU
    }
}

/// The turns that bring an angle into a range, in radians.
#[derive(Clone, Copy)]
pub(in crate::solve) struct TurnsInto<T> {
    pub(in crate::solve) angle: T,
    pub(in crate::solve) low: f64,
    pub(in crate::solve) high: f64,
}

impl<T: Scalar> Measure<T, 1> for TurnsInto<T> {
    fn name(&self) -> &'static str {
        "turns into a range"
    }

    #[inline(always)]
    fn operands(&self) -> [T; 1] {
        [self.angle]
    }

    #[inline(always)]
    fn measure(&self, [angle]: [f64; 1]) -> f64 {
        let is_inside = angle >= self.low && angle <= self.high;
        let turns = if is_inside {
            0.0
        } else {
            Span::new(self.low, self.high, angle, T::EPSILON).turns(angle)
        };
        turns * TAU
    }
}

/// Whether angles of this size are spaced closely enough to define a direction. NaN passes.
#[derive(Clone, Copy)]
pub(in crate::solve) struct TellsDirection<T> {
    /// The sum of the magnitudes of the angles.
    pub(in crate::solve) size: T,
    pub(in crate::solve) limit: f64,
}

impl<T: Scalar> Check<T, 1, 1> for TellsDirection<T> {
    fn name(&self) -> &'static str {
        "turns that tell a direction"
    }

    #[inline(always)]
    fn operands(&self) -> [T; 1] {
        [self.size]
    }

    #[inline(always)]
    fn holds(&self, [size]: [f64; 1]) -> [bool; 1] {
        [size <= self.limit || size.is_nan()]
    }

    fn margin(&self) -> T {
        T::constant(self.limit) - self.size
    }
}
