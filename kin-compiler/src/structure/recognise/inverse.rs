//! An unknown inside one invertible function: f(g(x)) = v, solved as g(x) = f⁻¹(v).

use std::collections::BTreeMap;

use super::single;
use crate::algebra::{Expansion, Graph, Harmonic, Inverse, Node, NodeKind, Symbol, TrigonometricPolynomial, Variables};
use crate::structure::ClosedForm;

pub(super) fn recognise(graph: &mut Graph, equation: &TrigonometricPolynomial, unknown: usize) -> Option<ClosedForm> {
    let mut function_call = None;
    for (monomial, &coefficient) in &equation.0 {
        if monomial.harmonic != Harmonic::One {
            return None;
        }
        match monomial.powers.iter().next() {
            None => {}
            Some((&atom, &1)) if monomial.powers.len() == 1 && function_call.is_none() => {
                function_call = Some((atom, coefficient));
            }
            Some(_) => return None,
        }
    }
    let (atom, coefficient) = function_call?;
    let NodeKind::Call(function, arguments) = graph.kind(atom).clone() else {
        return None;
    };
    let inverse = function.inverse();
    if inverse == Inverse::None {
        return None;
    }
    let free = equation.free_term(graph);
    let quotient = graph.divide(free, coefficient);
    let value = graph.negate(quotient);
    let (result, result_node) = graph.new_step();
    let remaining = graph.subtract(arguments[0], result_node);
    let polynomial = Expansion::new(graph, Variables::Unknowns(&[unknown])).equation(remaining);
    let then = single(graph, &polynomial, unknown)?;
    match (inverse, then) {
        (Inverse::One(inverse), then) => Some(ClosedForm::Inverse {
            function,
            inverse,
            value,
            result,
            then: Box::new(then),
        }),
        (Inverse::Even(inverse), ClosedForm::Linear { coefficient, right, .. }) => {
            let zero = graph.zero();
            let middle = graph.substitute(right, &mut BTreeMap::from([(result_node, zero)]));
            let slope = graph.partial(arguments[0], Symbol::Unknown(unknown));
            Some(ClosedForm::EvenInverse {
                function,
                inverse,
                unknown,
                value,
                result,
                growth: of_the_same_sign(graph, slope),
                coefficient,
                right,
                middle,
            })
        }
        // one assembly cannot distinguish four solutions
        (Inverse::Even(_) | Inverse::None, _) => None,
    }
}

/// A simpler expression with the sign of `node`, without numbers and powers of even exponents.
fn of_the_same_sign(graph: &mut Graph, node: Node) -> Node {
    let (coefficient, bare) = graph.split_coefficient(node);
    let factors = match graph.kind(bare) {
        NodeKind::Product(factors) => factors
            .iter()
            .filter(|(_, exponent)| exponent % 2 != 0)
            .map(|&(factor, _)| (factor, 1))
            .collect(),
        _ => vec![(bare, 1)],
    };
    let product = graph.product(&factors);
    match graph.constant_value(product) {
        Some(value) => graph.number((coefficient * value).signum()),
        None => graph.scale(coefficient.signum(), product),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::Function;

    fn form(graph: &mut Graph, node: Node) -> Option<ClosedForm> {
        let equation = Expansion::new(graph, Variables::Unknowns(&[0])).equation(node);
        recognise(graph, &equation, 0)
    }

    /// A single function of the unknown is inverted, with a number or a parameter as its factor and terms free of the
    /// unknown beside it.
    #[test]
    fn a_single_function_is_inverted() {
        let mut graph = Graph::new();
        let [p, q] = [0, 1].map(|index| graph.symbol(Symbol::Parameter(index)));
        let x = graph.symbol(Symbol::Unknown(0));
        let inside = graph.linear(1.0, &[(x, 2.0)]);
        let exponential = graph.call(Function::Exp, &[inside]);
        let scaled = graph.multiply(p, exponential);
        let equation = graph.linear(0.0, &[(scaled, 1.0), (q, -1.0)]);
        let Some(ClosedForm::Inverse {
            function: Function::Exp,
            value,
            then,
            ..
        }) = form(&mut graph, equation)
        else {
            panic!("p exp(2 x + 1) = q");
        };
        assert_eq!(value, graph.divide(q, p));
        assert!(matches!(*then, ClosedForm::Linear { unknown: 0, .. }));
    }

    /// A hyperbolic cosine has two solutions, one on each side of the middle. The growth has the sign of the unknown's
    /// coefficient.
    #[test]
    fn an_even_function_is_inverted_twice() {
        let mut graph = Graph::new();
        let [p, q] = [0, 1].map(|index| graph.symbol(Symbol::Parameter(index)));
        let x = graph.symbol(Symbol::Unknown(0));
        let (negative, reciprocal) = (graph.negate(p), graph.power(p, -1));
        let (one, minus_one) = (graph.one(), graph.number(-1.0));
        for (factor, expected) in [
            (one, one),
            (minus_one, minus_one),
            (p, p),
            (negative, negative),
            (reciprocal, p),
        ] {
            let product = graph.multiply(factor, x);
            let argument = graph.linear(0.0, &[(product, 2.0), (q, -1.0)]);
            let cosine = graph.call(Function::Cosh, &[argument]);
            let equation = graph.linear(-3.0, &[(cosine, 1.0)]);
            let Some(ClosedForm::EvenInverse {
                growth,
                coefficient,
                right,
                middle,
                ..
            }) = form(&mut graph, equation)
            else {
                panic!("cosh(2 factor x - q) = 3");
            };
            assert_eq!(growth, expected);
            // x is in the middle if the argument is zero
            let (center, expected) = (graph.divide(middle, coefficient), graph.divide(q, factor));
            assert_eq!(center, graph.scale(0.5, expected));
            assert_ne!(right, middle);
        }
        // each of the two solutions would give two more
        let square = graph.power(x, 2);
        let cosine = graph.call(Function::Cosh, &[square]);
        let equation = graph.linear(-3.0, &[(cosine, 1.0)]);
        assert!(form(&mut graph, equation).is_none());
    }

    #[test]
    fn more_than_one_function_is_not() {
        let mut graph = Graph::new();
        let x = graph.symbol(Symbol::Unknown(0));
        let (exponential, root) = (graph.call(Function::Exp, &[x]), graph.call(Function::Sqrt, &[x]));
        let (cosine, square) = (graph.cosine(x), graph.power(exponential, 2));
        let product = graph.multiply(exponential, root);
        let arc = graph.call(Function::Atan2, &[x, exponential]);
        for other in [root, cosine, x] {
            let equation = graph.linear(-3.0, &[(exponential, 1.0), (other, 1.0)]);
            assert!(form(&mut graph, equation).is_none());
        }
        for alone in [square, product, cosine, arc] {
            let equation = graph.linear(-3.0, &[(alone, 1.0)]);
            assert!(form(&mut graph, equation).is_none());
        }
    }
}
