//! sin x: the derivative is cos x.

use super::Elementary;
use crate::algebra::Function;

pub(super) const SIN: Elementary = Elementary {
    name: "sin",
    arity: 1,
    value: |x| x[0].sin(),
    domain: super::everywhere,
    partials: |graph, x, _| vec![graph.call(Function::Cos, x)],
};
