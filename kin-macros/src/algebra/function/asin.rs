//! asin x: the derivative is 1 / √(1 - x²).

use super::Elementary;
use crate::algebra::{Function, Graph, Node};

/// √(1 - x²), the other leg of the right triangle with hypotenuse 1.
pub(super) fn leg(graph: &mut Graph, x: Node) -> Node {
    let square = graph.power(x, 2);
    let one = graph.number(1.0);
    let rest = graph.subtract(one, square);
    graph.call(Function::Sqrt, &[rest])
}

pub(super) const ASIN: Elementary = Elementary {
    name: "asin",
    arity: 1,
    value: |x| x[0].asin(),
    domain: |x| x[0].abs() <= 1.0,
    partials: |graph, x, _| {
        let cosine = leg(graph, x[0]);
        vec![graph.power(cosine, -1)]
    },
};
