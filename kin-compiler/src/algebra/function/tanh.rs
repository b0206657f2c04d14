//! tanh x: the derivative is 1 - tanh² x.

use super::atanh::AREA;
use super::facts::{Calculation, Domain, FunctionFacts, Gives, Inverse, InverseFunction, Takes, WorkUnit};

pub(super) const TANH: FunctionFacts = FunctionFacts {
    name: "tanh",
    form: "tanh(x)",
    notation: "tanh",
    undone_by: Some("artanh"),
    arity: 1,
    takes: Takes::number("a plain number"),
    gives: Gives::Number,
    domain: Domain::Everywhere,
    guard: None,
    inverse: Inverse::One(InverseFunction::Checked(&AREA)),
    calculation: Calculation::Method,
    cost: &[WorkUnit::Other],
    has_zeros: true,
    value: |x| x[0].tanh(),
    partials: |graph, _, value| {
        // 1 - tanh² x needs no other function than the value itself, and no power that could become infinite
        let square = graph.power(value, 2);
        let one = graph.one();
        vec![graph.subtract(one, square)]
    },
};
