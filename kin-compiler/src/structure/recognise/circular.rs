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
    // Both coefficients without a number that they share, and c divided by it, are one multiplication less. A change of
    // the equation's sign exchanges the two solutions, so the sign must not depend on how the equation was typed.
    let size = shared_number(graph, [a, b]).unwrap_or(1.0);
    let divisor = if graph.probes_negative(a) { -size } else { size };
    let [a, b, c] = [a, b, c].map(|part| graph.scale(1.0 / divisor, part));
    Some(ClosedForm::CosineSine { unknown, a, b, c })
}

/// The power of two by which each term of two sums is multiplied, up to its sign. By another number the quotients would
/// be rounded.
fn shared_number(graph: &Graph, sums: [Node; 2]) -> Option<f64> {
    let mut sizes = Vec::new();
    for sum in sums {
        match graph.kind(sum) {
            NodeKind::Sum(constant, terms) if constant.get() == 0.0 => {
                sizes.extend(terms.iter().map(|&(_, coefficient)| coefficient.get().abs()));
            }
            _ => return None,
        }
    }
    let &first = sizes.first()?;
    let is_power = first.is_normal() && (1.0 / first).is_normal() && first.to_bits() << 12 == 0;
    (is_power && sizes.iter().all(|&size| size == first)).then_some(first)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{Expansion, Variables};

    /// 2 p cos x - 2 q sin x + r == 0, typed with either sign. A seventh is no `f64`.
    #[test]
    fn a_power_of_two_that_both_coefficients_share_is_divided_out() {
        let mut graph = Graph::new();
        let x = graph.symbol(Symbol::Unknown(0));
        let [p, q, r] = [0, 1, 2].map(|index| graph.symbol(Symbol::Parameter(index)));
        let (cosine, sine) = (graph.cosine(x), graph.sine(x));
        let (along, across) = (graph.multiply(p, cosine), graph.multiply(q, sine));
        for (number, sign) in [(2.0, 1.0), (2.0, -1.0), (0.25, -1.0), (7.0, 1.0)] {
            let typed = graph.linear(0.0, &[(along, number * sign), (across, -number * sign), (r, sign)]);
            let equation = Expansion::new(&mut graph, Variables::AllUnknowns).equation(typed);
            let Some(ClosedForm::CosineSine { a, b, c, .. }) = recognise(&mut graph, &equation, 0) else {
                panic!("it is linear in the cosine and the sine");
            };
            let (factor, rest) = if number == 7.0 { (7.0, 1.0) } else { (1.0, number) };
            assert_eq!((a, b), (graph.scale(factor, p), graph.scale(-factor, q)));
            assert_eq!(c, graph.scale(-1.0 / rest, r));
        }
    }
}
