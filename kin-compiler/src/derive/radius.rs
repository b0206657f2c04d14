//! The determinant of a length and its direction: m cos² x + m sin² x = m.

use crate::algebra::{Function, Graph, Node, NodeKind};
use crate::passes::{Pass, Passes};

/// Returns m for an expression m cos² x + m sin² x, and any other expression as it is.
pub(super) fn radius(graph: &mut Graph, expression: Node, passes: Passes) -> Node {
    if !passes.include(Pass::Radii) {
        return expression;
    }
    found(graph, expression).unwrap_or(expression)
}

fn found(graph: &mut Graph, expression: Node) -> Option<Node> {
    let NodeKind::Sum(constant, terms) = graph.kind(expression).clone() else {
        return None;
    };
    let &[(first, coefficient), (second, other)] = terms.as_slice() else {
        return None;
    };
    if constant.get() != 0.0 || coefficient != other {
        return None;
    }
    [(first, second), (second, first)]
        .into_iter()
        .find_map(|(by_cosine, by_sine)| {
            let angles: Vec<Node> = graph
                .operands(by_cosine)
                .into_iter()
                .filter_map(|factor| match graph.kind(factor) {
                    NodeKind::Call(Function::Cos, arguments) => Some(arguments[0]),
                    _ => None,
                })
                .collect();
            angles.into_iter().find_map(|angle| {
                let (cosine, sine) = (graph.cosine(angle), graph.sine(angle));
                let radius = graph.product(&[(by_cosine, 1), (cosine, -2)]);
                let expected = graph.product(&[(radius, 1), (sine, 2)]);
                (expected == by_sine).then(|| graph.scale(coefficient.get(), radius))
            })
        })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::Symbol;

    #[test]
    fn squares_of_cosine_and_sine_of_one_angle_with_one_factor_are_that_factor() {
        let mut graph = Graph::new();
        let [x, y, length] = [Symbol::Unknown(0), Symbol::Unknown(1), Symbol::Unknown(2)].map(|s| graph.symbol(s));
        let (cosine, sine, other) = (graph.cosine(x), graph.sine(x), graph.sine(y));
        let by_cosine = graph.product(&[(length, 1), (cosine, 2)]);
        let by_sine = graph.product(&[(length, 1), (sine, 2)]);
        let by_other = graph.product(&[(length, 1), (other, 2)]);
        let expected = graph.scale(-3.0, length);
        let both = graph.linear(0.0, &[(by_cosine, -3.0), (by_sine, -3.0)]);
        assert_eq!(found(&mut graph, both), Some(expected));
        for terms in [
            [(by_cosine, 1.0), (by_sine, -1.0)],
            [(by_cosine, 1.0), (by_other, 1.0)],
            [(by_sine, 1.0), (by_other, 1.0)],
        ] {
            let sum = graph.linear(0.0, &terms);
            assert_eq!(found(&mut graph, sum), None);
        }
        let more = graph.linear(1.0, &[(by_cosine, 1.0), (by_sine, 1.0)]);
        assert_eq!(found(&mut graph, more), None);
    }
}
