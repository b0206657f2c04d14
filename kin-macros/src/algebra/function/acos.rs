//! acos x: the derivative is -1 / √(1 - x²).

use super::Elementary;
use super::asin::leg;

pub(super) const ACOS: Elementary = Elementary {
    name: "acos",
    arity: 1,
    value: |x| x[0].acos(),
    domain: |x| x[0].abs() <= 1.0,
    partials: |graph, x, _| {
        let sine = leg(graph, x[0]);
        let reciprocal = graph.power(sine, -1);
        vec![graph.negate(reciprocal)]
    },
};
