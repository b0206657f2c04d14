//! The choice between two solutions.

use crate::algebra::Node;

/// How one of two solutions is chosen.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) enum Mode {
    /// There is but one.
    Only,
    /// By the block's assembly: the index of the caller's choice.
    Assembly(usize),
    /// By the range declared for an unknown, known when the declaration is compiled.
    Fixed { is_open: bool },
    /// By the ranges declared for unknowns, looked up when the candidates are there.
    Ranged,
}

/// A range declared for an unknown, as far as choosing needs it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Limits {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// The choice that a block leaves.
pub(crate) struct Choice {
    pub(crate) mode: Mode,
    /// Positive in the open assembly, as an expression of unknowns, inputs and parameters.
    pub(crate) orientation: Option<Node>,
}
