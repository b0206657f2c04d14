//! Errors with the place where they occurred.

use crate::failure::{Failure, InputValues, SolveError};
use crate::mechanism::{Description, Mechanism};
use crate::number::{Number, Row};
use crate::solve::Scalar;

/// The error of a solver at the given inputs. If a parameter or an input is not finite, the failure names it.
///
/// Of several poses, nobody reads the error.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn failed<M: Mechanism>(
    mechanism: &M,
    failure: Failure,
    block: &'static str,
    inputs: M::Inputs<M::Scalar>,
) -> SolveError {
    // in a constant, so that the rest is not compiled for several poses
    if const { M::Scalar::DOUBT > 0.0 } {
        return failure.at(block, InputValues::NONE);
    }
    failed_alone(mechanism, failure, block, inputs)
}

#[cold]
#[inline(never)]
fn failed_alone<M: Mechanism>(
    mechanism: &M,
    failure: Failure,
    block: &'static str,
    inputs: M::Inputs<M::Scalar>,
) -> SolveError {
    let parameters = mechanism.parameters();
    let parameters = <M::Parameters<f64> as Row<f64>>::from_fn(|index| parameters[index].real());
    let inputs = <M::Inputs<f64> as Row<f64>>::from_fn(|index| inputs[index].real());
    placed(&M::DESCRIPTION, failure, block, parameters.as_ref(), inputs.as_ref())
}

/// Compiled once, in this crate.
#[cold]
#[inline(never)]
fn placed(
    description: &Description<'static>,
    failure: Failure,
    block: &'static str,
    parameters: &[f64],
    inputs: &[f64],
) -> SolveError {
    let quantities = description.parameters.iter().chain(description.inputs);
    let values = parameters.iter().chain(inputs);
    let failure = quantities
        .zip(values)
        .find(|(_, value)| !value.is_finite())
        .map_or(failure, |(quantity, _)| Failure::not_finite(quantity.name));
    failure.at(block, InputValues::new(description.inputs, inputs))
}

/// The error of the first result that is not finite. It names the first input that is not finite, or else the result.
#[cold]
#[inline(never)]
pub fn culprit<const RESULTS: usize, const INPUTS: usize>(
    results: [(&'static str, bool); RESULTS],
    inputs: [(&'static str, bool); INPUTS],
    failed: impl FnOnce(Failure, &'static str) -> SolveError,
) -> SolveError {
    let first = |quantities: &[(&'static str, bool)]| {
        let (name, _) = quantities.iter().find(|(_, is_finite)| !is_finite)?;
        Some(*name)
    };
    let result = first(&results).unwrap_or_default();
    let quantity = first(&inputs).unwrap_or(result);
    failed(Failure::not_finite(quantity), result)
}
