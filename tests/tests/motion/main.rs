//! Motion from one position to another: tracking without leaving the assembly, and the paths of points.

mod point_paths;
mod tracking;
mod tracking_coupled_blocks;
mod tracking_ends;
mod tracking_steps;
