//! A block's Jacobian, and the linear systems that it solves for the rates of every order.

use super::Rate;
use crate::expr::{Graph, Node, Symbol};
use crate::structure::Block;

/// The partial derivatives of a block's equations (rows) by its unknowns (columns).
pub(super) fn jacobian(graph: &mut Graph, residuals: &[Node], block: &Block) -> Vec<Vec<Node>> {
    block
        .equations
        .iter()
        .map(|&equation| {
            block
                .unknowns
                .iter()
                .map(|&unknown| graph.partial(residuals[equation], Symbol::Unknown(unknown)))
                .collect()
        })
        .collect()
}

/// Closed forms have one or two unknowns.
pub(super) fn determinant(graph: &mut Graph, matrix: &[Vec<Node>]) -> Node {
    match matrix {
        [row] => row[0],
        [first, second] => {
            let (main, other) = (graph.multiply(first[0], second[1]), graph.multiply(first[1], second[0]));
            graph.subtract(main, other)
        }
        _ => unreachable!("closed forms have one or two unknowns"),
    }
}

/// The entries on the diagonal of a triangular system: they do not vanish where its determinant does not.
pub(super) fn pivots(graph: &Graph, matrix: &[Vec<Node>]) -> Vec<Node> {
    match matrix {
        [first, second] if first.iter().chain(second).any(|&entry| graph.is_zero(entry)) => first
            .iter()
            .chain(second)
            .copied()
            .filter(|&entry| !graph.is_zero(entry))
            .collect(),
        _ => Vec::new(),
    }
}

/// The rates of one order from J q⁽ⁿ⁾ = right, in the order in which they can be computed.
pub(super) fn solve(
    graph: &mut Graph,
    matrix: &[Vec<Node>],
    right: &[Node],
    unknowns: &[usize],
    order: usize,
) -> Vec<Rate> {
    if let [row] = matrix {
        let value = graph.divide(right[0], row[0]);
        return vec![Rate {
            unknown: unknowns[0],
            value,
        }];
    }
    // a zero in the matrix makes the system triangular: one unknown first, the other from it
    for row in 0..2 {
        for column in 0..2 {
            if graph.is_zero(matrix[row][column]) {
                let (other_row, first) = (1 - row, 1 - column);
                let first_value = graph.divide(right[row], matrix[row][first]);
                let known = graph.symbol(Symbol::UnknownRate(unknowns[first], order));
                let product = graph.multiply(matrix[other_row][first], known);
                let rest = graph.subtract(right[other_row], product);
                let second_value = graph.divide(rest, matrix[other_row][column]);
                return vec![
                    Rate {
                        unknown: unknowns[first],
                        value: first_value,
                    },
                    Rate {
                        unknown: unknowns[column],
                        value: second_value,
                    },
                ];
            }
        }
    }
    let determinant = determinant(graph, matrix);
    let reciprocal = graph.power(determinant, -1);
    (0..2)
        .map(|column| {
            let other = 1 - column;
            let (main, cross) = (
                graph.multiply(matrix[other][other], right[column]),
                graph.multiply(matrix[column][other], right[other]),
            );
            let numerator = graph.subtract(main, cross);
            Rate {
                unknown: unknowns[column],
                value: graph.multiply(numerator, reciprocal),
            }
        })
        .collect()
}
