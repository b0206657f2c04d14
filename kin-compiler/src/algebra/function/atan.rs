//! atan x: the derivative is 1 / (1 + x²).

use super::facts::{Calculation, Checked, Domain, FunctionFacts, Gives, Inverse, InverseFunction, Takes, WorkUnit};

pub(super) const ATAN: FunctionFacts = FunctionFacts {
    name: "atan",
    form: "atan(x)",
    notation: "arctan",
    undone_by: Some("tan"),
    arity: 1,
    takes: Takes::Number {
        wanted: "a ratio",
        instead_of_length: "divide it by a length, or write `atan2(y, x)`",
    },
    gives: Gives::Angle,
    domain: Domain::Everywhere,
    guard: None,
    inverse: Inverse::One(InverseFunction::Checked(&Checked {
        name: "tangent_of_arc",
        decides_by_sign: false,
        cost: &[WorkUnit::SineCosine, WorkUnit::Division],
    })),
    calculation: Calculation::Method,
    cost: &[WorkUnit::ArcTangent],
    has_zeros: true,
    value: |x| x[0].atan(),
    partials: |graph, x, _| {
        let square = graph.power(x[0], 2);
        let one = graph.number(1.0);
        let sum = graph.add(one, square);
        vec![graph.power(sum, -1)]
    },
};
