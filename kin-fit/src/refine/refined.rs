//! The results.

use std::collections::BTreeMap;

use super::{Defect, DefectKind, Figures};
use crate::design::{Design, Misfit};
use crate::functions::FitFunctions;

/// A result that was kept.
#[derive(Clone, Debug)]
pub struct Refined {
    /// The number of its candidate.
    pub id: u64,
    /// Its dimensions, assembly and placement.
    pub design: Design,
    /// The inputs at which it passes its targets.
    pub inputs: Vec<f64>,
    /// The error at the start; `None` if the candidate does not close at all targets.
    pub start: Option<Misfit>,
    /// The error after the evolution strategy.
    pub evolved: Option<Misfit>,
    /// The error after the least squares.
    pub polished: Misfit,
    /// Half of the weighted sum of squares, with all terms.
    pub cost: f64,
    /// The steps of the least squares.
    pub steps: u64,
    /// The figures of the full cycle.
    pub figures: Figures,
}

/// A result that was dropped.
#[derive(Clone, Debug)]
pub struct Dropped {
    /// The number of its candidate.
    pub id: u64,
    /// Its dimensions, assembly and placement.
    pub design: Design,
    /// Why it was dropped.
    pub defect: Defect,
    /// Its error, if it closes at all targets.
    pub misfit: Option<Misfit>,
}

/// The results of all candidates.
#[derive(Clone, Debug)]
pub struct Refinement {
    pub(crate) functions: &'static dyn FitFunctions,
    /// The results that were kept, the least sum of squares first, and of equal ones the smallest number.
    pub results: Vec<Refined>,
    /// The results that were dropped, in the order of the candidates.
    pub dropped: Vec<Dropped>,
}

impl Refinement {
    pub(crate) fn sorted(functions: &'static dyn FitFunctions, refined: Vec<Result<Refined, Box<Dropped>>>) -> Self {
        let (mut results, mut dropped) = (Vec::new(), Vec::new());
        for one in refined {
            match one {
                Ok(one) => results.push(one),
                Err(one) => dropped.push(*one),
            }
        }
        results.sort_by(|one, other| one.cost.total_cmp(&other.cost).then(one.id.cmp(&other.id)));
        Self {
            functions,
            results,
            dropped,
        }
    }

    /// The number of results that were dropped, by the reason.
    #[must_use]
    pub fn counts(&self) -> BTreeMap<DefectKind, usize> {
        let mut counts = BTreeMap::new();
        for dropped in &self.dropped {
            *counts.entry(dropped.defect.kind()).or_insert(0) += 1;
        }
        counts
    }
}
