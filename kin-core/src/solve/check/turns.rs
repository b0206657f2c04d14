//! Whole turns of an angle.

use core::f64::consts::TAU;

use crate::solve::Scalar;
use crate::solve::check::{Check, Measure, Real, Span, within};

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

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 2] {
        [self.angle, self.guess]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measure<R: Real>(&self, [angle, guess]: [R; 2]) -> R {
        let turns = ((guess - angle) / R::of(TAU)).rounded();
        // A guess that is not finite does not move the angle.
        let turns = R::choose(turns.is_finite(), || turns, || R::of(0.0));
        turns * R::of(TAU)
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

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 1] {
        [self.angle]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measure<R: Real>(&self, [angle]: [R; 1]) -> R {
        // The tolerance is calculated outside of the range only.
        let turns = R::choose(
            within(angle, self.low, self.high),
            || R::of(0.0),
            || Span::new(self.low, self.high, angle, T::EPSILON).turns(angle),
        );
        turns * R::of(TAU)
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

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 1] {
        [self.size]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [size]: [R; 1]) -> [R::Truth; 1] {
        // NaN does not equal itself.
        [R::either(size.is_at_most(R::of(self.limit)), || {
            R::not(size.equals(size))
        })]
    }

    fn margin(&self) -> T {
        T::constant(self.limit) - self.size
    }
}
