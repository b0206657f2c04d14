//! The comparison of a block's equations, as trigonometric polynomials in its unknowns, with the closed forms.
//!
//! Only the coefficients of monomials count here, never how an equation was typed.

mod circular;
mod inverse;
mod linear_pair;
mod linear_system;
mod loops;
mod powers;

pub(in crate::structure) use linear_system::recognise as linear_system;
pub(in crate::structure) use loops::arm;

use super::ClosedForm;
use crate::algebra::{Graph, TrigonometricPolynomial};

/// The first closed form that fits.
pub(super) fn closed_form(
    graph: &mut Graph,
    equations: &[TrigonometricPolynomial],
    unknowns: &[usize],
) -> Option<ClosedForm> {
    match (equations, unknowns) {
        ([equation], &[unknown]) => single(graph, equation, unknown),
        ([first, second], &[a, b]) => linear_pair::recognise(graph, [first, second], [a, b])
            .or_else(|| loops::recognise(graph, [first, second], [a, b])),
        _ => None,
    }
}

/// The closed form of one equation for one unknown.
fn single(graph: &mut Graph, equation: &TrigonometricPolynomial, unknown: usize) -> Option<ClosedForm> {
    powers::recognise(graph, equation, unknown)
        .or_else(|| circular::recognise(graph, equation, unknown))
        .or_else(|| inverse::recognise(graph, equation, unknown))
}
