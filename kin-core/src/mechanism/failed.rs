//! Errors with the place where they occurred.

use crate::failure::{Failure, InputValues, SolveError};
use crate::mechanism::Mechanism;
use crate::number::Number;
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
    if M::Scalar::DOUBT > 0.0 {
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
    let quantities = M::DESCRIPTION.parameters.iter().map(|parameter| parameter.name);
    let quantities = quantities.chain(M::DESCRIPTION.inputs.iter().map(|input| input.name));
    let values = parameters.as_ref().iter().chain(inputs.as_ref());
    let failure = quantities
        .zip(values)
        .find(|(_, value)| !value.real().is_finite())
        .map_or(failure, |(quantity, _)| Failure::not_finite(quantity));
    let mut kept = [0.0; InputValues::CAPACITY];
    for (place, value) in kept.iter_mut().zip(inputs.as_ref()) {
        *place = value.real();
    }
    failure.at(block, InputValues::new(M::DESCRIPTION.inputs, &kept))
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
