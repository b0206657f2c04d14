//! The cost of solving: operations, memory, growth with the order; and batches, which are faster and find the same poses.

mod allocation;
mod batches;
mod batches_at_dead_points;
mod batches_that_fail;
mod growth;
mod nested_dual_numbers;
mod operation_counts;
