//! A cycle that has been searched, with what its questions need, without the type of the mechanism.

use core::fmt;

use super::data::CycleData;
use super::line::InputLine;
use super::search::search;
use super::sought::{SearchedFunctions, SoughtMechanism};
use crate::failure::SolveError;
use crate::sweep::StraightLine;

/// All circuits and branches, with the mechanism and the line of inputs.
#[derive(Clone)]
pub(crate) struct SearchedCycle<'m> {
    pub(super) mechanism: SoughtMechanism<'m>,
    pub(super) line: InputLine,
    pub(crate) data: CycleData,
}

impl<'m> SearchedCycle<'m> {
    /// Searches along a line of inputs, which is given by a point and a direction.
    pub(crate) fn new(
        functions: &'m dyn SearchedFunctions,
        parameters: &[f64],
        line: [&[f64]; 2],
        range: Option<[f64; 2]>,
    ) -> Result<Self, SolveError> {
        let mechanism = SoughtMechanism {
            functions,
            parameters: parameters.into(),
        };
        let (line, data) = search(&mechanism, &functions.method(), line.map(Into::into), range)?;
        Ok(Self { mechanism, line, data })
    }

    /// Searches between two points in the space of the inputs, over the first input that moves.
    pub(crate) fn between(
        functions: &'m dyn SearchedFunctions,
        parameters: &[f64],
        [from, to]: [&[f64]; 2],
    ) -> Result<Self, SolveError> {
        let line = StraightLine::new(from, to);
        let [origin, direction] = line.unbounded();
        Self::new(functions, parameters, [&origin, &direction], Some(line.range()))
    }
}

impl fmt::Debug for SearchedCycle<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("SearchedCycle")
            .field("data", &self.data)
            .finish_non_exhaustive()
    }
}
