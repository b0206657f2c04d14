//! What a search finds: pieces of branches, and the nodes at which they end.

use alloc::vec::Vec;

use crate::number::NumberRow;
use crate::quantity::Name;

/// An input at which branches end.
#[derive(Clone)]
pub(super) struct BranchNode {
    pub(super) kind: super::EndKind,
    pub(super) s: f64,
    pub(super) unknowns: NumberRow,
    pub(super) block: Name,
    /// Two numbers that distinguish what only looks the same: the assemblies that meet, if the search knows them.
    pub(super) assemblies: [usize; 2],
}

/// An end of a piece.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tip {
    /// The index of a node.
    Node(usize),
    /// The end of the range, where a closed range goes on.
    Seam,
}

/// A branch, or a part of one that ends at the seam of a closed range. The tips belong to the smallest and the largest
/// input.
#[derive(Clone)]
pub(super) struct BranchPiece {
    /// The index of the assembly, if the search knows it.
    pub(super) assembly: Option<usize>,
    pub(super) low: Tip,
    pub(super) high: Tip,
    /// Inputs and unknowns in ascending order, with angles unwrapped. The first and the last belong to the tips.
    pub(super) samples: Vec<(f64, NumberRow)>,
}

/// The outcome of a search.
#[derive(Clone)]
pub(super) struct FoundPieces {
    pub(super) nodes: Vec<BranchNode>,
    pub(super) pieces: Vec<BranchPiece>,
    /// The reasons why there may be other pieces.
    pub(super) incomplete: Vec<super::Incomplete>,
    /// Assemblies by their indices, and ranges in which it is not known whether they close.
    pub(super) undecided: Vec<(usize, [f64; 2])>,
    /// The inputs at which all positions were sought, if a block has no closed form.
    pub(super) seeds: Vec<f64>,
}
