//! An unknown inside of one invertible function: f(g(x)) = v, solved as g(x) = f⁻¹(v).

use super::single;
use crate::algebra::{Expansion, Function, Graph, Harmonic, Polynomial, Term, Variables};
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
    let Term::Call(function, arguments) = graph.term(atom).clone() else {
        return None;
    };
    if !is_invertible(function) {
        return None;
    }
    let free = equation.free_term(graph);
    let quotient = graph.divide(free, coefficient);
    let value = graph.negate(quotient);
    let (result, result_node) = graph.new_step();
    let remaining = graph.subtract(arguments[0], result_node);
    let polynomial = Expansion::new(graph, Variables::Unknowns(&[unknown])).equation(remaining);
    let then = Box::new(single(graph, &polynomial, unknown)?);
    Some(ClosedForm::Inverse {
        function,
        value,
        result,
        then,
    })
}

/// Sine and cosine have a closed form of their own, with both solutions; two arguments have no inverse.
const fn is_invertible(function: Function) -> bool {
    match function {
        Function::Sqrt | Function::Asin | Function::Acos | Function::Atan | Function::Exp | Function::Ln => true,
        Function::Sin | Function::Cos | Function::Tan | Function::Atan2 => false,
    }
}
