//! The mechanism of a search, without its type.

use alloc::vec;
use alloc::vec::Vec;

use super::curved::Curved;
use super::line::wrapped;
use super::search::SearchMethod;
use crate::any::{AssemblyOver, ClosureOver, ClosureTermsOver, EveryPosition, Of, PositionChoice, TransmissionOver};
use crate::bounds::Bounds;
use crate::curve::CurveFunctions;
use crate::failure::SolveError;
use crate::mechanism::{Block, Description, Mechanism};
use crate::number::NumberRow;
use crate::quantity::{Dimension, Name, NameKind, Quantity};
use crate::track::{TrackError, track_between};

/// What every search needs of a mechanism.
#[expect(
    private_bounds,
    reason = "messages would list a public number among those that a user may take"
)]
pub trait CycleFunctions: Send + Sync + CurveFunctions + ClosureOver<Bounds> {}

impl<F: Send + Sync + CurveFunctions + ClosureOver<Bounds>> CycleFunctions for F {}

/// What the search needs where every block has a closed form.
#[expect(
    private_bounds,
    reason = "messages would list a public number among those that a user may take"
)]
pub trait ClosedForms: CycleFunctions + AssemblyOver<Bounds> + AssemblyOver<Curved> + TransmissionOver<f64> {}

impl<F: CycleFunctions + AssemblyOver<Bounds> + AssemblyOver<Curved> + TransmissionOver<f64>> ClosedForms for F {}

/// What the search needs where a block is coupled.
pub trait CoupledBlocks: EveryPosition + ClosureTermsOver<f64> {}

impl<F: EveryPosition + ClosureTermsOver<f64>> CoupledBlocks for F {}

/// A mechanism whose cycle can be searched.
pub trait SearchedFunctions: CycleFunctions {
    /// The functions of the search: there are other ones for closed forms and for coupled blocks.
    fn method(&self) -> SearchMethod<'_>;
}

impl<M: Mechanism<Scalar = f64>> SearchedFunctions for Of<M> {
    fn method(&self) -> SearchMethod<'_> {
        // in a constant, so that only one of both is compiled
        if const { M::ASSEMBLY_COUNT > 0 } {
            SearchMethod::Closed(self)
        } else {
            SearchMethod::Coupled(self)
        }
    }
}

/// A mechanism with its dimensions.
#[derive(Clone)]
pub(super) struct SoughtMechanism<'f> {
    pub(super) functions: &'f dyn CycleFunctions,
    pub(super) parameters: NumberRow,
}

impl<'f> SoughtMechanism<'f> {
    pub(super) fn description(&self) -> &'f Description<'f> {
        self.functions.description()
    }

    pub(super) fn inputs(&self) -> &'f [Quantity<'f>] {
        self.description().inputs
    }

    pub(super) fn unknowns(&self) -> &'f [Quantity<'f>] {
        self.description().unknowns
    }

    pub(super) fn blocks(&self) -> &'f [Block<'f>] {
        self.description().blocks
    }

    /// The name of a block in errors.
    pub(super) fn block_name(&self, block: usize) -> Name {
        self.functions.name(NameKind::Block, block)
    }

    /// The name in errors of the block of an unknown.
    pub(super) fn block_of(&self, unknown: usize) -> Name {
        let mut blocks = self.blocks().iter();
        let block = blocks.position(|block| block.members.contains(&unknown));
        block.map_or(Name::NONE, |block| self.block_name(block))
    }

    /// The indices of all assemblies.
    pub(super) fn assemblies(&self) -> core::ops::Range<usize> {
        0..self.functions.assembly_count()
    }

    pub(super) fn assembly_at(&self, inputs: &[f64], unknowns: &[f64]) -> Option<usize> {
        self.functions.assembly_at(&self.parameters, inputs, unknowns)
    }

    pub(super) fn position(&self, inputs: &[f64], choice: PositionChoice<'_, f64>) -> Result<NumberRow, SolveError> {
        let mut unknowns = NumberRow::splat(self.unknowns().len(), 0.0);
        self.functions
            .position(&self.parameters, inputs, choice, &mut unknowns)?;
        Ok(unknowns)
    }

    pub(super) fn residuals(&self, inputs: &[f64], unknowns: &[f64]) -> NumberRow {
        let mut residuals = NumberRow::splat(unknowns.len(), 0.0);
        let functions: &dyn ClosureOver<f64> = self.functions;
        functions.closure(&self.parameters, inputs, unknowns, &mut residuals);
        residuals
    }

    /// The residuals of bounds, of which the parameters are the [rounded](Self::rounded) ones.
    pub(super) fn bounded_residuals(
        &self,
        parameters: &[Bounds],
        inputs: &[Bounds],
        unknowns: &[Bounds],
    ) -> Vec<Bounds> {
        let mut residuals = vec![Bounds::rounded(0.0); unknowns.len()];
        let functions: &dyn ClosureOver<Bounds> = self.functions;
        functions.closure(parameters, inputs, unknowns, &mut residuals);
        residuals
    }

    /// The parameters as bounds of their last digits.
    pub(super) fn rounded(&self) -> Vec<Bounds> {
        self.parameters.iter().copied().map(Bounds::rounded).collect()
    }

    pub(super) fn track(
        &self,
        from: &[f64],
        unknowns: &[f64],
        to: &[f64],
    ) -> Result<NumberRow, TrackError<Vec<f64>, Vec<f64>>> {
        let found = track_between(self.functions, &self.parameters, from, unknowns, to)?;
        Ok(NumberRow::from(&*found))
    }

    /// The sum of all lengths.
    pub(super) fn reach(&self) -> f64 {
        sum_of_lengths(self.description().parameters, &self.parameters)
    }

    /// The distance of two positions: the largest difference of a direction, or of a length in parts of the size of the
    /// mechanism.
    pub(super) fn distance(&self, size: f64, one: &[f64], other: &[f64]) -> f64 {
        let pairs = one.iter().zip(other);
        let named = self.unknowns().iter().zip(pairs);
        named.fold(0.0, |largest: f64, (quantity, (one, other))| {
            largest.max(match quantity.dimension {
                Dimension::Angle => wrapped(one - other).abs(),
                Dimension::Length => (one - other).abs() / size.max(f64::MIN_POSITIVE),
                Dimension::Scalar => (one - other).abs() / one.abs().max(1.0),
            })
        })
    }

    /// The values of the unknowns, with angles unwrapped to the closest of others.
    pub(super) fn nearest(&self, values: &[f64], near: &[f64]) -> NumberRow {
        let unknowns = self.unknowns();
        NumberRow::from_fn(values.len(), |index| match unknowns[index].dimension {
            Dimension::Angle => near[index] + wrapped(values[index] - near[index]),
            _ => values[index],
        })
    }
}

/// The sum of those values that are lengths.
pub(super) fn sum_of_lengths(quantities: &[Quantity<'_>], values: &[f64]) -> f64 {
    let named = quantities.iter().zip(values);
    named
        .filter(|(quantity, _)| quantity.dimension == Dimension::Length)
        .fold(0.0, |sum, (_, value)| sum + value.abs())
}
