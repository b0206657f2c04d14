//! The language: its declarations, their meaning, and the code that they become.

mod block_forms;
mod calls;
mod directions;
mod editor;
mod hygiene;
mod interface;
mod long_and_deep;
mod ranges;
mod reading;
mod recognition;
mod skeletons;
mod transmission_angles;
