//! Circuits and branches as a report keeps them.

use kin_core::linkage::AnyCycle;

use super::shown::ShownAssembly;
use crate::report::draft::Wishes;
use crate::report::model::{Branch, Cycle, End};

/// The cycle without the positions along its branches.
pub(super) fn of(wishes: &Wishes<'_>, cycle: &AnyCycle<'_>, shown: &ShownAssembly, range: [f64; 2]) -> Cycle {
    let branches = cycle.branches().iter().enumerate().map(|(index, branch)| Branch {
        circuit: branch.circuit(),
        assembly: super::assemblies::of_branch(cycle, shown, range, index),
        ends: branch.ends().map(|end| End {
            kind: end.kind,
            input: end.input,
            block: wishes.named(end.block),
        }),
    });
    Cycle {
        incomplete: cycle.incomplete().iter().map(|reason| wishes.named(reason)).collect(),
        circuits: cycle.circuits().to_vec(),
        branches: branches.collect(),
    }
}
