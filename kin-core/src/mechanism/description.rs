//! What a mechanism says of itself.

use crate::number::Operations;

/// What a mechanism says of itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Description {
    /// The name of the structure.
    pub name: &'static str,
    /// Parameters, scalar by scalar.
    pub parameters: &'static [Quantity],
    /// Inputs.
    pub inputs: &'static [Quantity],
    /// Unknowns.
    pub unknowns: &'static [Quantity],
    /// Outputs, scalar by scalar.
    pub outputs: &'static [Quantity],
    /// The equations as they were declared.
    pub equations: &'static [&'static str],
    /// The blocks in the order in which they are solved.
    pub blocks: &'static [Block],
    /// The highest time derivative.
    pub order: usize,
    /// What each order costs, position first, in the assembly that costs most.
    pub operations: &'static [Operations],
}

/// A named quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// Its name; the parts of a point `p` are `p.x`, `p.y` and, in space, `p.z`.
    pub name: &'static str,
    /// What it measures.
    pub dimension: Dimension,
    /// The first paragraph of its documentation, empty if it has none.
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

/// What a quantity measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// A length, in the mechanism's own unit.
    Length,
    /// An angle, in radians.
    Angle,
    /// A plain number.
    Scalar,
}

/// Unknowns that are solved together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    /// Their names, separated by commas.
    pub unknowns: &'static str,
    /// How they are found: the closed form, or Newton's method.
    pub solution: &'static str,
    /// Their places among the mechanism's unknowns, ascending.
    pub members: &'static [usize],
    /// The places of the scalar equations that determine them, as many, ascending.
    pub equations: &'static [usize],
}
