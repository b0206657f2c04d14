//! Motion from one position to another: tracking without leaving the assembly, and the paths of points; sweeps and
//! their extremes.

mod point_paths;
mod sweeps;
mod tracking;
mod tracking_coupled_blocks;
mod tracking_ends;
mod tracking_steps;
