//! The decisions of a solver: named checks with their operands.
//!
//! A number decides about a check by [`Scalar`](crate::Scalar): a plain number decides by its real part, and a number
//! that holds several poses decides for each. A check knows its name, what it compares, and its distance from another
//! outcome.

mod domain;
pub(in crate::solve) mod doubt;
mod range;
mod real;
pub(in crate::solve) mod regular;
mod unwrap;

#[cfg(test)]
mod tests;

pub use domain::{
    arc_cosine, arc_sine, area_hyperbolic_cosine, area_hyperbolic_tangent, cosine_of_arc, hyperbolic_cosine_of_area,
    logarithm, sine_of_arc, square_of_root, square_root_of, tangent_of_arc,
};
pub use doubt::{decisive, decisive_in, decisive_vector, decisive_vector_in};
pub use range::{SolutionInRange, check_angle, check_value, choose, choose_in};
pub use real::Real;
pub use regular::{finite, regular};
pub(super) use unwrap::SameSide;
pub use unwrap::{agreeing, agreeing_in, check_guesses, check_guesses_in, unwrap_near, unwrap_to_guess};

use crate::assembly::Assembly;
use crate::failure::Failure;
use crate::quantity::Name;
use crate::solve::Scalar;

/// A check on which the path to a solution depends: `K` conditions on `N` operands, all of which must hold.
pub trait Check<T, const N: usize, const K: usize>: Copy {
    /// Whether the conditions have so many operations that a kernel for several poses would not inline their closures.
    /// It decides about each pose then.
    const IS_LONG: bool = false;

    /// The subject of the check, in a few words.
    fn name(&self) -> &'static str;

    /// The numbers that the check compares.
    fn operands(&self) -> [T; N];

    /// Whether the conditions hold for one pose with these operands. No condition holds if its operand is NaN.
    fn holds<R: Real>(&self, operands: [R; N]) -> [R::Truth; K];

    /// The distance of the check from failing, in the unit of its operands. It is positive while the check holds, and
    /// negative if the check fails because the operands miss its limit.
    ///
    /// The margin is calculated in the number type, so that each of several poses has one. Solvers do not ask for
    /// it.
    fn margin(&self) -> T;

    /// The square of the length with whose root the [shortfall](Self::shortfall) is measured.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn square(&self) -> T
    where
        T: Scalar,
    {
        T::constant(0.0)
    }

    /// The margin of [`Failure::OutOfReach`] and the size of the lengths whose difference it is, if a pose that fails
    /// the check fails for this reason wherever the margin is clearly negative. Otherwise only the solver for one pose
    /// knows the reason. NaN leaves the pose to that solver, too. `root` is the root of the [square](Self::square).
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shortfall(&self, root: T) -> Option<[T; 2]> {
        let _ = root;
        None
    }
}

/// A choice between two solutions.
pub trait Choose<T, const N: usize>: Copy {
    /// The quantity by which the choice is made.
    fn name(&self) -> Name;

    /// The numbers that the choice compares.
    fn operands(&self) -> [T; N];

    /// Which of the solutions are valid for these operands. It agrees with [`choose`](Self::choose), which finds more
    /// quickly that one of them is.
    fn validity<R: Real>(&self, operands: [R; N]) -> Validity<R>;

    /// The solution for one pose with these operands: open for the first solution, crossed for the second.
    ///
    /// # Errors
    /// Fails if neither solution is valid, or both are: [`Failure::Ambiguous`].
    fn choose(&self, operands: [f64; N]) -> Result<Assembly, Failure>;

    /// The distance of the choice from another outcome, in the unit of the solutions.
    fn margin(&self) -> T;
}

/// Which of two solutions are valid.
#[derive(Clone, Copy, Debug)]
pub struct Validity<R: Real> {
    /// Whether both solutions are finite. Otherwise the rest means nothing.
    pub are_finite: R::Truth,
    /// Whether a solution is valid.
    pub has_one: R::Truth,
    /// Whether both are valid, and differ from each other.
    pub has_two: R::Truth,
    /// Whether the first solution is chosen, if one is valid and not two.
    pub is_first: R::Truth,
    /// The distance by which the more valid solution is valid, negative if it is not.
    pub margin_of_one: R,
    /// The distance by which the less valid solution is not valid, negative if it is.
    pub margin_of_two: R,
}

/// A constant that depends on the real parts of numbers, for example a count of whole revolutions.
pub trait Measure<T, const N: usize>: Copy {
    /// The numbers on which the constant depends.
    fn operands(&self) -> [T; N];

    /// The constant for one pose with these operands.
    fn measure<R: Real>(&self, operands: [R; N]) -> R;
}

/// A constant that depends on the real parts of any number of numbers, which are taken one after the other.
pub trait RowMeasure: Copy {
    /// The constant of no numbers, before its [end](Self::end).
    fn start<R: Real>() -> R;

    /// The constant with one more number.
    fn with<R: Real>(constant: R, next: R) -> R;

    /// The constant when all numbers are taken.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn end<R: Real>(constant: R) -> R {
        constant
    }
}

macro_rules! sign {
    ($(
        #[doc = $doc:literal]
        $visibility:vis $name:ident, $words:literal: |$number:ident| $holds:expr, $margin:expr;
    )+) => {
        $(
            #[doc = $doc]
            #[derive(Clone, Copy, Debug)]
            $visibility struct $name<T>(pub T);

            impl<T: Scalar> Check<T, 1, 1> for $name<T> {
                fn name(&self) -> &'static str {
                    $words
                }

                #[cfg_attr(not(debug_assertions), inline(always))]
                fn operands(&self) -> [T; 1] {
                    [self.0]
                }

                #[cfg_attr(not(debug_assertions), inline(always))]
                fn holds<R: Real>(&self, [$number]: [R; 1]) -> [R::Truth; 1] {
                    [$holds]
                }

                fn margin(&self) -> T {
                    let $number = self.0;
                    $margin
                }
            }
        )+
    };
}

sign! {
    /// Whether a number is less than zero.
    pub Negative, "negative number": |number| number.is_below(R::of(0.0)), -number;
    /// Whether a number is zero or more.
    pub(in crate::solve) NotNegative, "number that is not negative": |number| number.is_at_least(R::of(0.0)), number;
    /// Whether a number is zero.
    pub(in crate::solve) Zero, "zero": |number| number.equals(R::of(0.0)), doubt::size(number) * T::constant(-1.0);
}
