//! Sine, cosine and arctangent as straight-line code.
//!
//! The functions of the libraries are calls, and cannot be computed for several poses at once. These are polynomials after a
//! reduction of the argument, without branches, which a compiler can arrange for as many lanes as a machine has. What
//! they do not hold for, they tell; it goes to the library.
//!
//! In double precision the errors of sine and cosine are within 1⅓ units in the last place, those of the arctangent within 1½; in single
//! precision all are within 0.6. More is to be had for more operations, but nothing that is solved with these functions is so
//! well conditioned that it would be seen. [`Scalar`](crate::Scalar) takes all of them.
//!
//! Where a product and a sum are one instruction the caller may choose it: a constant, `FUSED`, is true for functions that are
//! compiled for such a machine.
//!
//! In wide vectors a condition selects between numbers, and a sign is a bit that is turned round. Alone it is products with 0 and ±1 that do
//! it: one condition that selects several numbers would become a branch, and bits would be taken out of the registers of
//! floating-point numbers. So it is in the narrowest vectors, which have no instruction to select. A constant, `SELECT`, says which.
//!
//! What is computed alike for two numbers, the sine and the cosine of one angle or the arctangents of two points, goes through the two
//! halves of one register on x86-64.
//!
//! The polynomials are minimax in the relative error of the function itself, found by Remez' exchange in 50 digits; each states
//! its interval and its error. They were fitted for this crate.

mod arc_tangent;
mod bits;
mod polynomial;
#[cfg(test)]
mod reference;
mod sine_cosine;
#[cfg(all(target_arch = "x86_64", target_feature = "sse2"))]
mod sse2;

pub(crate) use arc_tangent::{
    arc_tangent, arc_tangent_single, arc_tangents, arc_tangents_single, ordinary_arc_tangent,
};
pub(crate) use bits::turned_round;
pub(crate) use polynomial::FUSED;
pub(crate) use sine_cosine::{is_near, near_sine_cosine, sine_cosine, sine_cosine_single};
