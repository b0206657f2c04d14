//! Oracle (b): truncated Taylor series put back into the closure.

use std::vec::Vec;

use super::functions::VerifiedFunctions as _;
use super::motions::flat;
use super::{Inputs, Unknowns};
use crate::any::Of;
use crate::mechanism::Mechanism;

/// The residuals of each scalar equation and of its derivatives, with the motions put into it. They are zero up to
/// rounding if the motions are right.
///
/// ```
/// use kin_core::library::FourBar;
/// use kin_core::prelude::*;
/// use kin_core::verify;
///
/// let linkage: FourBar = FourBar { r1: 90.0, r2: 30.0, r3: 60.0, r4: 45.0 };
/// let crank = Motion::from((1.1, -10.0, 2.0, -0.5, 0.3));
/// let pose = linkage.solve(crank, Assembly::Open)?;
/// let left = verify::closure(&linkage, &[crank], &[pose.theta3, pose.theta4]);
/// assert!(left.iter().all(|equation| equation[4].abs() < 1e-6));
/// # Ok::<(), SolveError>(())
/// ```
pub fn closure<M: Mechanism<Scalar = f64>>(mechanism: &M, inputs: &Inputs<M>, unknowns: &Unknowns<M>) -> Vec<Vec<f64>> {
    let parameters = mechanism.parameters();
    Of::<M>::FUNCTIONS.left_over(parameters.as_ref(), &flat(inputs.as_ref()), &flat(unknowns.as_ref()))
}
