//! `Debug` of cycles, whose rows of values are arrays.

use core::fmt::{Debug, Formatter, Result};

use super::{Branch, Circuit, Cycle, End};
use crate::mechanism::Mechanism;

impl<M: Mechanism<Scalar = f64>> Debug for End<M> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        formatter
            .debug_struct("End")
            .field("kind", &self.kind)
            .field("input", &self.input)
            .field("unknowns", &self.unknowns.as_ref())
            .field("block", &self.block)
            .finish_non_exhaustive()
    }
}

impl<M: Mechanism<Scalar = f64>> Debug for Branch<M> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        formatter
            .debug_struct("Branch")
            .field("ends", &self.ends)
            .field("circuit", &self.circuit)
            .field("joins", &self.joins)
            .finish_non_exhaustive()
    }
}

impl<M: Mechanism<Scalar = f64>> Debug for Circuit<M> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        formatter
            .debug_struct("Circuit")
            .field("branches", &self.branches)
            .field("input_turns", &self.input_turns)
            .field("turns", &self.turns.as_ref().map(AsRef::as_ref))
            .finish()
    }
}

impl<M: Mechanism<Scalar = f64>> Debug for Cycle<M> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        formatter
            .debug_struct("Cycle")
            .field("mechanism", &self.mechanism)
            .field("branches", &self.branches)
            .field("circuits", &self.circuits)
            .field("incomplete", &self.incomplete)
            .finish_non_exhaustive()
    }
}
