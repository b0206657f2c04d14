//! tan x: the derivative is 1 + tan² x.

use super::facts::{Calculation, Domain, FunctionFacts, Gives, Inverse, Takes, WorkUnit};

pub(super) const TAN: FunctionFacts = FunctionFacts {
    name: "tan",
    form: "tan(x)",
    notation: "tan",
    undone_by: Some("arctan"),
    arity: 1,
    takes: Takes::Angle,
    gives: Gives::Number,
    domain: Domain::Between {
        divisor: |graph, x| graph.cosine(x[0]),
        text: "excludes the odd quarter turns",
    },
    guard: None,
    inverse: Inverse::None,
    calculation: Calculation::Tangent,
    cost: &[WorkUnit::SineCosine, WorkUnit::Division],
    has_zeros: true,
    value: |x| x[0].tan(),
    partials: |graph, _, value| {
        // 1 + tan² x needs no other function than the value itself
        let square = graph.power(value, 2);
        let one = graph.number(1.0);
        vec![graph.add(one, square)]
    },
};
