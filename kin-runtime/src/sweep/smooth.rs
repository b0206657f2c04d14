//! What is common to the readers of a sweep between its rows.

use super::Local;
use crate::number::Number;

/// A series as a function of another one, by Horner's scheme. The outer series is that at the point where the inner one
/// stands.
pub(crate) fn composed(outer: Local, inner: Local) -> Local {
    let change = inner - Local::constant(inner.real());
    let coefficients = outer.coefficients().into_iter().rev();
    coefficients.fold(Local::constant(0.0), |sum, coefficient| {
        sum * change + Local::constant(coefficient)
    })
}
