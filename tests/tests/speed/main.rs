//! The cost of solving: operations, memory, growth with the order.

mod allocation;
mod growth;
mod nested_dual_numbers;
mod operation_counts;
