//! The description of a mechanism.

use crate::number::Operations;

/// The description of a mechanism: its quantities, equations, blocks and costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Description {
    /// The name of the structure.
    pub name: &'static str,
    /// The scalar parameters; a point counts as its coordinates.
    pub parameters: &'static [Quantity],
    /// The inputs.
    pub inputs: &'static [Quantity],
    /// The unknowns.
    pub unknowns: &'static [Quantity],
    /// The scalar outputs; a point counts as its coordinates.
    pub outputs: &'static [Quantity],
    /// The equations as declared.
    pub equations: &'static [&'static str],
    /// The blocks in the order in which they are solved.
    pub blocks: &'static [Block],
    /// The highest time derivative.
    pub order: usize,
    /// The cost of each order, position first, in the most expensive assembly.
    pub operations: &'static [Operations],
}

/// A named quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Quantity {
    /// The name of the quantity; the parts of a point `p` are `p.x`, `p.y` and, in space, `p.z`.
    pub name: &'static str,
    /// The dimension of the quantity.
    pub dimension: Dimension,
    /// The first paragraph of its documentation, or an empty string.
    pub description: &'static str,
}

impl Quantity {
    /// A length.
    #[must_use]
    pub const fn length(name: &'static str, description: &'static str) -> Self {
        Self {
            name,
            dimension: Dimension::Length,
            description,
        }
    }

    /// An angle.
    #[must_use]
    pub const fn angle(name: &'static str, description: &'static str) -> Self {
        Self {
            name,
            dimension: Dimension::Angle,
            description,
        }
    }

    /// A plain number.
    #[must_use]
    pub const fn scalar(name: &'static str, description: &'static str) -> Self {
        Self {
            name,
            dimension: Dimension::Scalar,
            description,
        }
    }
}

/// The dimension of a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Dimension {
    /// A length, in the mechanism's own unit.
    Length,
    /// An angle, in radians.
    Angle,
    /// A plain number.
    Scalar,
}

/// A block: unknowns that are solved together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Block {
    /// The names of the unknowns, separated by commas.
    pub unknowns: &'static str,
    /// The method of solution: the closed form, or Newton's method.
    pub solution: &'static str,
    /// The indices of these unknowns among the unknowns of the mechanism, in ascending order.
    pub members: &'static [usize],
    /// The indices of the scalar equations that determine them, in ascending order. There are as many equations as
    /// unknowns.
    pub equations: &'static [usize],
}
