//! The description of a mechanism.

use crate::number::Operations;
use crate::quantity::Quantity;

/// The description of a mechanism: its quantities, equations, blocks and costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
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

impl Description {
    /// The description that generated code makes.
    #[doc(hidden)]
    #[expect(clippy::too_many_arguments, reason = "one for each field, in their order")]
    #[must_use]
    pub const fn __new(
        name: &'static str,
        parameters: &'static [Quantity],
        inputs: &'static [Quantity],
        unknowns: &'static [Quantity],
        outputs: &'static [Quantity],
        equations: &'static [&'static str],
        blocks: &'static [Block],
        order: usize,
        operations: &'static [Operations],
    ) -> Self {
        Self {
            name,
            parameters,
            inputs,
            unknowns,
            outputs,
            equations,
            blocks,
            order,
            operations,
        }
    }
}

/// A block: unknowns that are solved together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
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

impl Block {
    /// The block that generated code makes.
    #[doc(hidden)]
    #[must_use]
    pub const fn __new(
        unknowns: &'static str,
        solution: &'static str,
        members: &'static [usize],
        equations: &'static [usize],
    ) -> Self {
        Self {
            unknowns,
            solution,
            members,
            equations,
        }
    }
}
