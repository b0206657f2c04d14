//! Any number of equations that are linear in all of their unknowns.

use crate::algebra::{Graph, Node, Symbol};
use crate::structure::ClosedForm;

pub(in crate::structure) fn recognise(graph: &mut Graph, equations: &[Node], unknowns: &[usize]) -> Option<ClosedForm> {
    let mut matrix = Vec::new();
    let mut right = Vec::new();
    for &equation in equations {
        let row: Vec<Node> = unknowns
            .iter()
            .map(|&unknown| graph.partial(equation, Symbol::Unknown(unknown)))
            .collect();
        if row.iter().any(|&entry| graph.has_any_of(entry, unknowns)) {
            return None;
        }
        let mut origin = unknowns
            .iter()
            .map(|&unknown| (graph.symbol(Symbol::Unknown(unknown)), graph.zero()))
            .collect();
        let rest = graph.substitute(equation, &mut origin);
        matrix.push(row);
        right.push(graph.negate(rest));
    }
    Some(ClosedForm::LinearSystem {
        unknowns: unknowns.to_vec(),
        matrix,
        right,
    })
}
