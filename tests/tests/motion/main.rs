//! Motion from one position to another: tracking without leaving the assembly, and the paths of points; full cycles;
//! sweeps and their extremes.

mod cycles;
mod point_paths;
mod sweeps;
mod tracking;
mod tracking_coupled_blocks;
mod tracking_steps;
