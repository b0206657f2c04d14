//! Questions about extremes to a sweep that does not say yet how its inputs move: see
//! [`sweep::guessed`](crate::sweep::guessed).

use super::{ByName, QuantityAlong};
use crate::mechanism::Mechanism;
use crate::sweep::guessed::Moves;
use crate::sweep::{Assembled, StraightLine, Sweep};

/// A method that nobody can call.
impl<M: Mechanism<Scalar = f64>> Assembled<M> {
    #[doc(hidden)]
    pub fn of<'q>(&self, _: &'q str) -> QuantityAlong<'_, Sweep<M, StraightLine>, ByName<'q>>
    where
        Self: Moves,
    {
        self.answer()
    }
}
