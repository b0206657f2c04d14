//! What both oracles need of a mechanism, without its type.

use std::vec;
use std::vec::Vec;

use super::Differentiated;
use super::carrier::{Carrier, ThroughSnap};
use super::divisors::Divided;
use super::rounded::Rounded;
use crate::any::{
    AnyMechanism, AssemblyMotionOver, AssemblyOver, ClosureOver, Described, MotionNearOver, MotionOver, NearOver, Of,
    PositionChoice,
};
use crate::failure::SolveError;
use crate::mechanism::Mechanism;
use crate::number::Changing;
use crate::number::series::Series;

/// The functions of a mechanism from which both oracles judge it. Motions stand one after the other, each with all its
/// orders.
pub trait VerifiedFunctions:
    AnyMechanism
    + MotionOver<f64>
    + ClosureOver<Changing<f64>>
    + ClosureOver<Changing<Series<5>>>
    + ClosureOver<Divided>
    + ClosureOver<Rounded>
{
    /// The residuals of each scalar equation and of its derivatives.
    fn left_over(&self, parameters: &[f64], inputs: &[f64], unknowns: &[f64]) -> Vec<Vec<f64>>;

    /// The motions of unknowns and outputs by differentiation of the position solution.
    ///
    /// # Errors
    /// Those of the position solver.
    fn differentiated(
        &self,
        parameters: &[f64],
        inputs: &[f64],
        choice: PositionChoice<'_, f64>,
    ) -> Result<Differentiated, SolveError>;
}

impl<M: Mechanism<Scalar = f64>> VerifiedFunctions for Of<M> {
    fn left_over(&self, parameters: &[f64], inputs: &[f64], unknowns: &[f64]) -> Vec<Vec<f64>> {
        // Constant conditions, so that only one of the closures is compiled.
        if const { M::DESCRIPTION.order <= 4 } {
            left_over::<Series<5>>(self, parameters, inputs, unknowns)
        } else if const { M::DESCRIPTION.order <= 8 } {
            left_over::<Series<9>>(self, parameters, inputs, unknowns)
        } else {
            const { assert!(M::DESCRIPTION.order <= 16, "verification goes to the 16th derivative") };
            left_over::<Series<17>>(self, parameters, inputs, unknowns)
        }
    }

    fn differentiated(
        &self,
        parameters: &[f64],
        inputs: &[f64],
        choice: PositionChoice<'_, f64>,
    ) -> Result<Differentiated, SolveError> {
        // Constant conditions, so that only one of the solvers is compiled.
        if const { M::DESCRIPTION.order <= 4 } {
            of_type::<M, ThroughSnap>(parameters, inputs, choice)
        } else if const { M::DESCRIPTION.order <= 8 } {
            of_type::<M, Series<9>>(parameters, inputs, choice)
        } else {
            const { assert!(M::DESCRIPTION.order <= 16, "verification goes to the 16th derivative") };
            of_type::<M, Series<17>>(parameters, inputs, choice)
        }
    }
}

/// Differentiates in the way in which the mechanism is solved, which alone is compiled.
fn of_type<M: Mechanism, C: Carrier>(
    parameters: &[f64],
    inputs: &[f64],
    choice: PositionChoice<'_, f64>,
) -> Result<Differentiated, SolveError> {
    let declared = Of::<M>::FUNCTIONS;
    match choice {
        PositionChoice::Assembly(index) if const { M::ASSEMBLY_COUNT > 0 } => {
            if const { M::DESCRIPTION.outputs.is_empty() } {
                by_position::<C>(declared, parameters, inputs, |parameters, inputs, unknowns| {
                    declared.position_of_assembly(parameters, inputs, index, unknowns)
                })
            } else {
                by_motion::<C>(declared, parameters, inputs, |parameters, inputs, unknowns, outputs| {
                    declared.motion_of_assembly(parameters, inputs, index, unknowns, outputs)
                })
            }
        }
        PositionChoice::Near(near) => {
            let near: Vec<C> = near.iter().map(|value| C::constant(*value)).collect();
            if const { M::DESCRIPTION.outputs.is_empty() } {
                by_position::<C>(declared, parameters, inputs, |parameters, inputs, unknowns| {
                    declared.position_near(parameters, inputs, &near, unknowns)
                })
            } else {
                by_motion::<C>(declared, parameters, inputs, |parameters, inputs, unknowns, outputs| {
                    declared.motion_near(parameters, inputs, &near, unknowns, outputs)
                })
            }
        }
        PositionChoice::Assembly(_) => unreachable!("a coupled mechanism has no assemblies by index"),
    }
}

/// [`VerifiedFunctions::left_over`] in numbers that carry all orders.
pub fn left_over<C: Carrier>(
    functions: &(impl Described + ClosureOver<C>),
    parameters: &[f64],
    inputs: &[f64],
    unknowns: &[f64],
) -> Vec<Vec<f64>> {
    let description = functions.description();
    let mut residuals = vec![C::constant(0.0); description.unknowns.len()];
    let [inputs, unknowns] = [inputs, unknowns].map(|motions| carried::<C>(motions, description.order + 1));
    functions.closure(&constants::<C>(parameters), &inputs, &unknowns, &mut residuals);
    let all = residuals.iter();
    all.map(|left| left.derivatives_through(description.order)).collect()
}

/// [`VerifiedFunctions::differentiated`] in numbers that carry all orders, for a mechanism that chooses in both ways.
///
/// # Errors
/// As there.
pub fn differentiated<C: Carrier>(
    functions: &(impl Described + MotionOver<C>),
    parameters: &[f64],
    inputs: &[f64],
    choice: PositionChoice<'_, f64>,
) -> Result<Differentiated, SolveError> {
    let near: Vec<C> = match choice {
        PositionChoice::Assembly(_) => Vec::new(),
        PositionChoice::Near(near) => near.iter().map(|value| C::constant(*value)).collect(),
    };
    let choice = match choice {
        PositionChoice::Assembly(index) => PositionChoice::Assembly(index),
        PositionChoice::Near(_) => PositionChoice::Near(&near),
    };
    by_motion::<C>(
        functions,
        parameters,
        inputs,
        |parameters, inputs, unknowns, outputs| functions.motion(parameters, inputs, choice, unknowns, outputs),
    )
}

fn by_position<C: Carrier>(
    functions: &impl Described,
    parameters: &[f64],
    inputs: &[f64],
    position: impl FnOnce(&[C], &[C], &mut [C]) -> Result<(), SolveError>,
) -> Result<Differentiated, SolveError> {
    let description = functions.description();
    let mut unknowns = vec![C::constant(0.0); description.unknowns.len()];
    let inputs = carried::<C>(inputs, description.order + 1);
    position(&constants::<C>(parameters), &inputs, &mut unknowns)?;
    let through = |value: &C| value.derivatives_through(description.order);
    Ok(Differentiated {
        unknowns: unknowns.iter().map(through).collect(),
        outputs: Vec::new(),
    })
}

/// Only a pose contains outputs. Of its motions, only the values are used.
fn by_motion<C: Carrier>(
    functions: &impl Described,
    parameters: &[f64],
    inputs: &[f64],
    motion: impl FnOnce(&[C], &[C], &mut [C], &mut [C]) -> Result<(), SolveError>,
) -> Result<Differentiated, SolveError> {
    let description = functions.description();
    let (orders, zero) = (description.order + 1, C::constant(0.0));
    let [mut unknowns, mut outputs] =
        [description.unknowns, description.outputs].map(|all| vec![zero; all.len() * orders]);
    let mut still = vec![zero; inputs.len()];
    for (motion, value) in still.chunks_exact_mut(orders).zip(carried::<C>(inputs, orders)) {
        motion[0] = value;
    }
    motion(&constants::<C>(parameters), &still, &mut unknowns, &mut outputs)?;
    let values = |motions: &[C]| -> Vec<Vec<f64>> {
        let values = motions.iter().step_by(orders);
        values
            .map(|value| value.derivatives_through(description.order))
            .collect()
    };
    Ok(Differentiated {
        unknowns: values(&unknowns),
        outputs: values(&outputs),
    })
}

fn constants<C: Carrier>(values: &[f64]) -> Vec<C> {
    values.iter().map(|value| C::constant(*value)).collect()
}

/// Each motion in a number.
fn carried<C: Carrier>(motions: &[f64], orders: usize) -> Vec<C> {
    motions.chunks_exact(orders).map(C::carrying).collect()
}
