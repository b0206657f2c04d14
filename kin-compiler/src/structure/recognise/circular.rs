//! a cos x + b sin x = c.

use crate::algebra::{Angle, Graph, Harmonic, Node, NodeKind, Symbol, TrigonometricPolynomial};
use crate::structure::ClosedForm;

pub(super) fn recognise(graph: &mut Graph, equation: &TrigonometricPolynomial, unknown: usize) -> Option<ClosedForm> {
    let single = Angle(vec![(Symbol::Unknown(unknown), 1)]);
    let zero = graph.zero();
    let (mut a, mut b) = (zero, zero);
    for (monomial, &coefficient) in &equation.0 {
        if !monomial.powers.is_empty() {
            return None;
        }
        match &monomial.harmonic {
            Harmonic::One => {}
            Harmonic::Cosine(angle) if *angle == single => a = coefficient,
            Harmonic::Sine(angle) if *angle == single => b = coefficient,
            _ => return None,
        }
    }
    let free = equation.free_term(graph);
    let c = graph.negate(free);
    if graph.is_zero(b) {
        let (width, radius) = quotient(graph, c, a);
        return Some(ClosedForm::InverseCosine { unknown, radius, width });
    }
    if graph.is_zero(a) {
        let (height, radius) = quotient(graph, c, b);
        return Some(ClosedForm::InverseSine {
            unknown,
            radius,
            height,
        });
    }
    // a change of the equation's sign exchanges the two solutions, so the sign must not depend on how the equation was
    // typed
    if graph.probes_negative(a) {
        let (a, b, c) = (graph.negate(a), graph.negate(b), graph.negate(c));
        return Some(ClosedForm::CosineSine { unknown, a, b, c });
    }
    Some(ClosedForm::CosineSine { unknown, a, b, c })
}

/// Divides two expressions by their common factors. Numbers go to the numerator.
fn quotient(graph: &mut Graph, above: Node, below: Node) -> (Node, Node) {
    let quotient = graph.divide(above, below);
    let (_, bare) = graph.split_coefficient(quotient);
    let divisors: Vec<(Node, i32)> = match graph.kind(bare) {
        NodeKind::Product(factors) => factors.iter().filter(|&&(_, exponent)| exponent < 0).copied().collect(),
        _ => Vec::new(),
    };
    let divisors: Vec<(Node, i32)> = divisors
        .into_iter()
        .map(|(factor, exponent)| (factor, -exponent))
        .collect();
    let below = graph.product(&divisors);
    (graph.multiply(quotient, below), below)
}
