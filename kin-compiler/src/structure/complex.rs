//! Complex numbers of expressions, which represent vectors of the plane.

use crate::algebra::{Graph, Node};

/// A complex number, or plane vector, whose parts are expressions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct ComplexNode {
    pub(crate) re: Node,
    pub(crate) im: Node,
}

impl ComplexNode {
    pub(crate) const fn new(re: Node, im: Node) -> Self {
        Self { re, im }
    }

    pub(crate) fn is_real(self, graph: &Graph) -> bool {
        graph.is_zero(self.im)
    }

    pub(crate) fn times(self, graph: &mut Graph, other: Self) -> Self {
        let (a, b) = (graph.multiply(self.re, other.re), graph.multiply(self.im, other.im));
        let (c, d) = (graph.multiply(self.re, other.im), graph.multiply(self.im, other.re));
        Self::new(graph.subtract(a, b), graph.add(c, d))
    }

    pub(crate) fn conjugate(self, graph: &mut Graph) -> Self {
        Self::new(self.re, graph.negate(self.im))
    }

    pub(crate) fn negated(self, graph: &mut Graph) -> Self {
        Self::new(graph.negate(self.re), graph.negate(self.im))
    }

    pub(crate) fn scaled(self, graph: &mut Graph, factor: Node) -> Self {
        Self::new(graph.multiply(self.re, factor), graph.multiply(self.im, factor))
    }

    pub(crate) fn norm_squared(self, graph: &mut Graph) -> Node {
        let (a, b) = (graph.power(self.re, 2), graph.power(self.im, 2));
        graph.add(a, b)
    }

    /// The quotient. A real divisor takes no more than two divisions.
    pub(crate) fn over(self, graph: &mut Graph, divisor: Self) -> Self {
        if divisor.is_real(graph) {
            let reciprocal = graph.power(divisor.re, -1);
            return self.scaled(graph, reciprocal);
        }
        let conjugate = divisor.conjugate(graph);
        let product = self.times(graph, conjugate);
        let square = divisor.norm_squared(graph);
        let reciprocal = graph.power(square, -1);
        product.scaled(graph, reciprocal)
    }
}
