//! An unknown inside of one invertible function: f(g(x)) = v, solved as g(x) = f⁻¹(v).

use super::single;
use crate::algebra::{Expansion, Graph, Harmonic, Inverse, NodeKind, Polynomial, Variables};
use crate::structure::ClosedForm;

pub(super) fn recognise(graph: &mut Graph, equation: &Polynomial, unknown: usize) -> Option<ClosedForm> {
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
    match inverse {
        Inverse::None => None,
        Inverse::One(inverse) => {
            let (result, result_node) = graph.new_step();
            let remaining = graph.subtract(arguments[0], result_node);
            let polynomial = Expansion::new(graph, Variables::Unknowns(&[unknown])).equation(remaining);
            let then = Box::new(single(graph, &polynomial, unknown)?);
            Some(ClosedForm::Inverse {
                function,
                inverse,
                value,
                result,
                then,
            })
        }
        Inverse::Even(inverse) => {
            let argument = Expansion::new(graph, Variables::Unknowns(&[unknown])).equation(arguments[0]);
            match single(graph, &argument, unknown)? {
                ClosedForm::Linear { coefficient, right, .. } => Some(ClosedForm::EvenInverse {
                    function,
                    inverse,
                    unknown,
                    coefficient,
                    offset: right,
                    value,
                }),
                // one assembly cannot tell the solutions apart if each of the two arguments has several
                _ => None,
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{Function, Node, Symbol};

    fn form(graph: &mut Graph, node: Node) -> Option<ClosedForm> {
        let equation = Expansion::new(graph, Variables::Unknowns(&[0])).equation(node);
        recognise(graph, &equation, 0)
    }

    /// One function of the unknown is inverted, times a number or a parameter and with what is free of the unknown beside it.
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
