//! atan2(y, x): the derivatives are x / (x² + y²) by y and -y / (x² + y²) by x.

use super::facts::{Calculation, Domain, FunctionFacts, Gives, Inverse, Takes, WorkUnit};

pub(super) const ATAN2: FunctionFacts = FunctionFacts {
    name: "atan2",
    form: "atan2(y, x)",
    notation: "atan2",
    undone_by: None,
    arity: 2,
    takes: Takes::Alike,
    gives: Gives::Angle,
    domain: Domain::Part {
        contains: |v| v[0] != 0.0 || v[1] != 0.0,
        text: "excludes the point (0, 0)",
    },
    guard: None,
    inverse: Inverse::None,
    calculation: Calculation::Method,
    cost: &[WorkUnit::ArcTangent],
    has_zeros: true,
    value: |v| v[0].atan2(v[1]),
    partials: |graph, v, _| {
        let (y, x) = (v[0], v[1]);
        let (y2, x2) = (graph.power(y, 2), graph.power(x, 2));
        let square = graph.add(x2, y2);
        let by_y = graph.divide(x, square);
        let by_x = graph.divide(y, square);
        vec![by_y, graph.negate(by_x)]
    },
};
