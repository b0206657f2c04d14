//! Summaries of many poses that are not stored: the least and the greatest value of a number and their poses, sums, and
//! the share of the poses that close.
//!
//! A batch is solved piece by piece into room that the folds bring along. Each piece is then summarised, while it is in
//! the first-level cache.

mod folded;
mod number;
mod poses;
mod reduce;
mod run;
#[cfg(test)]
mod tests;

pub use folded::Folded;
pub use number::{FoldError, FoldedNumber};
pub use poses::{InputGrid, Poses};
pub use reduce::Fold;
#[cfg(feature = "alloc")]
pub(super) use run::{Piece, check_numbers, entries, fold_pieces};
