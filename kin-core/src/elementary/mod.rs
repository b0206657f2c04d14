//! Sine, cosine and arctangent as straight-line code.
//!
//! The functions of the libraries are calls, and cannot be computed for several poses at once. These are polynomials after a
//! reduction of the argument, without branches, which a compiler can arrange for as many lanes as a machine has. What
//! they do not hold for, they tell; it goes to the library.
//!
//! Errors are within 1 unit in the last place in double precision, within 0.6 in single precision. For one number in double precision
//! the library's are as fast and more accurate, so that [`Scalar`](crate::Scalar) takes those; in single precision this arctangent
//! is the faster and the more accurate one.
//!
//! The polynomials are minimax in the relative error of the function itself, found by Remez' exchange in 50 digits; each states
//! its interval and its error. They were fitted for this crate.

mod arc_tangent;
mod polynomial;
#[cfg(test)]
mod reference;
mod sine_cosine;

pub(crate) use arc_tangent::{arc_tangent, arc_tangent_single, ordinary_arc_tangent};
pub(crate) use sine_cosine::{is_near, near_sine_cosine, sine_cosine, sine_cosine_single};
