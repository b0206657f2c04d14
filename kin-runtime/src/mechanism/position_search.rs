//! The outcome of a search for all positions.

use crate::failure::{Failure, SolveError};
use crate::mechanism::Mechanism;

/// The outcome of [`Mechanism::positions_at`](crate::Mechanism::positions_at), a search for all regular positions at
/// given inputs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct PositionSearch {
    /// The number of positions found.
    pub found: usize,
    /// The number of singular positions found: limit positions and dead points. They are not passed on.
    pub singular: usize,
    /// Whether there is no other regular position. It is false if a path to a position was lost, if a declared range
    /// holds both solutions, and if there is no search for this mechanism: its coupled equations are not algebraic, or
    /// have too many solutions.
    pub is_complete: bool,
}

/// Tries every assembly, and passes on those in which the mechanism closes.
pub(super) fn by_assembly<M: Mechanism>(
    mechanism: &M,
    inputs: M::Inputs<M::Scalar>,
    mut found: impl FnMut(M::Assembly, M::Unknowns<M::Scalar>),
) -> Result<PositionSearch, SolveError> {
    let mut search = PositionSearch {
        is_complete: M::ASSEMBLY_COUNT > 0,
        ..PositionSearch::default()
    };
    for assembly in M::assemblies() {
        match mechanism.position(inputs, assembly) {
            Ok(unknowns) => {
                search.found += 1;
                found(assembly, unknowns);
            }
            Err(error) => match error.failure {
                Failure::NotFinite { .. } => return Err(error),
                Failure::Singular { .. } => search.singular += 1,
                // a position exists, but the range does not choose it
                Failure::Ambiguous { .. } => search.is_complete = false,
                _ => {}
            },
        }
    }
    Ok(search)
}
