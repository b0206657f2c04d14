//! asinh x: the derivative is 1 / √(1 + x²).

use super::facts::{Calculation, Domain, FunctionFacts, Gives, Inverse, InverseFunction, Takes, WorkUnit};
use crate::algebra::Function;

pub(super) const ASINH: FunctionFacts = FunctionFacts {
    name: "asinh",
    form: "asinh(x)",
    notation: "arsinh",
    undone_by: Some("sinh"),
    arity: 1,
    takes: Takes::number("a ratio"),
    gives: Gives::Number,
    domain: Domain::Everywhere,
    guard: None,
    inverse: Inverse::One(InverseFunction::Elementary(Function::Sinh)),
    calculation: Calculation::Method,
    cost: &[WorkUnit::Other],
    has_zeros: true,
    value: |x| x[0].asinh(),
    partials: |graph, x, _| {
        let square = graph.power(x[0], 2);
        let one = graph.one();
        let sum = graph.add(one, square);
        let root = graph.call(Function::Sqrt, &[sum]);
        vec![graph.power(root, -1)]
    },
};
