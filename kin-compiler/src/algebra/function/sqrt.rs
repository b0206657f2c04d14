//! √x: the derivative is 1 / (2 √x).

use super::facts::{Calculation, Checked, Domain, FunctionFacts, Gives, Inverse, InverseFunction, Takes, WorkUnit};

pub(super) const SQRT: FunctionFacts = FunctionFacts {
    name: "sqrt",
    form: "sqrt(x)",
    notation: "sqrt",
    undone_by: None,
    arity: 1,
    takes: Takes::Anything,
    gives: Gives::Root,
    domain: Domain::Part {
        contains: |x| x[0] >= 0.0,
        text: "contains only numbers from 0 on",
    },
    guard: Some(&Checked {
        name: "square_root_of",
        decides_by_sign: true,
        cost: &[WorkUnit::SquareRoot],
    }),
    inverse: Inverse::One(InverseFunction::Checked(&Checked {
        name: "square_of_root",
        decides_by_sign: true,
        cost: &[WorkUnit::Multiplication],
    })),
    calculation: Calculation::Method,
    cost: &[WorkUnit::SquareRoot],
    has_zeros: true,
    value: |x| x[0].sqrt(),
    partials: |graph, _, value| {
        let reciprocal = graph.power(value, -1);
        vec![graph.scale(0.5, reciprocal)]
    },
};
