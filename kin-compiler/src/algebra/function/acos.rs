//! acos x: the derivative is -1 / √(1 - x²).

use super::asin::leg;
use super::facts::{Calculation, Checked, Domain, FunctionFacts, Gives, Inverse, InverseFunction, Takes, WorkUnit};

pub(super) const ACOS: FunctionFacts = FunctionFacts {
    name: "acos",
    form: "acos(x)",
    notation: "arccos",
    undone_by: Some("cos"),
    arity: 1,
    takes: Takes::number("a ratio"),
    gives: Gives::Angle,
    domain: Domain::Part {
        contains: |x| x[0].abs() <= 1.0,
        text: "goes from -1 to 1",
    },
    guard: Some(&Checked {
        name: "arc_cosine",
        decides_by_sign: false,
        cost: &[WorkUnit::Other],
    }),
    inverse: Inverse::One(InverseFunction::Checked(&Checked {
        name: "cosine_of_arc",
        decides_by_sign: false,
        cost: &[WorkUnit::SineCosine],
    })),
    calculation: Calculation::Method,
    cost: &[WorkUnit::Other],
    has_zeros: true,
    value: |x| x[0].acos(),
    partials: |graph, x, _| {
        let sine = leg(graph, x[0]);
        let reciprocal = graph.power(sine, -1);
        vec![graph.negate(reciprocal)]
    },
};
