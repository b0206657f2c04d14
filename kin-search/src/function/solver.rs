//! The solver of a mechanism of any type, with its columns by index.

use std::fmt;

use kin_core::any::Described;
use kin_core::batch::{AnyBatch, AnyFold};

/// What the functions of SQL need of a mechanism.
pub(crate) trait Solver: AnyBatch + AnyFold + Send + Sync {}

impl<F: AnyBatch + AnyFold + Send + Sync> Solver for F {}

impl fmt::Debug for dyn Solver {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.description().name)
    }
}

/// The assemblies as text, such as `open` or `alpha=open,knee=crossed`. There are none if a position is chosen by values nearby, and one
/// without letters if there is no choice.
pub(crate) fn assemblies(mechanism: &(impl Described + ?Sized)) -> Vec<String> {
    let indices = 0..mechanism.assembly_count();
    indices.filter_map(|index| mechanism.assembly_name(index)).collect()
}
