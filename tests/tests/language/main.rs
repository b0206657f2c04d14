//! What can be declared, what a declaration means, and what it turns into.

mod directions;
mod hygiene;
mod interface;
mod long_and_deep;
mod ranges;
mod recognition;
mod skeletons;
mod transmission_angles;
