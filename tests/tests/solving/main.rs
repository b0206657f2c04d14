//! Positions and their derivatives where they are known beforehand or hard to find, inputs that are refused, and the
//! same in batches.

mod batches;
mod batches_at_dead_points;
mod batches_that_fail;
mod block_after_block;
mod condition_numbers;
mod coupled_blocks;
mod folded_links;
mod hyperbolic;
mod kinds_of_drive;
mod known_motions;
mod not_finite;
mod platforms;
mod prepared;
mod scalar_equations;
mod singular_and_extreme;
mod space;
mod units;
