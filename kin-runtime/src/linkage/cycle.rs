//! The cycle of a linkage without its type.

use alloc::vec::Vec;
use core::fmt;
use core::ops::Deref;

use super::{AnyLinkage, LinkageFunctions};
use crate::cycle::{CircuitAlong, CycleData, MeasuredCycle, SearchedCycle};
use crate::failure::SolveError;

/// All circuits and branches of a linkage. [`AnyLinkage::cycle_along`] makes it.
///
/// It has all methods of [`CycleData`].
#[derive(Clone)]
pub struct AnyCycle<'m> {
    functions: &'m dyn LinkageFunctions,
    searched: SearchedCycle<'m>,
}

impl Deref for AnyCycle<'_> {
    type Target = CycleData;

    fn deref(&self) -> &CycleData {
        &self.searched.data
    }
}

impl fmt::Debug for AnyCycle<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.searched.fmt(formatter)
    }
}

impl<'m> AnyLinkage<'m> {
    /// All circuits and branches along a line in the space of the inputs: see
    /// [`FullCycle::cycle_along`](crate::cycle::FullCycle::cycle_along).
    ///
    /// # Errors
    /// As there.
    pub fn cycle_along(&self, from: &[f64], direction: &[f64]) -> Result<AnyCycle<'m>, SolveError> {
        Ok(AnyCycle {
            functions: self.functions,
            searched: SearchedCycle::new(self.functions, &self.parameters, [from, direction], None)?,
        })
    }

    /// All circuits and branches on the straight line between two points in the space of the inputs: see
    /// [`FullCycle::cycle_between`](crate::cycle::FullCycle::cycle_between).
    ///
    /// # Errors
    /// As there.
    pub fn cycle_between(&self, from: &[f64], to: &[f64]) -> Result<AnyCycle<'m>, SolveError> {
        Ok(AnyCycle {
            functions: self.functions,
            searched: SearchedCycle::between(self.functions, &self.parameters, [from, to])?,
        })
    }
}

impl AnyCycle<'_> {
    /// The unknowns of a branch at an input of its range: see [`Cycle::position_on`](crate::cycle::Cycle::position_on).
    ///
    /// # Errors
    /// As there.
    pub fn position_on(&self, branch: usize, input: f64) -> Result<Vec<f64>, SolveError> {
        self.searched.position_on(branch, input).map(|found| found.to_vec())
    }

    /// A circuit by its index: see [`Cycle::along`](crate::cycle::Cycle::along).
    #[must_use]
    pub fn along(&self, circuit: usize) -> CircuitAlong<'_, Self> {
        let cycle = MeasuredCycle {
            cycle: &self.searched,
            functions: self.functions,
        };
        CircuitAlong::new(cycle, circuit)
    }
}
