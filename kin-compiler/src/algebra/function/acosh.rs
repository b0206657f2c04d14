//! acosh x: the derivative is 1 / √(x² - 1).

use super::facts::{Calculation, Checked, Domain, FunctionFacts, Gives, Inverse, InverseFunction, Takes, WorkUnit};
use crate::algebra::Function;

pub(super) const ACOSH: FunctionFacts = FunctionFacts {
    name: "acosh",
    form: "acosh(x)",
    notation: "arcosh",
    undone_by: Some("cosh"),
    arity: 1,
    takes: Takes::number("a ratio"),
    gives: Gives::Number,
    domain: Domain::Part {
        contains: |x| x[0] >= 1.0,
        text: "contains only numbers from 1 on",
    },
    guard: Some(&Checked {
        name: "area_hyperbolic_cosine",
        decides_by_sign: false,
        cost: &[WorkUnit::Other],
    }),
    inverse: Inverse::One(InverseFunction::Checked(&Checked {
        name: "hyperbolic_cosine_of_area",
        decides_by_sign: true,
        cost: &[WorkUnit::Other],
    })),
    calculation: Calculation::Method,
    cost: &[WorkUnit::Other],
    has_zeros: true,
    value: |x| x[0].acosh(),
    partials: |graph, x, _| {
        let square = graph.power(x[0], 2);
        let one = graph.one();
        let difference = graph.subtract(square, one);
        let root = graph.call(Function::Sqrt, &[difference]);
        vec![graph.power(root, -1)]
    },
};
