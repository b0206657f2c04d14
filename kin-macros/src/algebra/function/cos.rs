//! cos x: the derivative is -sin x.

use super::elementary::{Calculation, Domain, Elementary, Gives, Inverse, Takes, Work};
use crate::algebra::Function;

pub(super) const COS: Elementary = Elementary {
    name: "cos",
    form: "cos(x)",
    notation: "cos",
    undone_by: Some("arccos"),
    arity: 1,
    takes: Takes::Angle,
    gives: Gives::Number,
    domain: Domain::Everywhere,
    guard: None,
    inverse: Inverse::None,
    calculation: Calculation::Cosine,
    cost: &[Work::SineCosine],
    has_zeros: true,
    value: |x| x[0].cos(),
    partials: |graph, x, _| {
        let sine = graph.call(Function::Sin, x);
        vec![graph.negate(sine)]
    },
};
