//! The description of a mechanism.

use crate::number::Operations;
use crate::quantity::Quantity;

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
