//! The closed forms that a block may have.

use super::arm::Arm;
use super::complex::ComplexNode;
use crate::algebra::{Checked, Function, Graph, InverseFunction, Node, Symbol};

/// A closed form that solves a block. All expressions are free of the unknowns of the block.
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
    /// f(argument) = value. `then` solves argument = `result` for the unknown.
    Inverse {
        function: Function,
        inverse: InverseFunction,
        value: Node,
        result: Symbol,
        then: Box<Self>,
    },
    /// f(argument) = value with an even f. The solution of argument = `result` is that of coefficient · x = right, and
    /// the solution of argument = 0 is that of coefficient · x = middle.
    EvenInverse {
        function: Function,
        inverse: &'static Checked,
        unknown: usize,
        value: Node,
        result: Symbol,
        /// A number with the sign of the argument's slope in x.
        growth: Node,
        coefficient: Node,
        right: Node,
        middle: Node,
    },
    /// A 2x2 linear system.
    LinearPair {
        unknowns: [usize; 2],
        matrix: [[Node; 2]; 2],
        right: [Node; 2],
    },
    /// A linear system of any size.
    LinearSystem {
        unknowns: Vec<usize>,
        matrix: Vec<Vec<Node>>,
        right: Vec<Node>,
    },
    /// first + second = target, both directions unknown: the intersection of two circles (RRR dyad).
    TwoAngles {
        unknowns: [usize; 2],
        arms: [Arm; 2],
        target: ComplexNode,
    },
    /// arm + length · direction = target: the intersection of a circle and a line (RRP dyad).
    AngleLength {
        angle: usize,
        length: usize,
        arm: Arm,
        direction: ComplexNode,
        target: ComplexNode,
    },
    /// arm = target, where both lengths are equal: the direction of a link that other equations have placed.
    Direction {
        unknown: usize,
        arm: Arm,
        target: ComplexNode,
    },
    /// (length + offset) · cis(± angle) = target: polar form (RPR dyad).
    Polar {
        length: usize,
        angle: usize,
        mirrored: bool,
        offset: ComplexNode,
        target: ComplexNode,
    },
}

impl ClosedForm {
    /// Whether there are two solutions to choose from.
    pub(crate) fn has_assemblies(&self) -> bool {
        match self {
            Self::Linear { .. } | Self::LinearPair { .. } | Self::LinearSystem { .. } | Self::Direction { .. } => false,
            Self::Inverse { then, .. } => then.has_assemblies(),
            _ => true,
        }
    }

    /// Whether the solution inverts a function.
    pub(crate) const fn has_inverse(&self) -> bool {
        matches!(self, Self::Inverse { .. } | Self::EvenInverse { .. })
    }

    /// The name of the form in documentation.
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
            Self::EvenInverse { function, .. } => format!("inverse of {}, with both signs", function.name()),
            Self::LinearPair { .. } => "two linear equations".to_owned(),
            Self::LinearSystem { unknowns, .. } => format!("{} linear equations", unknowns.len()),
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
