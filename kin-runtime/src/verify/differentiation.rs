//! Oracle (a): time derivatives by differentiating the position solution.

use std::vec::Vec;

use super::Inputs;
use super::functions::VerifiedFunctions as _;
use super::motions::flat;
use crate::any::{AssemblyChoice, Of};
use crate::failure::SolveError;
use crate::mechanism::Mechanism;

/// The result of differentiating the position solution.
#[derive(Clone, Debug, PartialEq)]
pub struct Differentiated {
    /// The value and derivatives of each unknown, up to the mechanism's order.
    pub unknowns: Vec<Vec<f64>>,
    /// The value and derivatives of each scalar output.
    pub outputs: Vec<Vec<f64>>,
}

/// The motions of unknowns and outputs by automatic differentiation of the position solution.
///
/// With the feature `num-dual`, the numbers are nested dual numbers for mechanisms up to the fourth order. Otherwise
/// they are truncated Taylor series, up to the sixteenth order.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
/// use kin_core::verify;
///
/// let linkage: FourBar = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let crank = Motion::from((1.1, -10.0, 2.0, -0.5, 0.3));
/// let pose = linkage.solve(crank, Assembly::Open)?;
/// let expected = verify::by_differentiation(&linkage, &[crank], Assembly::Open)?;
/// assert!((pose.theta4.snap() / expected.unknowns[1][4] - 1.0).abs() < 1e-12);
/// # Ok::<(), SolveError>(())
/// ```
///
/// # Errors
/// Returns the errors of the position solver.
pub fn by_differentiation<M: Mechanism<Scalar = f64>>(
    mechanism: &M,
    inputs: &Inputs<M>,
    assembly: M::Assembly,
) -> Result<Differentiated, SolveError> {
    let choice = AssemblyChoice::of::<M>(assembly);
    let parameters = mechanism.parameters();
    Of::<M>::FUNCTIONS.differentiated(parameters.as_ref(), &flat(inputs.as_ref()), choice.position())
}
