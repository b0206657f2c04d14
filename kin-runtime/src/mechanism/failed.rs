//! Errors with the block and the inputs at which they occurred.

use crate::failure::{Failure, InputNames, InputValues, SolveError};
use crate::mechanism::{Description, Mechanism};
use crate::number::{Number, Row};
use crate::quantity::{Name, NameKind};
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
    let name = |kind, index: usize| match kind {
        NameKind::Parameter => description.parameters[index].name.into(),
        _ => description.inputs[index].name.into(),
    };
    failed_in(
        failure,
        block,
        name,
        parameters.iter().copied(),
        InputNames::Declared(description.inputs),
        inputs.iter().copied(),
    )
}

/// The error of a solver without its type, from the values of its parameters and inputs with their names. If one of
/// them is not finite, the failure names it.
#[cold]
pub fn failed_in(
    failure: Failure,
    block: impl Into<Name>,
    name: impl Fn(NameKind, usize) -> Name,
    mut parameters: impl Iterator<Item = f64>,
    input_names: InputNames,
    inputs: impl Iterator<Item = f64> + Clone,
) -> SolveError {
    let parameter = parameters.position(|value| !value.is_finite());
    let parameter = parameter.map(|index| name(NameKind::Parameter, index));
    let input = || inputs.clone().position(|value| !value.is_finite());
    let quantity = parameter.or_else(|| input().map(|index| name(NameKind::Input, index)));
    let failure = quantity.map_or(failure, Failure::not_finite);
    let (mut first, mut count) = ([0.0; InputValues::CAPACITY], 0);
    for (slot, input) in first.iter_mut().zip(inputs) {
        *slot = input;
        count += 1;
    }
    failure.at(block, InputValues::of(input_names, &first[..count]))
}

/// The error of the first result that is not finite. It names the first input that is not finite, or else the result.
#[cold]
#[inline(never)]
pub fn culprit<const RESULTS: usize, const INPUTS: usize>(
    results: [(&'static str, bool); RESULTS],
    inputs: [(&'static str, bool); INPUTS],
    failed: impl FnOnce(Failure, &'static str) -> SolveError,
) -> SolveError {
    let (failure, result) = culprit_in(results, inputs);
    failed(failure, result)
}

/// The failure of the first input that is not finite, or else of the first such result, and the name of that result.
pub fn culprit_in<N: Copy + Default + Into<Name>>(
    results: impl IntoIterator<Item = (N, bool)>,
    inputs: impl IntoIterator<Item = (N, bool)>,
) -> (Failure, N) {
    let is_bad = |(name, is_finite)| if is_finite { None } else { Some(name) };
    let result = results.into_iter().find_map(is_bad).unwrap_or_default();
    let quantity = inputs.into_iter().find_map(is_bad).unwrap_or(result);
    (Failure::not_finite(quantity), result)
}

#[cfg(test)]
mod tests {
    use super::{culprit_in, failed_in};
    use crate::failure::{Failure, InputNames};
    use crate::quantity::{Name, NameKind, Quantity};

    /// A parameter or an input that is not finite is named before everything else, and by its index where names are
    /// not known.
    #[test]
    fn what_is_not_finite_is_named_by_its_index() {
        let second = |kind| Name::by_index(kind, 1);
        let (first, block) = (Name::by_index(NameKind::Unknown, 0), second(NameKind::Block));
        let (failure, result) = culprit_in([(first, true), (second(NameKind::Unknown), false)], []);
        assert_eq!(failure, Failure::not_finite(second(NameKind::Unknown)));
        assert_eq!(result, second(NameKind::Unknown));
        let inputs = InputNames::by_index(&[Quantity::angle("", ""), Quantity::length("", "")]);
        let fails = |parameters: &[f64], values: &[f64]| {
            let (parameters, values) = (parameters.iter().copied(), values.iter().copied());
            failed_in(failure, block, Name::by_index, parameters, inputs, values)
        };
        let error = fails(&[1.0, 2.0], &[3.0, 4.0]);
        assert_eq!((error.failure, error.block), (failure, block));
        assert!(
            error
                .inputs
                .iter()
                .eq([(NameKind::Input, 0, 3.0), (NameKind::Input, 1, 4.0)]
                    .map(|(kind, index, value)| (Name::by_index(kind, index), value)))
        );
        let of_input = fails(&[1.0, 2.0], &[3.0, f64::NAN]);
        assert_eq!(of_input.failure, Failure::not_finite(second(NameKind::Input)));
        let of_parameter = fails(&[1.0, f64::INFINITY], &[3.0, f64::NAN]);
        assert_eq!(of_parameter.failure, Failure::not_finite(second(NameKind::Parameter)));
    }
}
