//! The value of a formula, as one scalar for each of its parts.

use super::dimension::{Exponent, FormulaType};
use crate::algebra::{Graph, Node};
use crate::syntax::ValueShape;

/// A formula's value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct FormulaValue {
    shape: ValueShape,
    parts: Vec<Node>,
}

impl FormulaValue {
    pub(crate) fn scalar(node: Node) -> Self {
        Self {
            shape: ValueShape::Scalar,
            parts: vec![node],
        }
    }

    pub(crate) fn plane(x: Node, y: Node) -> Self {
        Self {
            shape: ValueShape::Plane,
            parts: vec![x, y],
        }
    }

    pub(crate) fn space(parts: [Node; 3]) -> Self {
        Self {
            shape: ValueShape::Space,
            parts: parts.to_vec(),
        }
    }

    /// A value of as many parts as the shape has.
    pub(crate) fn of(shape: ValueShape, parts: Vec<Node>) -> Self {
        Self { shape, parts }
    }

    /// A rotation from the rows of its matrix.
    pub(crate) fn rotation(rows: [[Node; 3]; 3]) -> Self {
        Self {
            shape: ValueShape::Rotation,
            parts: rows.concat(),
        }
    }

    pub(crate) fn shape(&self) -> ValueShape {
        self.shape
    }

    /// The scalar parts: one, or one for each axis, or the rows of a rotation's matrix.
    pub(crate) fn nodes(&self) -> Vec<Node> {
        self.parts.clone()
    }

    /// The node of a scalar.
    pub(crate) fn as_scalar(&self) -> Option<Node> {
        (self.shape == ValueShape::Scalar).then(|| self.parts[0])
    }

    /// The rows of a rotation's matrix.
    pub(crate) fn rows(&self) -> Vec<&[Node]> {
        self.parts.chunks(3).collect()
    }

    /// The value with a function applied to every part.
    pub(crate) fn map(&self, function: impl FnMut(Node) -> Node) -> Self {
        Self {
            shape: self.shape,
            parts: self.parts.iter().copied().map(function).collect(),
        }
    }

    /// Combines two values of one shape, part by part.
    pub(crate) fn zip(&self, other: &Self, mut function: impl FnMut(Node, Node) -> Node) -> Self {
        Self {
            shape: self.shape,
            parts: self
                .parts
                .iter()
                .zip(&other.parts)
                .map(|(&one, &other)| function(one, other))
                .collect(),
        }
    }

    /// A scalar as a vector along x; a vector as it is.
    pub(crate) fn lifted(&self, graph: &mut Graph, shape: ValueShape) -> Self {
        if self.shape != ValueShape::Scalar || shape == ValueShape::Scalar {
            return self.clone();
        }
        let mut parts = self.parts.clone();
        parts.resize_with(shape.axes().len(), || graph.zero());
        Self { shape, parts }
    }
}

/// A formula's value and its measure.
#[derive(Clone, Debug)]
pub(super) struct Typed {
    pub(super) value: FormulaValue,
    pub(super) exponent: Option<Exponent>,
}

impl Typed {
    pub(super) fn scalar(node: Node, exponent: Exponent) -> Self {
        Self {
            value: FormulaValue::scalar(node),
            exponent: Some(exponent),
        }
    }

    pub(super) fn number(value: FormulaValue) -> Self {
        Self {
            value,
            exponent: Some(Exponent::NUMBER),
        }
    }

    pub(super) fn measure(&self) -> FormulaType {
        FormulaType {
            shape: self.value.shape(),
            exponent: self.exponent,
        }
    }
}
