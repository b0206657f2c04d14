//! Equations without numbers that would only be divided out of their rates.

use super::jacobian::partials;
use crate::algebra::{Graph, Node, NodeKind};
use crate::structure::Block;

/// Divides equations by the number in front of all terms of their rows in the Jacobian, if this is 2, 4 or 8. So
/// v·v = l² becomes ½ v·v = ½ l², with the derivatives v·v′ = 0, v·v″ + v′·v′ = 0 and so on. A division by a power of
/// two does not round.
pub(super) fn scale_rows(graph: &mut Graph, residuals: &mut [Node], blocks: &[Block]) {
    for block in blocks {
        let rows = partials(graph, residuals, block);
        for (row, &equation) in rows.iter().zip(&block.equations) {
            if let Some(number) = common_number(graph, row).filter(|number| [2.0, 4.0, 8.0].contains(number)) {
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

#[cfg(test)]
mod tests {
    use quote::quote;

    use crate::passes::Passes;
    use crate::testing::sound;

    /// An equation between squared lengths costs as much as one between their halves.
    #[test]
    fn no_derivative_keeps_a_common_number() {
        let cost = |rod: proc_macro2::TokenStream| {
            let declaration = quote! {
                struct Slider { r: Length, l: Length }
                input theta: Angle;
                unknown s: Length;
                #rod
            };
            let solvers = sound(declaration).solvers(Passes::ALL);
            let rates = &solvers.orders()[1..];
            rates.iter().map(|stage| stage.cost.arithmetic()).sum::<usize>()
        };
        let whole = cost(quote!((s - r * cos(theta)).powi(2) + (r * sin(theta)).powi(2) == l.powi(2);));
        let half = cost(quote!((s - r * cos(theta)).powi(2) / 2 + (r * sin(theta)).powi(2) / 2 == l.powi(2) / 2;));
        assert_eq!(whole, half);
    }
}
