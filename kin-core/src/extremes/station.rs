//! A pose of a sweep from which quantities are found as series.

use alloc::vec;
use alloc::vec::Vec;

use super::ExtremesError;
use super::margin::{DyadFunctions, Margins};
use crate::any::{NearOver, OutputsOver};
use crate::failure::SolveError;
use crate::mechanism::Description;
use crate::number::series::Series;
use crate::number::{Number, NumberRow};
use crate::quantity::{Dimension, Quantity};
use crate::solve::nearest_turn;
use crate::sweep::{Local, READ, TERMS, by_time, composed};

/// The terms from which the derivatives up to snap are read, each with its own series.
const UP_TO_SNAP: usize = SNAP + TERMS;
const SNAP: usize = 4;

/// A quantity called by its name needs positions only: over a series in the variable of the sweep, they have all its derivatives. So the
/// solvers of rates are compiled in long numbers only where a closure asks for a typed pose.
pub(super) trait NamedFunctions: SeriesFunctions<UP_TO_SNAP> + SeriesFunctions<READ> + DyadFunctions {}

impl<F: SeriesFunctions<UP_TO_SNAP> + SeriesFunctions<READ> + DyadFunctions> NamedFunctions for F {}

/// Positions over series.
pub(super) trait SeriesFunctions<const N: usize>: NearOver<Series<N>> + OutputsOver<Series<N>> {}

impl<const N: usize, F: NearOver<Series<N>> + OutputsOver<Series<N>>> SeriesFunctions<N> for F {}

/// A pose of a sweep with unwrapped angles, and the motion of the inputs there.
pub struct SweepStation {
    pub(super) description: &'static Description,
    pub(super) parameters: NumberRow,
    /// The inputs, each with its derivatives with respect to the variable.
    pub(super) inputs: Vec<f64>,
    /// The unknowns, with unwrapped angles.
    pub(super) unknowns: NumberRow,
    /// The outputs, with unwrapped angles.
    pub(super) outputs: NumberRow,
    /// The change of the variable for each unit of time.
    pub(super) rate: f64,
    /// The variable as a series in the parameter.
    pub(super) variable: Local,
}

/// A position in series of the variable: parameters, inputs, what the unknowns are near, and the unknowns, one after the other.
struct SeriesPosition<const N: usize> {
    numbers: Vec<Series<N>>,
    counts: [usize; 3],
}

impl<const N: usize> SeriesPosition<N> {
    fn parts(&mut self) -> [&mut [Series<N>]; 4] {
        let [parameters, inputs, unknowns] = self.counts;
        let (parameters, rest) = self.numbers.split_at_mut(parameters);
        let (inputs, rest) = rest.split_at_mut(inputs);
        let (near, unknowns) = rest.split_at_mut(unknowns);
        [parameters, inputs, near, unknowns]
    }

    fn unknowns(&self) -> &[Series<N>] {
        &self.numbers[self.numbers.len() - self.counts[2]..]
    }
}

impl SweepStation {
    /// The value of a quantity, which must be finite.
    pub(super) fn finite(&self, value: Local) -> Result<Local, ExtremesError> {
        if Number::is_finite(value) {
            Ok(value)
        } else {
            Err(ExtremesError::NotFinite {
                at: self.variable.real(),
            })
        }
    }

    /// A derivative of an input.
    pub(super) fn input(&self, index: usize, order: usize) -> Local {
        self.by_time(&self.inputs[index * READ..(index + 1) * READ], order)
    }

    /// A derivative of an unknown.
    pub(super) fn unknown(
        &self,
        functions: &dyn NamedFunctions,
        index: usize,
        order: usize,
    ) -> Result<Local, SolveError> {
        if order <= SNAP {
            let value = self.position::<UP_TO_SNAP>(functions)?.unknowns()[index];
            Ok(self.by_time(&value.derivatives(), order))
        } else {
            let value = self.position::<READ>(functions)?.unknowns()[index];
            Ok(self.by_time(&value.derivatives(), order))
        }
    }

    /// A derivative of an output.
    pub(super) fn output(
        &self,
        functions: &dyn NamedFunctions,
        index: usize,
        order: usize,
    ) -> Result<Local, SolveError> {
        if order <= SNAP {
            let value = self.output_series::<UP_TO_SNAP>(functions, index)?;
            Ok(self.by_time(&value.derivatives(), order))
        } else {
            let value = self.output_series::<READ>(functions, index)?;
            Ok(self.by_time(&value.derivatives(), order))
        }
    }

    /// The margins and the transmission angles of all dyads.
    pub(super) fn margins<'f>(&self, functions: &'f dyn NamedFunctions) -> Result<Margins<'f>, SolveError> {
        let position = self.position::<UP_TO_SNAP>(functions)?;
        Ok(Margins {
            functions,
            description: self.description,
            parameters: self.parameters.iter().copied().map(Local::constant).collect(),
            inputs: (0..self.description.inputs.len())
                .map(|input| self.input(input, 0))
                .collect(),
            unknowns: position
                .unknowns()
                .iter()
                .map(|unknown| self.by_time(&unknown.derivatives(), 0))
                .collect(),
        })
    }

    fn position<'s, const N: usize>(
        &'s self,
        functions: &dyn SeriesFunctions<N>,
    ) -> Result<SeriesPosition<N>, SolveError> {
        let inputs = self
            .inputs
            .chunks_exact(READ)
            .map(|motion| Series::from_derivatives(core::array::from_fn(|order| motion[order])));
        let constants = |values: &'s [f64]| values.iter().copied().map(Series::constant);
        let numbers = constants(&self.parameters)
            .chain(inputs)
            .chain(constants(&self.unknowns))
            .chain(constants(&self.unknowns));
        let mut position = SeriesPosition {
            numbers: numbers.collect(),
            counts: [
                self.parameters.len(),
                self.description.inputs.len(),
                self.unknowns.len(),
            ],
        };
        let [parameters, inputs, near, unknowns] = position.parts();
        functions.position_near(parameters, inputs, near, unknowns)?;
        for (index, unknown) in unknowns.iter_mut().enumerate() {
            *unknown = unwrapped(self.description.unknowns[index], *unknown, self.unknowns[index]);
        }
        Ok(position)
    }

    fn output_series<const N: usize>(
        &self,
        functions: &dyn SeriesFunctions<N>,
        index: usize,
    ) -> Result<Series<N>, SolveError> {
        let mut position = self.position(functions)?;
        let [parameters, inputs, _, unknowns] = position.parts();
        let mut outputs = vec![Series::constant(0.0); self.outputs.len()];
        functions.outputs(parameters, inputs, unknowns, &mut outputs);
        let quantity = self.description.outputs[index];
        Ok(unwrapped(quantity, outputs[index], self.outputs[index]))
    }

    /// A derivative with respect to time as a series in the parameter, from those with respect to the variable.
    pub(super) fn by_time(&self, derivatives: &[f64], order: usize) -> Local {
        composed(by_time(derivatives, order, self.rate), self.variable)
    }
}

/// A value on the turn nearest to another one, if it is an angle.
fn unwrapped<const N: usize>(quantity: Quantity, value: Series<N>, near: f64) -> Series<N> {
    match quantity.dimension {
        Dimension::Angle => nearest_turn(value, Series::constant(near)),
        _ => value,
    }
}
