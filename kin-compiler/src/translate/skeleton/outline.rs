//! The bodies, the ground and the slides of a declaration, and how their joints are calculated.

use proc_macro2::TokenStream;

use super::terms::LinkTerm;
use crate::model::ValueShape;

/// The drawn parts of a declaration.
pub(super) struct Outline<'a> {
    /// Whether it is drawn in the plane or in space.
    pub(super) shape: ValueShape,
    /// The joints, those that only lead to others among them.
    pub(super) joints: Vec<Joint<'a>>,
    /// The joints that are shown, by their places among the joints.
    pub(super) shown: Vec<usize>,
    /// Of the shown joints, like all that follow.
    pub(super) ground: Vec<usize>,
    pub(super) bodies: Vec<Body>,
    pub(super) slides: Vec<Slide>,
    pub(super) points: Vec<(String, usize)>,
}

/// The sum of the terms that lead to it.
pub(super) struct Joint<'a> {
    /// The joint before it, none for the first term.
    pub(super) before: Option<usize>,
    /// None for the origin.
    pub(super) term: Option<LinkTerm<'a>>,
}

pub(super) struct Body {
    pub(super) name: String,
    pub(super) joints: Vec<usize>,
}

pub(super) struct Slide {
    pub(super) joint: usize,
    /// The number of the body, `None` for the ground.
    pub(super) guide: Option<usize>,
    pub(super) direction: TokenStream,
}
