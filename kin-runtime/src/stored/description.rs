//! Descriptions of mechanisms that own their texts.

use std::string::String;
use std::vec::Vec;

use crate::mechanism::{Block, Description};
use crate::number::Operations;
use crate::quantity::{Dimension, Quantity};

/// A [`Description`] that owns its texts, so that a program can read it. It is written like the description.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename = "Description")]
#[non_exhaustive]
pub struct DescriptionRecord {
    /// The name of the structure.
    pub name: String,
    /// The scalar parameters; a point counts as its coordinates.
    pub parameters: Vec<QuantityRecord>,
    /// The inputs.
    pub inputs: Vec<QuantityRecord>,
    /// The unknowns.
    pub unknowns: Vec<QuantityRecord>,
    /// The scalar outputs; a point counts as its coordinates.
    pub outputs: Vec<QuantityRecord>,
    /// The equations as declared.
    pub equations: Vec<String>,
    /// The blocks in the order in which they are solved.
    pub blocks: Vec<BlockRecord>,
    /// The highest time derivative.
    pub order: usize,
    /// The cost of each order, position first, in the most expensive assembly.
    pub operations: Vec<Operations>,
}

/// A [`Quantity`] that owns its texts.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename = "Quantity")]
#[non_exhaustive]
pub struct QuantityRecord {
    /// The name of the quantity; the parts of a point `p` are `p.x`, `p.y` and, in space, `p.z`.
    pub name: String,
    /// The dimension of the quantity.
    pub dimension: Dimension,
    /// The first paragraph of its documentation, or an empty string.
    pub description: String,
}

/// A [`Block`] that owns its texts.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename = "Block")]
#[non_exhaustive]
pub struct BlockRecord {
    /// The names of the unknowns, separated by commas.
    pub unknowns: String,
    /// The method of solution: the closed form, or Newton's method.
    pub solution: String,
    /// The indices of these unknowns among the unknowns of the mechanism, in ascending order.
    pub members: Vec<usize>,
    /// The indices of the scalar equations that determine them, in ascending order.
    pub equations: Vec<usize>,
}

impl From<Description<'_>> for DescriptionRecord {
    fn from(description: Description<'_>) -> Self {
        let quantities = |quantities: &[Quantity<'_>]| quantities.iter().copied().map(QuantityRecord::from).collect();
        Self {
            name: description.name.into(),
            parameters: quantities(description.parameters),
            inputs: quantities(description.inputs),
            unknowns: quantities(description.unknowns),
            outputs: quantities(description.outputs),
            equations: description.equations.iter().copied().map(String::from).collect(),
            blocks: description.blocks.iter().copied().map(BlockRecord::from).collect(),
            order: description.order,
            operations: description.operations.to_vec(),
        }
    }
}

impl From<Quantity<'_>> for QuantityRecord {
    fn from(quantity: Quantity<'_>) -> Self {
        Self {
            name: quantity.name.into(),
            dimension: quantity.dimension,
            description: quantity.description.into(),
        }
    }
}

impl From<Block<'_>> for BlockRecord {
    fn from(block: Block<'_>) -> Self {
        Self {
            unknowns: block.unknowns.into(),
            solution: block.solution.into(),
            members: block.members.to_vec(),
            equations: block.equations.to_vec(),
        }
    }
}
