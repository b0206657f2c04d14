//! Two equations that are linear in both unknowns, such as a plane loop with two unknown lengths.

use crate::algebra::{Graph, Harmonic, Node, Symbol, TrigonometricPolynomial};
use crate::structure::ClosedForm;

pub(super) fn recognise(
    graph: &mut Graph,
    equations: [&TrigonometricPolynomial; 2],
    unknowns: [usize; 2],
) -> Option<ClosedForm> {
    let zero = graph.zero();
    let variables = unknowns.map(|unknown| graph.symbol(Symbol::Unknown(unknown)));
    let mut matrix = [[zero; 2]; 2];
    let mut right = [zero; 2];
    for (row, equation) in equations.into_iter().enumerate() {
        for (monomial, &coefficient) in &equation.0 {
            if monomial.harmonic != Harmonic::One {
                return None;
            }
            match monomial.powers.iter().next() {
                None => right[row] = graph.negate(coefficient),
                Some((&atom, &1)) if monomial.powers.len() == 1 => {
                    let column = variables.iter().position(|&variable: &Node| variable == atom)?;
                    matrix[row][column] = coefficient;
                }
                Some(_) => return None,
            }
        }
    }
    Some(ClosedForm::LinearPair {
        unknowns,
        matrix,
        right,
    })
}
