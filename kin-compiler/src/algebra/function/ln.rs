//! ln x: the derivative is 1 / x.

use super::facts::{Calculation, Checked, Domain, FunctionFacts, Gives, Inverse, InverseFunction, Takes, WorkUnit};
use crate::algebra::Function;

/// ln x with a check.
pub(super) const LOGARITHM: Checked = Checked {
    name: "logarithm",
    decides_by_sign: true,
    cost: &[WorkUnit::Other],
};

pub(super) const LN: FunctionFacts = FunctionFacts {
    name: "ln",
    form: "ln(x)",
    notation: "ln",
    undone_by: Some("exp"),
    arity: 1,
    takes: Takes::number("a plain number"),
    gives: Gives::Number,
    domain: Domain::Part {
        contains: |x| x[0] > 0.0,
        text: "contains only numbers above 0",
    },
    guard: Some(&LOGARITHM),
    inverse: Inverse::One(InverseFunction::Elementary(Function::Exp)),
    calculation: Calculation::Method,
    cost: &[WorkUnit::Other],
    has_zeros: true,
    value: |x| x[0].ln(),
    partials: |graph, x, _| vec![graph.power(x[0], -1)],
};
