//! sin x: the derivative is cos x.

use super::facts::{Calculation, Domain, FunctionFacts, Gives, Inverse, Takes, WorkUnit};
use crate::algebra::Function;

pub(super) const SIN: FunctionFacts = FunctionFacts {
    name: "sin",
    form: "sin(x)",
    notation: "sin",
    undone_by: Some("arcsin"),
    arity: 1,
    takes: Takes::Angle,
    gives: Gives::Number,
    domain: Domain::Everywhere,
    guard: None,
    inverse: Inverse::None,
    calculation: Calculation::Sine,
    cost: &[WorkUnit::SineCosine],
    has_zeros: true,
    value: |x| x[0].sin(),
    partials: |graph, x, _| vec![graph.call(Function::Cos, x)],
};
