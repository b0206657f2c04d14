//! A mechanism beside its oracles, and the functions from which it is fitted.

use std::sync::Arc;

use kin_core::verify::{self, Sampling};
use kin_fit::{Choice, FitFunctions};

use super::fault::Fault;
use super::motion::InputMotion;
use super::subject::{Subject, Wanted, assembly_at};
use super::typed::Case;

impl Subject {
    /// Both oracles.
    pub(crate) fn verify(&self, case: &Case) -> verify::Report {
        let ranges: Vec<(f64, f64)> = case.motions.iter().map(InputMotion::extent).collect();
        Sampling::default().of_any(&*self.functions, &case.parameters, &ranges)
    }

    /// The functions from which it is fitted. They stay until the program ends, which a fit is the last task of.
    pub(crate) fn fit_functions(&self) -> &'static dyn FitFunctions {
        let functions: &'static Arc<_> = Box::leak(Box::new(Arc::clone(&self.functions)));
        &**functions
    }

    /// The choice of a position for all dimensions. Values nearby are those where the motion begins, and other
    /// positions are reached from there.
    pub(crate) fn choice(&self, case: &Case, start: &[f64]) -> Result<Choice, Fault> {
        let from = |inputs: &[f64], near: &[f64]| Choice::From {
            inputs: inputs.to_vec(),
            near: near.to_vec(),
        };
        match &case.assembly {
            Wanted::Near(near) => Ok(from(start, near)),
            Wanted::At { inputs, near } => Ok(from(inputs, near)),
            wanted @ (Wanted::Named(_) | Wanted::Unknown) => {
                let found = assembly_at(wanted, &self.linkage(&case.parameters), start)?;
                Ok(found.index().map_or_else(|| from(start, &[]), Choice::Assembly))
            }
        }
    }
}
