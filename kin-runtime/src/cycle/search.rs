//! The search for all circuits and branches, without the type of the mechanism.

use super::data::{Branch, CycleData, EndKind};
use super::joined::{circuits, joined_at_the_seam};
use super::line::InputLine;
use super::sought::{ClosedForms, CoupledBlocks, SoughtMechanism};
use super::unit::LengthUnit;
use super::{Incomplete, closed, coupled};
use crate::any::PositionChoice;
use crate::failure::{Failure, InputValues, SolveError};
use crate::number::NumberRow;

/// The functions of a search: there are other ones for closed forms and for coupled blocks.
pub enum SearchMethod<'f> {
    /// Every block has a closed form.
    Closed(&'f dyn ClosedForms),
    /// A block is coupled.
    Coupled(&'f dyn CoupledBlocks),
}

/// All circuits and branches along a line of inputs, which is given by a point and a direction.
pub(super) fn search(
    mechanism: &SoughtMechanism<'_>,
    functions: &SearchMethod<'_>,
    [from, direction]: [NumberRow; 2],
    range: Option<[f64; 2]>,
) -> Result<(InputLine, CycleData), SolveError> {
    let failed = |quantity: &'static str| {
        let names = InputValues::of(mechanism.functions.input_names(), &from);
        let block = mechanism.block_name(0);
        Failure::not_finite(quantity).at(block, names)
    };
    let unit = LengthUnit::of(mechanism, &from);
    // The search sees lengths in its unit, and the same coordinates of the line.
    let sought = unit.mechanism(mechanism);
    let inputs = mechanism.inputs();
    let line = InputLine::new(&sought, unit.row(inputs, &from), unit.row(inputs, &direction), range);
    let is_finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
    let is_known = is_finite(&mechanism.parameters)
        && is_finite(&from)
        && is_finite(&direction)
        && (line.high - line.low).is_finite();
    // what a search along the line or over the range would divide by
    if !is_known {
        return Err(failed("parameters or range of the inputs"));
    } else if direction.iter().all(|rate| *rate == 0.0) {
        return Err(failed("reciprocal of the direction of the inputs, which is zero"));
    } else if line.high <= line.low {
        return Err(failed("reciprocal of the length of the range, which is zero"));
    }
    let mut found = match functions {
        SearchMethod::Closed(functions) => closed::search(&sought, *functions, &line),
        SearchMethod::Coupled(functions) => coupled::search(&sought, *functions, &line)?,
    };
    let mut branches = joined_at_the_seam(&sought, &line, &found);
    let lost = branches.iter().flat_map(|branch| &branch.ends);
    found.incomplete.extend(
        lost.filter(|end| end.kind == EndKind::Lost)
            .map(|end| Incomplete::Lost {
                input: end.input,
                is_angle: line.is_angle,
            }),
    );
    let circuits = circuits(&sought, &line, &mut branches);
    for branch in &mut branches {
        let ends = branch.ends.iter_mut().map(|end| &mut end.unknowns);
        for unknowns in ends.chain(branch.samples.iter_mut().map(|(_, unknowns)| unknowns)) {
            *unknowns = unit.inverse().row(mechanism.unknowns(), unknowns).to_vec();
        }
    }
    let line = InputLine {
        from,
        direction,
        ..line
    };
    if let Some(error) = refusal(mechanism, &line, &branches) {
        return Err(error);
    }
    let data = CycleData {
        branches,
        circuits,
        incomplete: found.incomplete,
        undecided: found.undecided,
        seeds: found.seeds,
        period: line.period(),
    };
    Ok((line, data))
}

/// The error of the solver if lengths are so large or so small that it refuses the positions of the cycle, which
/// has a separate unit.
fn refusal(mechanism: &SoughtMechanism<'_>, line: &InputLine, branches: &[Branch]) -> Option<SolveError> {
    let refused = |error: SolveError| matches!(error.failure, Failure::NotFinite { .. }).then_some(error);
    let mut middles = branches.iter().filter_map(|branch| {
        let (s, unknowns) = branch.samples.get(branch.samples.len() / 2)?;
        let choice = match branch.assembly {
            Some(assembly) => PositionChoice::Assembly(assembly),
            None => PositionChoice::Near(unknowns),
        };
        mechanism.position(&line.inputs(*s), choice).err()
    });
    if !branches.is_empty() {
        return middles.find_map(refused);
    }
    let inputs = line.inputs(0.5 * (line.low + line.high));
    let mut solved = mechanism
        .assemblies()
        .map(|assembly| mechanism.position(&inputs, PositionChoice::Assembly(assembly)));
    solved.find_map(|solved| refused(solved.err()?))
}
