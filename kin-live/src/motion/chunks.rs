//! Chunks of poses side by side, as batches solve them.

use kin_core::Scalar;
use kin_core::batch::Numbers;

use super::{FoundMotion, Motion, Value};
use crate::memory::{Lengths, Memory};
use crate::routine::Inputs;
use crate::run::{Choice, Fault, Run};

impl<T: Scalar, const C: usize> FoundMotion<'_, T, C> {
    /// Writes the motions as columns: a direction has its cosine instead of its angle, and its sine.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn write_columns(&self, numbers: &mut Numbers<T>) {
        let orders = self.motion.order + 1;
        let of_each = numbers.unknowns.chunks_exact_mut(orders).zip(&mut numbers.sines);
        for ((slots, sine), unknown) in of_each.zip(&self.motion.unknowns) {
            slots[0] = match (unknown.value, unknown.vector) {
                (_, Some([cosine, register])) => {
                    *sine = Some(self.at(register));
                    self.at(cosine)
                }
                (Value::Number(register) | Value::Direction { cosine: register, .. }, None) => self.at(register),
            };
            for (slot, register) in slots[1..].iter_mut().zip(&unknown.rates) {
                *slot = self.at(*register);
            }
        }
        self.write_outputs(&mut numbers.outputs);
        self.write_position(None, &mut numbers.positions);
    }
}

impl Motion {
    /// The memory that a run takes.
    pub(crate) fn lengths(&self) -> Lengths {
        self.code.lengths
    }

    /// Solves several chunks of poses side by side. The parameters, inputs and values nearby of a chunk stand behind
    /// those of the chunk before. Nothing is tested for being finite.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn solve_chunks<T: Scalar, const C: usize>(
        &self,
        memory: Memory<'_, T, C>,
        chunks: usize,
        parameters: &[T],
        inputs: Inputs<'_, T>,
        choice: Choice<'_, T>,
        mut found: impl FnMut(usize, FoundMotion<'_, T, C>),
    ) -> Result<(), Fault> {
        let (parameter_count, input_count) = (parameters.len() / chunks, inputs.motions.len() / chunks);
        for chunk in 0..chunks {
            let parameters = &parameters[chunk * parameter_count..(chunk + 1) * parameter_count];
            let motions = &inputs.motions[chunk * input_count..(chunk + 1) * input_count];
            let inputs = Inputs { motions, ..inputs };
            self.given.write(memory.registers, chunk, parameters, inputs);
        }
        let mut run = Run::single(&self.code, memory, choice);
        for order in 0..inputs.orders {
            run.routine(order, chunks)?;
        }
        for chunk in 0..chunks {
            let motion = FoundMotion {
                motion: self,
                registers: run.memory.registers,
                chunk,
            };
            found(chunk, motion);
        }
        Ok(())
    }
}
