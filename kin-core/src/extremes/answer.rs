//! What a question to a sweep may return for a pose.

use crate::load::LoadError;
use crate::motion::Motion;
use crate::sweep::Local;

/// A quantity of a pose: a number, a motion for its value, or the result of loads, which may have no balance there.
///
/// Do not implement it for other types: a new version may add items.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a quantity of a pose",
    note = "return a `Local`, as `|at| at.theta4.jerk()`, or a `Result<Local, LoadError>`, as `|at| at.effort(&loads, 0)`"
)]
pub trait Answer {
    /// The number, or the reason why there is none.
    ///
    /// # Errors
    /// The error of the loads.
    fn answer(self) -> Result<Local, LoadError>;
}

impl Answer for Local {
    fn answer(self) -> Result<Local, LoadError> {
        Ok(self)
    }
}

/// A motion answers by its value.
impl<const N: usize> Answer for Motion<Local, N> {
    fn answer(self) -> Result<Local, LoadError> {
        Ok(self.value())
    }
}

impl Answer for Result<Local, LoadError> {
    fn answer(self) -> Result<Local, LoadError> {
        self
    }
}
