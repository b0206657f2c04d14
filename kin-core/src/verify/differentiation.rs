//! Oracle (a): time derivatives by differentiating the position solution.

use std::vec::Vec;

use super::Inputs;
use super::carrier::{Carrier, ThroughSnap};
use crate::failure::SolveError;
use crate::mechanism::{Mechanism, Pose};
use crate::number::{Row, series::Series};

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
/// With the feature `num-dual`, the numbers are nested dual numbers for mechanisms up to the fourth order. Otherwise they
/// are truncated Taylor series, up to the sixteenth order.
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
    // Constant conditions, so that only one of the solvers is compiled.
    if const { M::DESCRIPTION.order <= 4 } {
        carried::<M, ThroughSnap>(mechanism, inputs, assembly)
    } else if const { M::DESCRIPTION.order <= 8 } {
        carried::<M, Series<9>>(mechanism, inputs, assembly)
    } else {
        const { assert!(M::DESCRIPTION.order <= 16, "verification goes to the 16th derivative") };
        carried::<M, Series<17>>(mechanism, inputs, assembly)
    }
}

fn carried<M: Mechanism<Scalar = f64>, C: Carrier>(
    mechanism: &M,
    inputs: &Inputs<M>,
    assembly: M::Assembly,
) -> Result<Differentiated, SolveError> {
    let lifted = mechanism.convert(C::constant);
    let input = |index: usize| {
        let motion: &M::Motion<f64> = &inputs[index];
        C::carrying(motion.as_ref())
    };
    let through = |value: &C| value.derivatives_through(M::DESCRIPTION.order);
    if const { M::DESCRIPTION.outputs.is_empty() } {
        let at = <<M::With<C> as Mechanism>::Inputs<C> as Row<C>>::from_fn(input);
        let unknowns = lifted.position(at, assembly)?;
        return Ok(Differentiated {
            unknowns: unknowns.as_ref().iter().map(through).collect(),
            outputs: Vec::new(),
        });
    }
    // Only a pose contains outputs. Of its motions, only the values are used.
    let zero = C::constant(0.0);
    let still = <<M::With<C> as Mechanism>::Inputs<M::Motion<C>> as Row<M::Motion<C>>>::from_fn(|index| {
        <M::Motion<C> as Row<C>>::from_fn(|order| if order == 0 { input(index) } else { zero })
    });
    let pose = lifted.solve(still, assembly)?;
    let values = |motions: &[M::Motion<C>]| -> Vec<Vec<f64>> {
        motions
            .iter()
            .filter_map(|motion| motion.as_ref().first())
            .map(through)
            .collect()
    };
    Ok(Differentiated {
        unknowns: values(pose.unknown_motions().as_ref()),
        outputs: values(pose.output_motions().as_ref()),
    })
}
