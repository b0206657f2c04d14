//! The solver of a mechanism of any type, with its columns by index.

use std::fmt;

use kin_core::batch::{AnyBatch, AnyFold};

/// What the functions of SQL need of a mechanism.
pub(crate) trait Solver: AnyBatch + AnyFold + Send + Sync {}

impl<F: AnyBatch + AnyFold + Send + Sync> Solver for F {}

impl fmt::Debug for dyn Solver {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.description().name)
    }
}
