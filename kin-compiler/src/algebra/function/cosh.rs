//! cosh x: the derivative is sinh x.

use super::facts::{Calculation, Checked, Domain, FunctionFacts, Gives, Inverse, Takes, WorkUnit};
use crate::algebra::Function;

pub(super) const COSH: FunctionFacts = FunctionFacts {
    name: "cosh",
    form: "cosh(x)",
    notation: "cosh",
    undone_by: Some("arcosh"),
    arity: 1,
    takes: Takes::number("a plain number"),
    gives: Gives::Number,
    domain: Domain::Everywhere,
    guard: None,
    inverse: Inverse::Even(&Checked {
        name: "inverse_hyperbolic_cosine",
        decides_by_sign: false,
        cost: &[WorkUnit::Other],
    }),
    calculation: Calculation::Method,
    cost: &[WorkUnit::Other],
    has_zeros: false,
    value: |x| x[0].cosh(),
    partials: |graph, x, _| vec![graph.call(Function::Sinh, x)],
};
