//! Links that rotate.

use super::complex::ComplexNode;
use crate::algebra::{Angle, Graph, Node};

/// A link that rotates: factor · cis(± angle).
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Arm {
    /// The direction, an integer combination of unknowns.
    pub(crate) angle: Angle,
    /// Whether the link rotates clockwise as the angle grows.
    pub(crate) mirrored: bool,
    pub(crate) factor: ComplexNode,
}

impl Arm {
    /// The link as a vector.
    pub(crate) fn vector(&self, graph: &mut Graph) -> ComplexNode {
        let angle = self.signed_angle(graph);
        let unit = ComplexNode::new(graph.cosine(angle), graph.sine(angle));
        self.factor.times(graph, unit)
    }

    /// The quotient of another link's vector and this one, times the square of this link's length. The result has two
    /// factors: a constant, and the unit vector of the angle between the directions.
    pub(crate) fn turn_to(&self, graph: &mut Graph, other: &Self) -> (ComplexNode, ComplexNode) {
        let (this_angle, other_angle) = (self.signed_angle(graph), other.signed_angle(graph));
        let between = graph.subtract(other_angle, this_angle);
        let conjugate = self.factor.conjugate(graph);
        let ratio = conjugate.times(graph, other.factor);
        (ratio, ComplexNode::new(graph.cosine(between), graph.sine(between)))
    }

    fn signed_angle(&self, graph: &mut Graph) -> Node {
        let angle = self.angle.node(graph);
        if self.mirrored { graph.negate(angle) } else { angle }
    }
}
