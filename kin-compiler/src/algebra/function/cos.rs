//! cos x: the derivative is -sin x.

use super::facts::{Calculation, Domain, FunctionFacts, Gives, Inverse, Takes, WorkUnit};
use crate::algebra::Function;

pub(super) const COS: FunctionFacts = FunctionFacts {
    name: "cos",
    form: "cos(x)",
    notation: "cos",
    undone_by: Some("arccos"),
    arity: 1,
    takes: Takes::Angle,
    gives: Gives::Number,
    domain: Domain::Everywhere,
    guard: None,
    inverse: Inverse::None,
    calculation: Calculation::Cosine,
    cost: &[WorkUnit::SineCosine],
    has_zeros: true,
    value: |x| x[0].cos(),
    partials: |graph, x, _| {
        let sine = graph.call(Function::Sin, x);
        vec![graph.negate(sine)]
    },
};
