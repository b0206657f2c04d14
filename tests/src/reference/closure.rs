//! A mechanism's closure in series of many digits.

use kin_core::{Mechanism, Row};
use kin_precise::Number;

use super::series::Series;
use super::tape::{Place, with_count};

/// The data of a mechanism: the numbers themselves, whatever precision they come from.
#[derive(Clone, Debug)]
pub struct Given {
    /// Its parameters.
    pub parameters: Vec<f64>,
    /// Value and time derivatives of each input.
    pub inputs: Vec<Vec<f64>>,
}

/// Parameters, inputs and unknowns, as series.
#[derive(Clone)]
pub(super) struct Arguments {
    pub(super) parameters: Vec<Series>,
    pub(super) inputs: Vec<Series>,
    pub(super) unknowns: Vec<Series>,
}

impl Arguments {
    /// With unknowns of which the position is known to some digits.
    pub(super) fn new(given: &Given, position: &[f64]) -> Self {
        let constant = |value: &f64| Series::constant(Number::exactly(*value));
        Self {
            parameters: given.parameters.iter().map(constant).collect(),
            inputs: given
                .inputs
                .iter()
                .map(|motion| Series::from_derivatives(motion))
                .collect(),
            unknowns: position.iter().map(constant).collect(),
        }
    }
}

type Precise<M> = <M as Mechanism>::With<Place>;

/// The residual of each equation, to `count` coefficients.
pub(super) fn closure<M: Mechanism>(arguments: &Arguments, count: usize) -> Vec<Series> {
    with_count(count, || {
        let place = |series: &Series| Place::of(series.clone());
        let mechanism = Precise::<M>::from_parameters(Row::from_fn(|index| place(&arguments.parameters[index])));
        let inputs = Row::from_fn(|index| place(&arguments.inputs[index]));
        let unknowns = Row::from_fn(|index| place(&arguments.unknowns[index]));
        let left = mechanism.closure(inputs, unknowns);
        left.as_ref().iter().map(|left| left.series()).collect()
    })
}
