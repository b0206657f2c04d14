//! a cos x + b sin x = c.

use crate::expr::{Angle, Graph, Harmonic, Polynomial, Symbol};
use crate::structure::ClosedForm;

pub(super) fn recognise(graph: &mut Graph, equation: &Polynomial, unknown: usize) -> Option<ClosedForm> {
    let own = Angle(vec![(Symbol::Unknown(unknown), 1)]);
    let zero = graph.zero();
    let (mut a, mut b) = (zero, zero);
    for (monomial, &coefficient) in &equation.0 {
        if !monomial.powers.is_empty() {
            return None;
        }
        match &monomial.harmonic {
            Harmonic::One => {}
            Harmonic::Cosine(angle) if *angle == own => a = coefficient,
            Harmonic::Sine(angle) if *angle == own => b = coefficient,
            _ => return None,
        }
    }
    let free = equation.free_term(graph);
    let c = graph.negate(free);
    if graph.is_zero(b) {
        let cosine = graph.divide(c, a);
        return Some(ClosedForm::InverseCosine { unknown, cosine });
    }
    if graph.is_zero(a) {
        let sine = graph.divide(c, b);
        return Some(ClosedForm::InverseSine { unknown, sine });
    }
    // the two solutions change places with the equation's sign, which must not depend on how it was typed
    if graph.probes_negative(a) {
        let (a, b, c) = (graph.negate(a), graph.negate(b), graph.negate(c));
        return Some(ClosedForm::CosineSine { unknown, a, b, c });
    }
    Some(ClosedForm::CosineSine { unknown, a, b, c })
}
