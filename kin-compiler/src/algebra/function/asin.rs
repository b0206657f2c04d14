//! asin x: the derivative is 1 / √(1 - x²).

use super::facts::{Calculation, Checked, Domain, FunctionFacts, Gives, Inverse, InverseFunction, Takes, WorkUnit};
use crate::algebra::{Function, Graph, Node};

/// √(1 - x²), the other leg of the right triangle with hypotenuse 1.
pub(super) fn leg(graph: &mut Graph, x: Node) -> Node {
    let square = graph.power(x, 2);
    let one = graph.number(1.0);
    let rest = graph.subtract(one, square);
    graph.call(Function::Sqrt, &[rest])
}

pub(super) const ASIN: FunctionFacts = FunctionFacts {
    name: "asin",
    form: "asin(x)",
    notation: "arcsin",
    undone_by: Some("sin"),
    arity: 1,
    takes: Takes::number("a ratio"),
    gives: Gives::Angle,
    domain: Domain::Part {
        contains: |x| x[0].abs() <= 1.0,
        text: "goes from -1 to 1",
    },
    guard: Some(&Checked {
        name: "arc_sine",
        decides_by_sign: false,
        cost: &[WorkUnit::Other],
    }),
    inverse: Inverse::One(InverseFunction::Checked(&Checked {
        name: "sine_of_arc",
        decides_by_sign: false,
        cost: &[WorkUnit::SineCosine],
    })),
    calculation: Calculation::Method,
    cost: &[WorkUnit::Other],
    has_zeros: true,
    value: |x| x[0].asin(),
    partials: |graph, x, _| {
        let cosine = leg(graph, x[0]);
        vec![graph.power(cosine, -1)]
    },
};
