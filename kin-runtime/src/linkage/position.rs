//! Positions of a linkage without its type.

use alloc::vec;
use alloc::vec::Vec;
use core::fmt;

use crate::any::{
    AnyMechanism, AssemblyChoice, ClosureOver, EveryPosition, FormsOver, Of, OutputsOver, PositionChoice,
    TransmissionOver,
};
use crate::cycle::{MeasuredFunctions, SearchedFunctions};
use crate::extremes::ChangedFunctions;
use crate::failure::{InputValues, SolveError};
use crate::mechanism::condition::{At, Changed, ConditionMemory, conditions_over};
use crate::mechanism::{BlockForm, Description, First, Mechanism, PositionSearch};
use crate::number::NumberRow;
use crate::picture::TransmissionAngle;
use crate::solve::lent_factors_length;
use crate::sweep::SweptMechanism;
use crate::track::{TrackError, track_between};

/// The functions of a mechanism from which its answers are found: [`Of::<M>::FUNCTIONS`](Of::FUNCTIONS) has them for
/// every declared mechanism.
pub trait LinkageFunctions:
    Send
    + Sync
    + fmt::Debug
    + AnyMechanism
    + SweptMechanism
    + ChangedFunctions
    + SearchedFunctions
    + MeasuredFunctions
    + EveryPosition
    + FormsOver<f64>
{
}

impl<M: Mechanism<Scalar = f64>> LinkageFunctions for Of<M> {}

/// A mechanism with its dimensions, without its type.
///
/// All slices have the lengths that the [`Description`] tells. A shorter slice is an error of the program, which
/// panics.
#[derive(Clone)]
pub struct AnyLinkage<'m> {
    pub(super) functions: &'m dyn LinkageFunctions,
    pub(super) parameters: NumberRow,
}

impl fmt::Debug for AnyLinkage<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct(self.description().name)
            .field("parameters", &self.parameters())
            .finish_non_exhaustive()
    }
}

impl<'m> AnyLinkage<'m> {
    /// A declared mechanism.
    pub fn of<M: Mechanism<Scalar = f64>>(mechanism: &M) -> Self {
        Self::new(Of::<M>::FUNCTIONS, mechanism.parameters().as_ref())
    }

    /// A mechanism by its functions, with scalar parameters in the order of the declaration.
    #[must_use]
    pub fn new(functions: &'m dyn LinkageFunctions, parameters: &[f64]) -> Self {
        Self {
            functions,
            parameters: parameters.into(),
        }
    }

    /// The names, dimensions and equations.
    #[must_use]
    pub fn description(&self) -> &'m Description<'m> {
        self.functions.description()
    }

    /// The scalar parameters.
    #[must_use]
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// Values of the inputs, as errors hold them.
    #[must_use]
    pub fn input_values(&self, inputs: &[f64]) -> InputValues {
        InputValues::of(self.functions.input_names(), inputs)
    }

    /// The number of assemblies, or zero if it depends on the dimensions.
    #[must_use]
    pub fn assembly_count(&self) -> usize {
        self.functions.assembly_count()
    }

    /// The number of dyads.
    #[must_use]
    pub fn dyad_count(&self) -> usize {
        self.functions.dyad_count()
    }

    /// The unknowns of a position.
    ///
    /// # Errors
    /// Those of [`Mechanism::position`] and [`Mechanism::position_near`].
    pub fn position(&self, inputs: &[f64], choice: PositionChoice<'_, f64>) -> Result<Vec<f64>, SolveError> {
        let mut unknowns = vec![0.0; self.description().unknowns.len()];
        self.functions
            .position(&self.parameters, inputs, choice, &mut unknowns)?;
        Ok(unknowns)
    }

    /// The unknowns of every regular position, and whether there may be others.
    ///
    /// # Errors
    /// Those of [`Mechanism::positions_at`].
    pub fn positions_at(&self, inputs: &[f64]) -> Result<(Vec<Vec<f64>>, PositionSearch), SolveError> {
        let mut found = Vec::new();
        let search = self
            .functions
            .every_position(&self.parameters, inputs, &mut |unknowns| found.push(unknowns.to_vec()))?;
        Ok((found, search))
    }

    /// The assembly to which a position belongs.
    #[must_use]
    pub fn assembly_at(&self, inputs: &[f64], unknowns: &[f64]) -> AssemblyChoice {
        let index = self.functions.assembly_at(&self.parameters, inputs, unknowns);
        index.map_or_else(|| AssemblyChoice::Near(unknowns.to_vec()), AssemblyChoice::Index)
    }

    /// The scalar outputs in a position.
    #[must_use]
    pub fn outputs(&self, inputs: &[f64], unknowns: &[f64]) -> Vec<f64> {
        let mut outputs = vec![0.0; self.description().outputs.len()];
        let functions: &dyn OutputsOver<f64> = self.functions;
        functions.outputs(&self.parameters, inputs, unknowns, &mut outputs);
        outputs
    }

    /// The transmission angle of every dyad in a position.
    #[must_use]
    pub fn transmission_angles(&self, inputs: &[f64], unknowns: &[f64]) -> Vec<TransmissionAngle> {
        let mut angles = vec![TransmissionAngle::of("", 0.0, 1.0); self.dyad_count()];
        let functions: &dyn TransmissionOver<f64> = self.functions;
        functions.angles_of_dyads(&self.parameters, inputs, unknowns, &mut angles);
        angles
    }

    /// The condition of each unknown at a position: see [`conditions`](crate::Mechanism::conditions).
    #[must_use]
    pub fn conditions(&self, inputs: &[f64], unknowns: &[f64]) -> Vec<f64> {
        let functions: &dyn ClosureOver<First> = self.functions;
        let at = At {
            parameters: &self.parameters,
            inputs,
            unknowns,
        };
        let mut residuals = vec![First::ZERO; unknowns.len()];
        let mut response = |changed: Changed, by: f64, response: &mut [f64]| {
            let series = |values: &[f64], quantity: fn(usize) -> Changed| {
                let values = values.iter().enumerate();
                let series = values.map(|(index, value)| changed.series(quantity(index), *value, by));
                series.collect::<Vec<First>>()
            };
            let parameters = series(at.parameters, Changed::Parameter);
            let inputs = series(at.inputs, Changed::Input);
            functions.closure(
                &parameters,
                &inputs,
                &series(at.unknowns, Changed::Unknown),
                &mut residuals,
            );
            for (response, residual) in response.iter_mut().zip(&residuals) {
                *response = residual.coefficients()[1];
            }
        };
        let mut conditions = vec![0.0; unknowns.len()];
        let [mut first, mut second, mut third] = [0; 3].map(|_| conditions.clone());
        let memory = ConditionMemory {
            rows: [&mut first, &mut second, &mut third],
            factors: &mut vec![0.0; lent_factors_length(unknowns.len())],
        };
        conditions_over(self.description(), at, &mut response, memory, &mut conditions);
        conditions
    }

    /// The form of each block.
    #[must_use]
    pub fn block_forms(&self) -> Vec<BlockForm<f64>> {
        let mut forms = Vec::new();
        let functions: &dyn FormsOver<f64> = self.functions;
        functions.block_forms(&self.parameters, &mut |form| forms.push(form));
        forms
    }

    /// The unknowns to which the mechanism moves as its inputs go along a straight line: see [`track`](crate::track()).
    ///
    /// # Errors
    /// As for `track`.
    pub fn track(
        &self,
        from: &[f64],
        unknowns: &[f64],
        to: &[f64],
    ) -> Result<Vec<f64>, TrackError<Vec<f64>, Vec<f64>>> {
        track_between(self.functions, &self.parameters, from, unknowns, to)
    }
}
