//! cos x: the derivative is -sin x.

use super::Elementary;
use crate::algebra::Function;

pub(super) const COS: Elementary = Elementary {
    name: "cos",
    arity: 1,
    value: |x| x[0].cos(),
    domain: super::everywhere,
    partials: |graph, x, _| {
        let sine = graph.call(Function::Sin, x);
        vec![graph.negate(sine)]
    },
};
