//! √x: the derivative is 1 / (2 √x).

use super::Elementary;

pub(super) const SQRT: Elementary = Elementary {
    name: "sqrt",
    arity: 1,
    value: |x| x[0].sqrt(),
    domain: |x| x[0] >= 0.0,
    partials: |graph, _, value| {
        let reciprocal = graph.power(value, -1);
        vec![graph.scale(0.5, reciprocal)]
    },
};
