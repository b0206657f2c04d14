//! tan x: the derivative is 1 + tan² x.

use super::elementary::{Calculation, Domain, Elementary, Gives, Inverse, Takes, Work};

pub(super) const TAN: Elementary = Elementary {
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
    cost: &[Work::SineCosine, Work::Division],
    has_zeros: true,
    value: |x| x[0].tan(),
    partials: |graph, _, value| {
        // 1 + tan² x needs no other function than the value itself
        let square = graph.power(value, 2);
        let one = graph.number(1.0);
        vec![graph.add(one, square)]
    },
};
