//! Equations without numbers that would only be divided out of their rates.

use crate::algebra::{Graph, Node, NodeKind, Symbol};
use crate::structure::Block;

/// Divides equations by the number in front of all terms of their rows in the Jacobian, if this is a power of two:
/// v·v = l² becomes ½ v·v = ½ l², with the derivatives v·v′ = 0, v·v″ + v′·v′ = 0 and so on. Only powers of two, because
/// no division by them rounds.
pub(super) fn scale_rows(graph: &mut Graph, residuals: &mut [Node], blocks: &[Block]) {
    for block in blocks {
        for &equation in &block.equations {
            let unknowns = block.unknowns.iter();
            let row: Vec<Node> = unknowns
                .map(|&unknown| graph.partial(residuals[equation], Symbol::Unknown(unknown)))
                .collect();
            if let Some(number) = common_number(graph, &row).filter(|number| number.log2().fract() == 0.0) {
                residuals[equation] = graph.scale(1.0 / number, residuals[equation]);
            }
        }
    }
}

/// The number in front of all terms, up to signs.
fn common_number(graph: &Graph, entries: &[Node]) -> Option<f64> {
    let numbers = entries.iter().flat_map(|&entry| match graph.kind(entry) {
        NodeKind::Number(number) => vec![number.get()],
        NodeKind::Sum(constant, terms) => {
            let terms = terms.iter().map(|(_, factor)| factor.get());
            terms.chain([constant.get()]).collect()
        }
        _ => vec![1.0],
    });
    let mut numbers = numbers.map(f64::abs).filter(|&number| number != 0.0);
    let first = numbers.next()?;
    numbers.all(|number| number == first).then_some(first)
}
