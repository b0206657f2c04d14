//! atan x: the derivative is 1 / (1 + x²).

use super::Elementary;

pub(super) const ATAN: Elementary = Elementary {
    name: "atan",
    arity: 1,
    value: |x| x[0].atan(),
    domain: super::everywhere,
    partials: |graph, x, _| {
        let square = graph.power(x[0], 2);
        let one = graph.number(1.0);
        let sum = graph.add(one, square);
        vec![graph.power(sum, -1)]
    },
};
