//! Linear and quadratic equations of one unknown.

use crate::algebra::{Graph, Harmonic, Symbol, TrigonometricPolynomial};
use crate::structure::ClosedForm;

pub(super) fn recognise(graph: &mut Graph, equation: &TrigonometricPolynomial, unknown: usize) -> Option<ClosedForm> {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{Expansion, Function, Node, Variables};

    /// The form of `node == 0` for the first unknown.
    fn form(graph: &mut Graph, node: Node) -> Option<ClosedForm> {
        let equation = Expansion::new(graph, Variables::Unknowns(&[0])).equation(node);
        recognise(graph, &equation, 0)
    }

    /// An equation has this form only if its terms contain the unknown's first two powers, and no other term depends on
    /// the unknown.
    #[test]
    fn powers_are_those_of_the_unknown_itself() {
        let mut graph = Graph::new();
        let (x, p) = (graph.symbol(Symbol::Unknown(0)), graph.symbol(Symbol::Parameter(0)));
        let (square, cube) = (graph.power(x, 2), graph.power(x, 3));
        let root = graph.call(Function::Sqrt, &[x]);
        let by_root = graph.multiply(x, root);

        let linear = graph.linear(-1.0, &[(x, 2.0), (p, 1.0)]);
        assert!(matches!(form(&mut graph, linear), Some(ClosedForm::Linear { .. })));
        let pure = graph.linear(0.0, &[(square, 2.0), (p, -1.0)]);
        assert!(matches!(form(&mut graph, pure), Some(ClosedForm::SquareRoot { .. })));
        let mixed = graph.linear(-1.0, &[(square, 2.0), (x, 1.0)]);
        assert!(matches!(form(&mut graph, mixed), Some(ClosedForm::Quadratic { .. })));
        for other in [root, by_root, cube] {
            for rest in [p, square, x] {
                let equation = graph.linear(0.0, &[(other, 1.0), (rest, -1.0)]);
                assert!(form(&mut graph, equation).is_none());
            }
        }
    }
}
