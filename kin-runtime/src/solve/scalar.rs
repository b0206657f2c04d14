//! The decisions of a number.

use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::number::series::SeriesOf;
use crate::number::{Changing, Number, real_parts};
use crate::solve::check::{Check, Choose, Measure, Negative, RowMeasure, SameSide};
use crate::solve::factor::{Elimination, FactorRow, checked_factors, substitute};
use crate::solve::newton::{Equations, NewtonMemory, damped_root};

/// A number with which a mechanism can be solved: a [`Number`] that can also decide.
///
/// A solver makes decisions: whether links reach, which pivot is the largest, which of two solutions lies in a range. A
/// plain number, and a number that carries derivatives, decides by its real part, as the provided methods do.
///
/// The trait is implemented for all numbers of this crate. A number type of another crate needs only
/// `impl Scalar for Own {}`.
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
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a number for which a mechanism is solved",
    label = "write `f64` or `f32`, and numbers with a decimal point: `1.0` instead of `1`"
)]
pub trait Scalar: Number {
    /// The part of its terms that a sum must exceed for its sign to decide anything. It is zero for a number that holds
    /// one pose, which always decides.
    ///
    /// Several poses at once are rounded differently from one pose alone, so a sum close to zero may have another sign
    /// there. Such a sum makes its pose NaN, and the solver for one pose decides about it.
    const DOUBT: f64 = 0.0;

    /// The number itself if a check holds, otherwise `None`.
    ///
    /// A solver decides by this method and those below. A number that holds several poses, as in a
    /// [batch](crate::batch), decides for each of them: it keeps the poses that pass, and makes the others NaN.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn provided<const N: usize, const K: usize>(self, check: impl Check<Self, N, K>) -> Option<Self> {
        let conditions = check.holds(real_parts(check.operands()));
        let mut hold = true;
        #[expect(
            clippy::needless_range_loop,
            reason = "it stands at thousands of calls, and iterators take a compiler longer"
        )]
        for index in 0..K {
            hold &= conditions[index];
        }
        hold.then_some(self)
    }

    /// The number and its square root if a check holds, otherwise `None`.
    #[doc(hidden)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rooted<const N: usize, const K: usize>(self, check: impl Check<Self, N, K>) -> Option<(Self, Self)> {
        self.provided(check).map(|square| (square, square.sqrt()))
    }

    /// The failure of a solver, from the function that makes the diagnosis. A number that holds several poses makes
    /// none: each of its poses may fail for another reason.
    #[doc(hidden)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn refused(diagnosis: impl FnOnce() -> Failure) -> Failure {
        diagnosis()
    }

    /// One value if a check holds, otherwise the other value.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn either<const N: usize>(
        check: impl Check<Self, N, 1>,
        one: impl FnOnce() -> Self,
        other: impl FnOnce() -> Self,
    ) -> Self {
        let [holds] = check.holds(real_parts(check.operands()));
        if holds { one() } else { other() }
    }

    /// This number, or its negative if the real part of `other` is negative. If that part is zero, either may be
    /// returned.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn times_sign_of(self, other: Self) -> Self {
        Self::either(Negative(other), || -self, || self)
    }

    /// This number in the open assembly, its negative in the crossed assembly.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn signed(self, assembly: Assembly) -> Self {
        Self::assembled(assembly, || self, || -self)
    }

    /// One value in the open assembly, the other in the crossed assembly.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn assembled(assembly: Assembly, open: impl FnOnce() -> Self, crossed: impl FnOnce() -> Self) -> Self {
        match assembly {
            Assembly::Open => open(),
            Assembly::Crossed => crossed(),
        }
    }

    /// Some values in the open assembly, others in the crossed assembly.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn all_assembled<const N: usize>(assembly: Assembly, open: [Self; N], crossed: [Self; N]) -> [Self; N] {
        match assembly {
            Assembly::Open => open,
            Assembly::Crossed => crossed,
        }
    }

    /// See [`solve::agreeing`](crate::solve::agreeing()). A number that holds one pose always agrees with itself.
    #[doc(hidden)]
    #[inline(always)]
    fn agree(near: &mut [Self], orientations: &[Self]) {
        for value in near {
            for orientation in orientations {
                let leading = orientation.leading() >= 0.0;
                let orientation = *orientation;
                *value = value.provided(SameSide { orientation, leading }).unwrap_or(*value);
            }
        }
    }

    /// A constant that depends on the real parts of numbers.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measured<const N: usize>(measure: impl Measure<Self, N>) -> Self {
        Self::constant(measure.measure(real_parts(measure.operands())))
    }

    /// A constant that depends on the real parts of `count` numbers.
    #[doc(hidden)]
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn measured_over<M: RowMeasure>(_: M, count: usize, operand: impl Fn(usize) -> Self) -> Self {
        let mut constant = M::start();
        for index in 0..count {
            constant = M::with(constant, operand(index).real());
        }
        Self::constant(M::end::<f64>(constant))
    }

    /// A choice for the whole number. A number that holds several poses fails if they do not agree.
    ///
    /// # Errors
    /// Returns the error of the choice.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn chosen<const N: usize>(choice: impl Choose<Self, N>) -> Result<Assembly, Failure> {
        choice.choose(real_parts(choice.operands()))
    }

    /// The [choice](Self::chosen) by the first of one or more criteria to which not both solutions are valid.
    ///
    /// # Errors
    /// Returns the error of that criterion, or of the last one if both solutions are valid to all of them.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn first_chosen<const N: usize>(choices: &[impl Choose<Self, N>]) -> Result<Assembly, Failure> {
        let mut number = 0;
        // The function is called at one site only, so that the compiler can inline it.
        loop {
            let chosen = Self::chosen(choices[number]);
            number += 1;
            if number == choices.len() || !matches!(chosen, Err(Failure::Ambiguous { .. })) {
                return chosen;
            }
        }
    }

    /// The real part of the leading pose. It decides where all poses must go one way: the order of pivots, and the
    /// powers of two by which rows are scaled. A check then says which of the other poses can follow.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn leading(self) -> f64 {
        self.real()
    }

    /// The pivot row of one step of the elimination of a matrix with `count` rows: the row of the largest entry from
    /// the diagonal down, or the first of several.
    #[must_use]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn pivot(entries: &[Self], count: usize, step: usize) -> usize {
        let (mut best, mut largest) = (step, entries[step * count + step].leading().abs());
        for row in step + 1..count {
            let size = entries[row * count + step].leading().abs();
            if size > largest {
                (best, largest) = (row, size);
            }
        }
        best
    }

    /// The assembly of the side of the singular positions on which a number lies that is zero there: open if its real
    /// part is positive or zero.
    #[doc(hidden)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn side(self) -> Assembly {
        Assembly::from_sign(self.real())
    }

    /// See [`solve::factor_in`](crate::solve::factor_in()).
    ///
    /// # Errors
    /// Returns the errors of that function.
    #[doc(hidden)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn factored(entries: &mut [Self], rows: &mut [FactorRow]) -> Result<Elimination, Failure> {
        checked_factors(entries, rows)
    }

    /// See [`solve::substitute_in`](crate::solve::substitute_in()).
    #[doc(hidden)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn substituted(entries: &[Self], rows: &[FactorRow], right: &[Self], solution: &mut [Self]) {
        substitute(entries, rows, Self::constant, right, solution);
    }

    /// See [`solve::newton_in`](crate::solve::newton_in()).
    ///
    /// # Errors
    /// Returns the errors of that function.
    #[doc(hidden)]
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn root(
        solution: &mut [Self],
        sizes: &[Self],
        memory: NewtonMemory<'_, Self>,
        equations: impl Equations<Self>,
    ) -> Result<(), Failure> {
        damped_root(solution, sizes, memory, equations)
    }
}

impl Scalar for f64 {}
impl Scalar for f32 {}
impl<S: Scalar, const N: usize> Scalar for SeriesOf<S, N> {}
impl<S: Scalar> Scalar for Changing<S> {}
#[cfg(feature = "std")]
impl Scalar for crate::number::count::Counted {}
