//! The choice between two solutions.

use crate::algebra::Node;

/// How one of two solutions is chosen.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Mode {
    /// There is only one solution.
    Only,
    /// The block's assembly decides: the index of the caller's choice.
    Assembly(usize),
    /// The range declared for an unknown decides, whatever the dimensions.
    Fixed { is_open: bool },
    /// The ranges declared for unknowns decide at run time, by the candidates.
    Ranged,
}

/// The range declared for an unknown, as far as the choice needs it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DeclaredRange {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// The choice that a part of a block leaves.
pub(crate) struct Choice {
    pub(crate) mode: Mode,
    /// An expression of unknowns, inputs and parameters that is positive in the open assembly.
    pub(crate) orientation: Option<Node>,
}
