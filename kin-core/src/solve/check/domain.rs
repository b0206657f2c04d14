//! Domains of functions.

use core::f64::consts::{FRAC_PI_2, PI};

use crate::solve::Scalar;
use crate::solve::check::{Check, Real};
use crate::solve::doubt::{is_told_from, size};

/// The domain of a function.
#[derive(Clone, Copy)]
pub(in crate::solve) enum Ends {
    /// Numbers ≥ 0.
    NotNegative,
    /// Numbers > 0.
    Positive,
    /// Numbers from -1 to 1.
    Unit,
    /// Numbers between -1 and 1, without the ends.
    WithinUnit,
    /// Numbers ≥ 1.
    FromOne,
    /// Angles from -π/2 to π/2, up to rounding.
    RightAngles,
    /// Angles from 0 to π, up to rounding.
    HalfTurn,
    /// Angles between -π/2 and π/2, without the ends.
    WithinRightAngles,
}

/// Whether an argument lies in the domain of a function, and the value there is finite.
#[derive(Clone, Copy)]
pub(in crate::solve) struct InDomain<T> {
    pub(in crate::solve) argument: T,
    pub(in crate::solve) result: T,
    pub(in crate::solve) ends: Ends,
    /// The function, as written in a declaration.
    pub(in crate::solve) function: &'static str,
}

impl<T: Scalar> InDomain<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(in crate::solve) fn is_inside<R: Real>(&self, x: R) -> R::Truth {
        match self.ends {
            Ends::NotNegative => x.is_at_least(R::of(0.0)),
            Ends::Positive => x.exceeds(R::of(0.0)),
            Ends::Unit => x.magnitude().is_at_most(R::of(1.0)),
            Ends::WithinUnit => x.magnitude().is_below(R::of(1.0)),
            Ends::FromOne => x.is_at_least(R::of(1.0)),
            Ends::RightAngles => x.magnitude().is_at_most(R::of(FRAC_PI_2 * (1.0 + 4.0 * T::EPSILON))),
            Ends::HalfTurn => {
                let rounding = 4.0 * PI * T::EPSILON;
                R::both(x.is_at_least(R::of(-rounding)), || x.is_at_most(R::of(PI + rounding)))
            }
            Ends::WithinRightAngles => x.magnitude().is_below(R::of(FRAC_PI_2)),
        }
    }

    /// Whether an argument is clearly inside or outside the ends whose size is about 1.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn is_told<R: Real>(&self, x: R) -> R::Truth {
        let one = R::of(1.0);
        let told = |low, high| R::both(is_told_from::<T, R>(low, x, one), || is_told_from::<T, R>(high, x, one));
        match self.ends {
            Ends::NotNegative | Ends::Positive => R::certainly(true),
            Ends::Unit | Ends::WithinUnit => told(-1.0, 1.0),
            Ends::FromOne => is_told_from::<T, R>(1.0, x, one),
            Ends::RightAngles | Ends::WithinRightAngles => told(-FRAC_PI_2, FRAC_PI_2),
            Ends::HalfTurn => told(0.0, PI),
        }
    }
}

impl<T: Scalar> Check<T, 2, 3> for InDomain<T> {
    fn name(&self) -> &'static str {
        self.function
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn operands(&self) -> [T; 2] {
        [self.argument, self.result]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn holds<R: Real>(&self, [argument, result]: [R; 2]) -> [R::Truth; 3] {
        // Each of several poses needs the test for a finite value here, because a later division by an infinite value
        // hides it.
        [self.is_inside(argument), self.is_told(argument), result.is_finite()]
    }

    fn margin(&self) -> T {
        match self.ends {
            Ends::NotNegative | Ends::Positive => self.argument,
            Ends::Unit | Ends::WithinUnit => T::constant(1.0) - size(self.argument),
            Ends::FromOne => self.argument - T::constant(1.0),
            Ends::RightAngles | Ends::WithinRightAngles => T::constant(FRAC_PI_2) - size(self.argument),
            Ends::HalfTurn => T::constant(FRAC_PI_2) - size(self.argument - T::constant(FRAC_PI_2)),
        }
    }
}
