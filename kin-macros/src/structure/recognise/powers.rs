//! Linear and quadratic equations of one unknown.

use crate::algebra::{Graph, Harmonic, Polynomial, Symbol};
use crate::structure::ClosedForm;

pub(super) fn recognise(graph: &mut Graph, equation: &Polynomial, unknown: usize) -> Option<ClosedForm> {
    let variable = graph.symbol(Symbol::Unknown(unknown));
    let zero = graph.zero();
    let mut coefficients = [zero; 3];
    for (monomial, &coefficient) in &equation.0 {
        if monomial.harmonic != Harmonic::One {
            return None;
        }
        let power = match monomial.powers.iter().next() {
            None => 0,
            Some((&atom, &power)) if atom == variable && monomial.powers.len() == 1 => power,
            Some(_) => return None,
        };
        *coefficients.get_mut(usize::try_from(power).ok()?)? = coefficient;
    }
    let [c, b, a] = coefficients;
    if graph.is_zero(a) {
        let right = graph.negate(c);
        return (!graph.is_zero(b)).then_some(ClosedForm::Linear {
            unknown,
            coefficient: b,
            right,
        });
    }
    if graph.is_zero(b) {
        let quotient = graph.divide(c, a);
        let square = graph.negate(quotient);
        return Some(ClosedForm::SquareRoot { unknown, square });
    }
    Some(ClosedForm::Quadratic { unknown, a, b, c })
}
