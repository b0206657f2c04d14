//! Circuits and branches as they are shown.

use kin_core::cycle::{End, EndKind};
use kin_core::linkage::AnyCycle;
use kin_core::{Dimension, Name, Quantity};

use super::place::Own;
use crate::report::model;

/// So many positions of a branch are kept.
const SAMPLES: usize = 91;

/// The cycle as data.
pub(super) fn of(cycle: &AnyCycle<'static>, own: &Own, moving: Quantity, range: [f64; 2]) -> model::Cycle {
    let circuits = cycle.circuits().iter().map(|circuit| model::Circuit {
        branches: circuit.branches().to_vec(),
        closed: circuit.is_closed(),
        input_turns: circuit.input_turns(),
    });
    let branches = cycle.branches().iter().enumerate().map(|(index, branch)| {
        let ends = branch.ends();
        model::Branch {
            circuit: branch.circuit(),
            assembly: super::assemblies::of_branch(cycle, own, range, index),
            range: ends.map(|end| end.input),
            full_turn: branch.is_full_turn(),
            ends: ends.map(|end| model::End {
                kind: end
                    .limit()
                    .map_or_else(|| format!("{:?}", end.kind), |kind| format!("{kind:?}")),
                input: end.input,
                block: end.block.to_string(),
                text: text(end, moving),
            }),
            samples: samples(branch.samples()),
        }
    });
    model::Cycle {
        complete: cycle.is_complete(),
        incomplete: cycle.incomplete().iter().map(ToString::to_string).collect(),
        circuits: circuits.collect(),
        branches: branches.collect(),
    }
}

/// Some of the positions, with the first and the last one.
fn samples(all: &[(f64, Vec<f64>)]) -> Vec<Vec<f64>> {
    let last = all.len().saturating_sub(1);
    let count = all.len().min(SAMPLES);
    let mut kept: Vec<usize> = (0..count)
        .map(|place| place * last / count.saturating_sub(1).max(1))
        .collect();
    kept.dedup();
    let sample = |index: usize| {
        let (input, unknowns) = &all[index];
        let values = std::iter::once(input).chain(unknowns);
        values.copied().map(super::short).collect()
    };
    kept.into_iter().map(sample).collect()
}

/// An end in a few words.
fn text(end: &End, quantity: Quantity) -> String {
    let place = match quantity.dimension {
        Dimension::Angle => format!("{:.4}°", end.input.to_degrees()),
        _ => format!("{:.6}", end.input),
    };
    let of = if end.block == Name::NONE {
        String::new()
    } else {
        format!(" of {}", end.block)
    };
    match end.kind {
        EndKind::Limit(kind) => format!("{kind}{of} at {place}"),
        EndKind::Range => format!("end of the range that was looked at, {place}"),
        EndKind::FullTurn => "goes on for a full turn".to_owned(),
        _ => format!("the search could not go on at {place}"),
    }
}
