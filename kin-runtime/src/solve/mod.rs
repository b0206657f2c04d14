//! Closed forms for the blocks of a loop closure, one per file, and Newton's method for the rest.
//!
//! | block | function | additions, multiplications, divisions, square roots |
//! |---|---|---|
//! | two links of known length | [`circle_circle`] | 8, 12, 1, 1 and a change of sign if crossed |
//! | the same from the squares of the lengths | [`circle_circle_squared`] | 6, 11, 1, 1 and a change of sign if crossed |
//! | a link and a slide | [`circle_line`] | 7, 10, 1, 1 |
//! | the same along an axis | [`circle_line_x`], [`circle_line_y`] | 2, 1, 0, 1 and a change of sign if open |
//! | a length and its direction | [`polar`] | 1, 2, 0, 1 and a change of sign if crossed |
//! | the same with an offset | [`polar_offset`] | 5, 9, 1, 1 and a change of sign if crossed |
//! | one angle from its cosine and sine | [`cosine_sine`] | 4, 9, 1, 1 and a change of sign if crossed |
//! | one angle from one of them | [`inverse_cosine`], [`inverse_sine`] | 2, 1, 0, 1 and a change of sign if crossed |
//! | one number from its hyperbolic cosine | [`inverse_hyperbolic_cosine`] | a function of the number library, and a change of sign if crossed |
//! | one unknown | [`linear`] | 0, 0, 1, 0 |
//! | two unknowns in two linear equations | [`linear_pair`] | 3, 8, 1, 0 |
//! | one unknown and its square | [`quadratic`] | 2, 3, 1, 1 |
//! | the square of an unknown | [`square_root`] | 0, 0, 0, 1 and a change of sign if crossed |
//!
//! If none of them fits a block, [`newton()`] solves it, with the triangular factors of [`factor()`] for any number of
//! unknowns.
//!
//! The tests measure these counts by running the functions on numbers that count operations. The functions
//! [`choose()`], [`check_value`] and [`check_angle`] handle declared ranges. [`square_root_of`],
//! [`arc_sine`] and similar functions check the domains of functions that are not defined everywhere. [`direction()`]
//! computes the angle of a vector, [`directions`] those of two, and [`unwrap_to_guess`] moves an angle by whole
//! revolutions to a guess. [`regular()`] and [`finite`] say whether a solver can continue. Each decision is a [`Check`]
//! with a name, operands and a margin. [`decisive`] and [`decisive_vector`] serve several poses at once.
//!
//! Where rates are divided by a square root, the root comes with its square, as a [`Root`].
//!
//! Unit vectors represent angles by their cosine and sine, so no half-angle goes to infinity and no trigonometric
//! function of an unknown is evaluated. Where there are two solutions, an [`Assembly`](crate::Assembly) says which one.
//!
//! A function with a size in its type takes arrays, and is a shell around the hidden function of the same name with
//! `_in`, which takes slices in memory of the caller.
//!
//! Each closed form decides once whether a solution exists, by the real part of the number under the square root. If
//! there is none, the diagnosis is made out of line, in double precision. A result in `Ok` is finite.

mod check;
mod direction;
mod factor;
mod forms;
mod lent;
mod newton;
mod scalar;

pub use crate::assembly::both;
pub use check::*;
pub use direction::{direction, directions};
pub(crate) use factor::{Determinant, Scaling, factor_to};
pub use factor::{Elimination, FactorRow, Factors, factor, factor_in, substitute_in};
#[cfg(feature = "tape")]
pub(crate) use factor::{exponent_of, range};
pub use forms::*;
pub(crate) use lent::{LentFactors, Orientation, lent_factors_length};
pub(crate) use newton::{CONVERGING, FIRST_STEP, LINEAR_STEP, NEGLIGIBLE, QUADRATIC, corrected};
pub use newton::{Equations, NewtonMemory, largest, largest_in, newton, newton_in};
#[cfg(feature = "tape")]
pub(crate) use newton::{ITERATIONS, SMALLEST_PART, TRIALS};
pub use scalar::Scalar;

#[cfg(test)]
mod operation_counts;
#[cfg(test)]
mod strategies;
