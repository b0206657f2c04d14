//! sinh x: the derivative is cosh x.

use super::facts::{Calculation, Domain, FunctionFacts, Gives, Inverse, InverseFunction, Takes, WorkUnit};
use crate::algebra::Function;

pub(super) const SINH: FunctionFacts = FunctionFacts {
    name: "sinh",
    form: "sinh(x)",
    notation: "sinh",
    undone_by: Some("arsinh"),
    arity: 1,
    takes: Takes::number("a plain number"),
    gives: Gives::Number,
    domain: Domain::Everywhere,
    guard: None,
    inverse: Inverse::One(InverseFunction::Elementary(Function::Asinh)),
    calculation: Calculation::Method,
    cost: &[WorkUnit::Other],
    has_zeros: true,
    value: |x| x[0].sinh(),
    partials: |graph, x, _| vec![graph.call(Function::Cosh, x)],
};
