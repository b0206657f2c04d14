//! The branches of a circuit as sweeps, on which angles go on from branch to branch.

use alloc::vec::Vec;

use super::data::Branch;
use super::line::whole_revolutions;
use super::measure::{MeasureError, MeasuredFunctions};
use super::{End, SearchedCycle};
use crate::any::AssemblyChoice;
use crate::extremes::{KnownStretch, KnownSweep};
use crate::number::NumberRow;
use crate::quantity::{Dimension, Quantity};
use crate::sweep::{Footing, UntypedSweep, Walk};

/// The distance from the end of a branch at which the revolutions of angles are compared, as a part of the branch.
const NEAR_END: f64 = 1e-6;

/// A pose inside of a branch, with angles that have come from the branches before it.
pub(super) struct BranchStation<'c> {
    pub(super) branch: usize,
    footing: Footing<'c>,
}

/// The branches of a cycle, with the functions that quantities along them need.
#[derive(Clone, Copy)]
pub(crate) struct MeasuredCycle<'c> {
    pub(crate) cycle: &'c SearchedCycle<'c>,
    pub(crate) functions: &'c dyn MeasuredFunctions,
}

impl<'c> MeasuredCycle<'c> {
    pub(super) fn branch(&self, branch: usize) -> &'c Branch {
        &self.cycle.data.branches[branch]
    }

    pub(super) fn circuit(&self, circuit: usize) -> Result<&'c [usize], MeasureError> {
        let circuit = self
            .cycle
            .data
            .circuits
            .get(circuit)
            .ok_or(MeasureError::NoSuchCircuit)?;
        Ok(circuit.branches())
    }

    /// A pose inside of each branch of a circuit.
    pub(super) fn branch_stations(&self, circuit: usize) -> Result<Vec<BranchStation<'c>>, MeasureError> {
        let mut stations: Vec<BranchStation<'c>> = Vec::new();
        for branch in self.circuit(circuit)? {
            let Some((at, unknowns)) = self.inside(*branch) else {
                continue;
            };
            let mut station = self.station(*branch, at, &unknowns);
            let joined = stations
                .iter()
                .find_map(|before| Some((before, self.common_end(before.branch, *branch)?)));
            if let Some((before, [there, here])) = joined
                && let Some(there) = self.near_end(before, there)
            {
                if let Some(here) = self.near_end(&station, here) {
                    let quantities = self.cycle.mechanism.unknowns();
                    let unknowns = moved_by_revolutions(quantities, &there.unknowns(), &here.unknowns(), &unknowns);
                    station = self.station(*branch, at, &unknowns);
                }
                if let Some(here) = self.near_end(&station, here) {
                    let outputs = station.footing.outputs();
                    let quantities = self.cycle.mechanism.description().outputs;
                    let moved = moved_by_revolutions(quantities, &there.outputs(), &here.outputs(), &outputs);
                    station.footing.set_outputs(&moved);
                }
            }
            stations.push(station);
        }
        Ok(stations)
    }

    /// The sweep over a branch.
    fn untyped(&self, station: &BranchStation<'c>) -> UntypedSweep<'c> {
        let branch = self.branch(station.branch);
        let [low, high] = branch.ends.each_ref().map(|end| end.input);
        let near = || AssemblyChoice::Near(station.footing.unknowns().to_vec());
        UntypedSweep {
            mechanism: self.functions,
            description: self.cycle.mechanism.description(),
            parameters: self.cycle.mechanism.parameters.clone(),
            assembly: branch.assembly.map_or_else(near, AssemblyChoice::Index),
            drive: &self.cycle.line,
            from: low,
            to: high,
            count: 2,
        }
    }

    /// The sweep over a branch, with its ends.
    pub(super) fn sweep(&self, station: &BranchStation<'c>) -> KnownSweep<'c> {
        KnownSweep {
            sweep: self.untyped(station),
            drive: &self.cycle.line,
            stretch: self.known(station),
        }
    }

    /// What is known of the sweep over a branch.
    fn known(&self, station: &BranchStation<'c>) -> KnownStretch<'c> {
        let branch = self.branch(station.branch);
        KnownStretch {
            limits: branch.ends.each_ref().map(End::limit),
            is_full_revolution: branch.is_full_revolution(),
            inside: Walk::from(station.footing.clone()),
        }
    }

    /// A sample of a branch that lies far from its ends.
    fn inside(&self, branch: usize) -> Option<(f64, Vec<f64>)> {
        let branch = self.branch(branch);
        let middle = 0.5 * (branch.ends[0].input + branch.ends[1].input);
        let distance = |sample: &&(f64, Vec<f64>)| (sample.0 - middle).abs();
        let samples = branch.samples.iter();
        samples
            .min_by(|one, other| distance(one).total_cmp(&distance(other)))
            .cloned()
    }

    /// A pose of a branch. A quantity that depends on the revolution of an angle follows it.
    fn station(&self, branch: usize, at: f64, unknowns: &[f64]) -> BranchStation<'c> {
        let (mechanism, inputs) = (&self.cycle.mechanism, self.cycle.line.inputs(at));
        let description = mechanism.description();
        let mut outputs = NumberRow::splat(description.outputs.len(), 0.0);
        self.functions
            .outputs(&mechanism.parameters, &inputs, unknowns, &mut outputs);
        let footing = Footing::of_position(description, at, [&inputs, unknowns, &outputs]);
        let station = BranchStation { branch, footing };
        match self.walked(&station, at) {
            Some(footing) => BranchStation { branch, footing },
            None => station,
        }
    }

    fn walked(&self, station: &BranchStation<'c>, at: f64) -> Option<Footing<'c>> {
        let mut walk = self.known(station).inside;
        let sweep = self.untyped(station);
        walk.step(&sweep, at, &sweep.motions(at)).ok().cloned()
    }

    fn near_end(&self, station: &BranchStation<'c>, end: usize) -> Option<Footing<'c>> {
        let ends = self.branch(station.branch).ends.each_ref().map(|end| end.input);
        let (end, other) = (ends[end], ends[1 - end]);
        self.walked(station, end + NEAR_END * (other - end))
    }

    /// The ends at which two branches meet.
    fn common_end(&self, one: usize, other: usize) -> Option<[usize; 2]> {
        let node = |branch: usize, end: usize| self.branch(branch).ends[end].node;
        let pairs = [[0, 0], [0, 1], [1, 0], [1, 1]];
        pairs
            .into_iter()
            .find(|[there, here]| node(one, *there).is_some() && node(one, *there) == node(other, *here))
    }
}

/// Values whose angles are moved by the whole revolutions between two others.
fn moved_by_revolutions(quantities: &[Quantity<'_>], to: &[f64], from: &[f64], values: &[f64]) -> NumberRow {
    NumberRow::from_fn(values.len(), |index| match quantities[index].dimension {
        Dimension::Angle => values[index] + whole_revolutions(to[index] - from[index]),
        _ => values[index],
    })
}
