//! The picture of a declaration, and how its joints are calculated.

use super::terms::LinkTerm;
use crate::translate::tree::{Outline, Tree};

/// The drawn parts of a declaration, with what calculates them.
pub(super) struct Picture<'a> {
    pub(super) outline: Outline,
    /// The joints, those that only lead to others among them.
    pub(super) joints: Vec<Joint<'a>>,
    /// The joints of the outline, by their indices among the joints.
    pub(super) shown: Vec<usize>,
    /// The directions of the slides.
    pub(super) directions: Vec<Tree>,
}

/// The sum of the terms that lead to it.
pub(super) struct Joint<'a> {
    /// The joint before it, none for the first term.
    pub(super) before: Option<usize>,
    /// None for the origin.
    pub(super) term: Option<LinkTerm<'a>>,
}
