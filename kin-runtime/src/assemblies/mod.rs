//! All assemblies of a mechanism with coupled blocks.

#[doc(hidden)]
pub mod continuation;
mod every;
mod list;

pub use every::{Assemblies, Choices, every, every_in, is_same_position, positions_near};
pub use list::Positions;
