//! tan x: the derivative is 1 + tan² x.

use super::Elementary;

pub(super) const TAN: Elementary = Elementary {
    name: "tan",
    arity: 1,
    value: |x| x[0].tan(),
    domain: super::everywhere,
    partials: |graph, _, value| {
        // 1 + tan² x needs no function but the value itself
        let square = graph.power(value, 2);
        let one = graph.number(1.0);
        vec![graph.add(one, square)]
    },
};
