//! The description of a mechanism.

use crate::number::Operations;
use crate::quantity::{NameKind, Quantity};

/// The description of a mechanism: its quantities, equations, blocks and costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Description<'d> {
    /// The name of the structure.
    pub name: &'d str,
    /// The scalar parameters; a point counts as its coordinates.
    pub parameters: &'d [Quantity<'d>],
    /// The inputs.
    pub inputs: &'d [Quantity<'d>],
    /// The unknowns.
    pub unknowns: &'d [Quantity<'d>],
    /// The scalar outputs; a point counts as its coordinates.
    pub outputs: &'d [Quantity<'d>],
    /// The equations as declared.
    pub equations: &'d [&'d str],
    /// The blocks in the order in which they are solved.
    pub blocks: &'d [Block<'d>],
    /// The highest time derivative.
    pub order: usize,
    /// The cost of each order, position first, in the most expensive assembly.
    pub operations: &'d [Operations],
    /// The names of groups of unknowns in errors, see [`NameKind::Group`]. A declared mechanism has none: its errors
    /// hold texts.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub groups: &'d [&'d str],
}

impl<'d> Description<'d> {
    /// The description that generated code makes.
    #[doc(hidden)]
    #[expect(clippy::too_many_arguments, reason = "one for each field, in their order")]
    #[must_use]
    pub const fn __new(
        name: &'d str,
        parameters: &'d [Quantity<'d>],
        inputs: &'d [Quantity<'d>],
        unknowns: &'d [Quantity<'d>],
        outputs: &'d [Quantity<'d>],
        equations: &'d [&'d str],
        blocks: &'d [Block<'d>],
        order: usize,
        operations: &'d [Operations],
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
            groups: &[],
        }
    }

    /// The same description with names of groups.
    #[doc(hidden)]
    #[must_use]
    pub const fn __with_groups(self, groups: &'d [&'d str]) -> Self {
        Self { groups, ..self }
    }

    /// The name at an index.
    pub(crate) fn name_of(&self, of: NameKind, index: usize) -> Option<&'d str> {
        let quantities = match of {
            NameKind::Parameter => self.parameters,
            NameKind::Input => self.inputs,
            NameKind::Unknown => self.unknowns,
            NameKind::Output => self.outputs,
            NameKind::Block => return self.blocks.get(index).map(|block| block.unknowns),
            NameKind::Group => return self.groups.get(index).copied(),
        };
        quantities.get(index).map(|quantity| quantity.name)
    }
}

/// A block: unknowns that are solved together.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Block<'d> {
    /// The names of the unknowns, separated by commas.
    pub unknowns: &'d str,
    /// The method of solution: the closed form, or Newton's method.
    pub solution: &'d str,
    /// The indices of these unknowns among the unknowns of the mechanism, in ascending order.
    pub members: &'d [usize],
    /// The indices of the scalar equations that determine them, in ascending order. There are as many equations as
    /// unknowns.
    pub equations: &'d [usize],
}

impl<'d> Block<'d> {
    /// The block that generated code makes.
    #[doc(hidden)]
    #[must_use]
    pub const fn __new(unknowns: &'d str, solution: &'d str, members: &'d [usize], equations: &'d [usize]) -> Self {
        Self {
            unknowns,
            solution,
            members,
            equations,
        }
    }
}
