//! How a number decides.

use crate::failure::Failure;
use crate::number::Number;
use crate::number::series::Series;
use crate::solve::newton::damped_root;

/// A number that a mechanism can be solved with: a [`Number`], and how it decides.
///
/// A solver decides on the way: whether links reach, which pivot is the largest, which of two solutions lies in a range. A plain
/// number, and one that carries derivatives, decides by its real part, as the provided methods do.
///
/// Implemented for all numbers of this crate; a number type of your own needs no more than `impl Scalar for Own {}`.
///
/// ```
/// use kin_core::prelude::*;
///
/// /// The rocker's angle of a four-bar linkage, in any number type.
/// fn rocker<T: Scalar>(linkage: &kin_core::library::FourBar<T>, crank: T) -> Option<T> {
///     let position = linkage.position(crank, Assembly::Open).ok()?;
///     Some(position.theta4.value())
/// }
///
/// let linkage = kin_core::library::FourBar { r1: 90.0_f32, r2: 30.0, r3: 60.0, r4: 45.0 };
/// assert!(rocker(&linkage, 1.0).is_some());
/// ```
pub trait Scalar: Number {
    /// The part of its terms that a sum must exceed for its sign to decide anything: zero for a number that stands for one pose, which
    /// always decides.
    ///
    /// Several poses at once are rounded differently from one pose alone, so that a sum near zero may have another sign there. Such a sum
    /// makes its pose NaN, and the solver of one pose decides about it.
    const DOUBT: f64 = 0.0;

    /// The number itself if all conditions on the real parts of the judges hold, and none if they do not.
    ///
    /// This and what follows are how a solver decides. A number that stands for several poses at once, as in a
    /// [batch](crate::batch), decides for each: it keeps the poses that pass, and makes the others NaN.
    #[inline(always)]
    fn provided<const N: usize, const K: usize>(
        self,
        judges: [Self; N],
        conditions: impl Fn([f64; N]) -> [bool; K],
    ) -> Option<Self> {
        let conditions = conditions(judges.map(Self::real));
        conditions.iter().all(|holds| *holds).then_some(self)
    }

    /// One value if the judges pass a test, the other one if they do not.
    #[inline(always)]
    fn either<const N: usize>(
        judges: [Self; N],
        test: impl Fn([f64; N]) -> bool,
        one: impl FnOnce() -> Self,
        other: impl FnOnce() -> Self,
    ) -> Self {
        if test(judges.map(Self::real)) { one() } else { other() }
    }

    /// This number, or its negative if the real part of the other is negative; either if that is zero.
    #[must_use]
    #[inline(always)]
    fn times_sign_of(self, other: Self) -> Self {
        Self::either([other], |[other]| other < 0.0, || -self, || self)
    }

    /// A constant that depends on the real parts of other numbers.
    #[must_use]
    #[inline(always)]
    fn constant_of<const N: usize>(judges: [Self; N], function: impl Fn([f64; N]) -> f64) -> Self {
        Self::constant(function(judges.map(Self::real)))
    }

    /// A decision for the whole of the number, on real parts. A number that stands for several poses fails if they do not agree.
    ///
    /// # Errors
    /// Those of the decision.
    #[inline(always)]
    fn decided<const N: usize, R: PartialEq>(
        judges: [Self; N],
        decision: impl Fn([f64; N]) -> Result<R, Failure>,
    ) -> Result<R, Failure> {
        decision(judges.map(Self::real))
    }

    /// The root that [`solve::newton`](crate::solve::newton()) finds; the arguments are its own.
    ///
    /// # Errors
    /// Those of the method.
    #[inline]
    fn root<const N: usize>(
        guess: [Self; N],
        sizes: [Self; N],
        evaluate: impl FnMut([Self; N]) -> ([Self; N], [[Self; N]; N]),
    ) -> Result<[Self; N], Failure> {
        damped_root(guess, sizes, evaluate)
    }
}

impl Scalar for f64 {}
impl Scalar for f32 {}
impl<const N: usize> Scalar for Series<N> {}
#[cfg(feature = "std")]
impl Scalar for crate::number::count::Counted {}
