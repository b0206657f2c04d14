//! Oracle (b): truncated Taylor series put back into the closure.

use std::vec::Vec;

use super::carrier::Carrier;
use super::{Inputs, Unknowns};
use crate::mechanism::Mechanism;
use crate::number::{Row, series::Series};

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
    // Constant conditions, so that only one of the closures is compiled.
    if const { M::DESCRIPTION.order <= 4 } {
        carried::<M, Series<5>>(mechanism, inputs, unknowns)
    } else if const { M::DESCRIPTION.order <= 8 } {
        carried::<M, Series<9>>(mechanism, inputs, unknowns)
    } else {
        const { assert!(M::DESCRIPTION.order <= 16, "verification goes to the 16th derivative") };
        carried::<M, Series<17>>(mechanism, inputs, unknowns)
    }
}

fn carried<M: Mechanism<Scalar = f64>, C: Carrier>(
    mechanism: &M,
    inputs: &Inputs<M>,
    unknowns: &Unknowns<M>,
) -> Vec<Vec<f64>> {
    let carrying = |motion: &M::Motion<f64>| C::carrying(motion.as_ref());
    let inputs = <<M::With<C> as Mechanism>::Inputs<C> as Row<C>>::from_fn(|index| carrying(&inputs[index]));
    let unknowns = <<M::With<C> as Mechanism>::Unknowns<C> as Row<C>>::from_fn(|index| carrying(&unknowns[index]));
    mechanism
        .convert(C::constant)
        .closure(inputs, unknowns)
        .as_ref()
        .iter()
        .map(|left| left.derivatives_through(M::DESCRIPTION.order))
        .collect()
}
