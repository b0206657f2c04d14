//! Expressions in which only the linear parts are multiplied out.

use std::collections::{BTreeMap, BTreeSet};

use super::{Expansion, Graph, Node, NodeKind, Variables};

/// Multiplies out the linear parts of expressions: those without products of varying expressions, such as the
/// components of vectors.
///
/// Products of such parts stay products. So a squared length v·v has the derivatives 2 v·v′, 2 v·v″ + 2 v′·v′, …, which
/// share the derivatives of v. Multiplied out, it is a sum over all pairs of terms of v.
#[derive(Default)]
pub(crate) struct LinearParts {
    linear: BTreeMap<Node, bool>,
    /// The largest linear parts, and all that has been rewritten with them.
    multiplied_out: BTreeMap<Node, Node>,
}

impl LinearParts {
    /// An expression with its linear parts multiplied out.
    pub(crate) fn multiply_out(&mut self, graph: &mut Graph, node: Node) -> Node {
        let mut seen = BTreeSet::new();
        let mut pending = vec![node];
        while let Some(part) = pending.pop() {
            if self.multiplied_out.contains_key(&part) || !seen.insert(part) {
                continue;
            }
            if self.is_linear(graph, part) {
                let polynomial = Expansion::new(graph, Variables::Position).polynomial(part);
                let multiplied_out = polynomial.map_or(part, |polynomial| polynomial.node(graph));
                self.multiplied_out.insert(part, multiplied_out);
            } else {
                pending.extend(graph.operands(part).into_iter().rev());
            }
        }
        graph.substitute(node, &mut self.multiplied_out)
    }

    /// Whether an expression contains no product of varying expressions, except within functions.
    fn is_linear(&mut self, graph: &Graph, node: Node) -> bool {
        if let Some(&known) = self.linear.get(&node) {
            return known;
        }
        let is_linear = match graph.kind(node) {
            NodeKind::Sum(_, terms) => terms.iter().all(|&(part, _)| self.is_linear(graph, part)),
            NodeKind::Product(factors) => {
                let mut varying = factors
                    .iter()
                    .filter(|&&(factor, _)| graph.varies(factor, Variables::Position));
                match [varying.next(), varying.next()] {
                    [None, _] => true,
                    [Some(&(factor, 1)), None] => self.is_linear(graph, factor),
                    _ => false,
                }
            }
            _ => true,
        };
        self.linear.insert(node, is_linear);
        is_linear
    }
}

#[cfg(test)]
mod tests {
    use super::LinearParts;
    use crate::algebra::{Graph, Symbol};

    /// A factor is multiplied out, its square is not.
    #[test]
    fn products_stay_products() {
        let mut graph = Graph::new();
        let [x, y] = [0, 1].map(|unknown| graph.symbol(Symbol::Unknown(unknown)));
        let length = graph.symbol(Symbol::Parameter(0));
        let sum = graph.add(x, y);
        let factor = graph.multiply(length, sum);
        let [along_x, along_y] = [x, y].map(|unknown| graph.multiply(length, unknown));
        let multiplied_out = graph.add(along_x, along_y);
        let mut parts = LinearParts::default();
        assert_eq!(parts.multiply_out(&mut graph, factor), multiplied_out);
        let shifted = graph.add(factor, x);
        let square = graph.power(shifted, 2);
        let one = graph.one();
        let for_x = graph.add(length, one);
        let for_x = graph.multiply(for_x, x);
        let expected = graph.add(for_x, along_y);
        let expected = graph.power(expected, 2);
        assert_eq!(parts.multiply_out(&mut graph, square), expected);
    }
}
