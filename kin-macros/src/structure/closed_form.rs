//! The closed forms that a block may have.

use super::arm::Arm;
use crate::expr::{Graph, Node, Symbol};
use crate::function::Function;

/// A complex number, or plane vector, of known expressions.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct Complex {
    pub(crate) re: Node,
    pub(crate) im: Node,
}

impl Complex {
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

    /// The quotient; by a real number it takes no more than two divisions.
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

/// How a block is solved. Every expression is free of the block's own unknowns.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum ClosedForm {
    /// coefficient · x = right.
    Linear {
        unknown: usize,
        coefficient: Node,
        right: Node,
    },
    /// x² = square.
    SquareRoot { unknown: usize, square: Node },
    /// a x² + b x + c = 0.
    Quadratic { unknown: usize, a: Node, b: Node, c: Node },
    /// radius · cos x = width.
    InverseCosine { unknown: usize, radius: Node, width: Node },
    /// radius · sin x = height.
    InverseSine { unknown: usize, radius: Node, height: Node },
    /// a cos x + b sin x = c.
    CosineSine { unknown: usize, a: Node, b: Node, c: Node },
    /// f(argument) = value, where `then` solves argument = `result` for the unknown.
    Inverse {
        function: Function,
        value: Node,
        result: Symbol,
        then: Box<Self>,
    },
    /// A 2x2 linear system.
    LinearPair {
        unknowns: [usize; 2],
        matrix: [[Node; 2]; 2],
        right: [Node; 2],
    },
    /// first + second = target, both directions unknown: two circles meet (RRR dyad).
    TwoAngles {
        unknowns: [usize; 2],
        arms: [Arm; 2],
        target: Complex,
    },
    /// arm + length · direction = target: a circle meets a line (RRP dyad).
    AngleLength {
        angle: usize,
        length: usize,
        arm: Arm,
        direction: Complex,
        target: Complex,
    },
    /// arm = target, where their lengths are equal: the direction of a link that other equations have placed.
    Direction { unknown: usize, arm: Arm, target: Complex },
    /// (length + offset) · cis(± angle) = target: polar form (RPR dyad).
    Polar {
        length: usize,
        angle: usize,
        mirrored: bool,
        offset: Complex,
        target: Complex,
    },
}

impl ClosedForm {
    /// Whether there are two solutions to choose from.
    pub(crate) fn has_assemblies(&self) -> bool {
        match self {
            Self::Linear { .. } | Self::LinearPair { .. } | Self::Direction { .. } => false,
            Self::Inverse { then, .. } => then.has_assemblies(),
            _ => true,
        }
    }

    /// Whether a function is inverted on the way.
    pub(crate) const fn has_inverse(&self) -> bool {
        matches!(self, Self::Inverse { .. })
    }

    /// What documentation calls it.
    pub(crate) fn description(&self, graph: &Graph) -> String {
        match self {
            Self::Linear { .. } => "linear equation".to_owned(),
            Self::SquareRoot { .. } => "square root".to_owned(),
            Self::Quadratic { .. } => "quadratic equation".to_owned(),
            Self::InverseCosine { .. } => "inverse cosine".to_owned(),
            Self::InverseSine { .. } => "inverse sine".to_owned(),
            Self::CosineSine { .. } => "a cos x + b sin x = c".to_owned(),
            Self::Inverse { function, then, .. } => {
                format!("inverse of {}, then {}", function.name(), then.description(graph))
            }
            Self::LinearPair { .. } => "two linear equations".to_owned(),
            Self::TwoAngles { .. } => "circle meets circle (RRR dyad)".to_owned(),
            Self::AngleLength { .. } => "circle meets line (RRP dyad)".to_owned(),
            Self::Direction { .. } => "direction of a placed link".to_owned(),
            Self::Polar { offset, .. } if graph.is_zero(offset.re) && graph.is_zero(offset.im) => {
                "polar form (RPR dyad)".to_owned()
            }
            Self::Polar { .. } => "polar form with offset (RPR dyad)".to_owned(),
        }
    }
}
