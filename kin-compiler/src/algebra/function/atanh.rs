//! atanh x: the derivative is 1 / (1 - x²).

use super::facts::{Calculation, Checked, Domain, FunctionFacts, Gives, Inverse, InverseFunction, Takes, WorkUnit};
use crate::algebra::Function;

/// atanh x with a check.
pub(super) const AREA: Checked = Checked {
    name: "area_hyperbolic_tangent",
    decides_by_sign: false,
    cost: &[WorkUnit::Other],
};

pub(super) const ATANH: FunctionFacts = FunctionFacts {
    name: "atanh",
    form: "atanh(x)",
    notation: "artanh",
    undone_by: Some("tanh"),
    arity: 1,
    takes: Takes::number("a ratio"),
    gives: Gives::Number,
    domain: Domain::Part {
        contains: |x| x[0].abs() < 1.0,
        text: "contains only numbers above -1 and below 1",
    },
    guard: Some(&AREA),
    inverse: Inverse::One(InverseFunction::Elementary(Function::Tanh)),
    calculation: Calculation::Method,
    cost: &[WorkUnit::Other],
    has_zeros: true,
    value: |x| x[0].atanh(),
    partials: |graph, x, _| {
        let square = graph.power(x[0], 2);
        let one = graph.one();
        let difference = graph.subtract(one, square);
        vec![graph.power(difference, -1)]
    },
};
