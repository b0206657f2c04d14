//! What a question to a sweep may return for a pose.

use super::ExtremesError;
use crate::load::LoadError;
use crate::mechanism::JacobianError;
use crate::motion::Motion;
use crate::sweep::Local;

/// A quantity of a pose: a number, a motion for its value, or the result of loads, which may have no balance there, or
/// of a Jacobian.
///
/// Do not implement it for other types: a new version may add items.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a quantity of a pose",
    note = "return a `Local`, as `|at| at.theta4.jerk()`, or a `Result<Local, LoadError>`, as `|at| at.effort(&loads, \
            0)`"
)]
pub trait Answer {
    /// The number, or the reason why there is none at a point of the sweep.
    ///
    /// # Errors
    /// The error of the loads or of the Jacobian.
    fn answer(self, at: f64) -> Result<Local, ExtremesError>;
}

impl Answer for Local {
    fn answer(self, _: f64) -> Result<Local, ExtremesError> {
        Ok(self)
    }
}

/// A motion answers by its value.
impl<const N: usize> Answer for Motion<Local, N> {
    fn answer(self, _: f64) -> Result<Local, ExtremesError> {
        Ok(self.value())
    }
}

impl Answer for Result<Local, LoadError> {
    fn answer(self, at: f64) -> Result<Local, ExtremesError> {
        self.map_err(|error| ExtremesError::of_loads(at, error))
    }
}

impl Answer for Result<Local, JacobianError> {
    fn answer(self, at: f64) -> Result<Local, ExtremesError> {
        self.map_err(|error| ExtremesError::of_jacobian(at, error))
    }
}
