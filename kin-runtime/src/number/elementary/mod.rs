//! Sine, cosine and arctangent as straight-line code.
//!
//! The functions of the standard libraries are calls, and a compiler cannot run a call for several poses at once. The
//! functions here reduce the argument and evaluate a polynomial without branches, so a compiler can use as many lanes
//! as the machine has. They report arguments outside their range, and the library functions handle those.
//!
//! In double precision the errors of sine and cosine are at most 1⅓ units in the last place, and those of the
//! arctangent at most 1½. In single precision all errors are at most 0.6. More accuracy would cost more operations, and
//! no problem solved with these functions is conditioned well enough to show it. [`Scalar`](crate::Scalar) uses all of
//! them.
//!
//! The constant `FUSED` selects multiply-add as one instruction. It is true in functions that are compiled for a
//! machine with that instruction.
//!
//! The constant `SELECT` says how a condition acts. In wide vectors, a condition selects between numbers, and a sign is
//! flipped as a bit. In scalar code, both are products with 0 or ±1: a condition that selects several numbers would
//! become a branch, and bit operations would move numbers out of the floating-point registers. The narrowest vectors
//! have no instruction to select, so they use products too.
//!
//! On x86-64, pairs that need the same steps (the sine and cosine of one angle, or the arctangents of two points) share
//! one register.
//!
//! The polynomials are minimax in the relative error of the function itself. They were fitted for this crate by Remez'
//! exchange in 50 digits. Each one states its interval and its error.

mod arc_tangent;
mod bits;
mod polynomial;
mod precision;
#[cfg(test)]
mod reference;
mod sine_cosine;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
mod sse2;

/// The constants of these functions, which programs in other languages carry along.
#[cfg(feature = "tape")]
pub(crate) mod constants {
    pub(crate) use super::arc_tangent::{ARC_TANGENT, ARC_TANGENT_SINGLE, HALF_RIGHT_ANGLE};
    pub(crate) use super::sine_cosine::{COSINE, COSINE_SINGLE, LIMIT, RIGHT_ANGLE, ROUNDING, SINE, SINE_SINGLE};
}

pub(crate) use arc_tangent::{
    arc_tangent, arc_tangent_single, arc_tangents, arc_tangents_single, ordinary_arc_tangent,
};
pub(crate) use bits::sign_flipped;
pub(crate) use polynomial::FUSED;
pub(crate) use precision::Elementary;
pub(crate) use sine_cosine::{is_near, near_sine_cosine, sine_cosine, sine_cosine_single};
