//! ln x: the derivative is 1 / x.

use super::Elementary;

pub(super) const LN: Elementary = Elementary {
    name: "ln",
    arity: 1,
    value: |x| x[0].ln(),
    domain: |x| x[0] > 0.0,
    partials: |graph, x, _| vec![graph.power(x[0], -1)],
};
