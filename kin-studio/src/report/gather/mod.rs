//! The report of a mechanism, gathered from kin-core.

mod assemblies;
mod circuits;
mod describe;
mod peaks;
mod place;
mod solver;
mod transmission;
mod way;

use data_encoding::HEXLOWER;
use hmac_sha256::Hash;
use kin_core::in_small_letters;

use self::place::Own;
use self::solver::Solver;
use self::way::Way;
use super::ReportError;
use super::draft::Wishes;
use super::model::{FORMAT, NotClosed, Report, Units};

/// The report that is wished for.
pub(super) fn report(wishes: &Wishes) -> Result<Report, ReportError> {
    let (functions, description) = (wishes.functions, wishes.linkage.description());
    check(wishes)?;
    let moving = moving(wishes)?;
    let (from, direction) = line(wishes, moving);
    let cycle = wishes
        .linkage
        .cycle_along(&from, &direction)
        .map_err(|error| ReportError::ClosesNowhere { error })?;
    let own = Own::find(wishes, moving, &cycle)?;
    let range = match wishes.range {
        Some(range) => range,
        None => own.range(&cycle, wishes.inputs[moving])?,
    };
    let way = Way::new(wishes, moving, range, &cycle, &own)?;
    let solver = Solver::record(functions);
    let poses = way.poses();
    if poses.iter().all(|(_, pose)| pose.is_err())
        && let Some((_, Err(error))) = poses.first()
    {
        return Err(ReportError::ClosesNowhere { error: *error });
    }
    let (assemblies, assembly) = assemblies::list(&solver, &cycle, &own, range);
    let found = peaks::find(&way, description);
    let closes = poses.iter().all(|(_, pose)| pose.is_ok());
    Ok(Report {
        format: FORMAT,
        kin: env!("CARGO_PKG_VERSION").to_owned(),
        title: wishes.title.clone().unwrap_or_else(|| description.name.to_owned()),
        name: description.name.to_owned(),
        module: in_small_letters(description.name, '_'),
        documentation: wishes.documentation.clone(),
        declaration: wishes.declaration.clone(),
        hash: hash(wishes),
        units: Units {
            length: wishes.length.clone(),
            time: wishes.time.clone(),
        },
        degrees: wishes.degrees,
        order: description.order,
        parameters: describe::quantities(
            description.parameters,
            &solver.parameters,
            Some(wishes.linkage.parameters()),
        ),
        inputs: describe::quantities(description.inputs, &solver.inputs, Some(&wishes.inputs)),
        unknowns: describe::quantities(description.unknowns, &solver.unknowns, None),
        outputs: describe::quantities(description.outputs, &solver.outputs, None),
        plots: plots(wishes)?,
        moving,
        range,
        period: cycle.period().filter(|_| closes),
        speed: wishes.speed,
        assemblies,
        assembly,
        coupled: wishes.linkage.assembly_count() == 0,
        space: functions.is_space(),
        cycle: Some(circuits::of(&cycle, &own, description.inputs[moving], range)),
        extremes: found.extremes,
        rms: found.rms,
        unanswered: found.unanswered,
        transmission: transmission::of(wishes, &way, &poses),
        sensitivities: found.sensitivities,
        formulas: describe::formulas(&functions.formulas()),
        blocks: describe::blocks(description),
        operations: describe::operations(description),
        not_closed: not_closed(&poses),
        outline: describe::outline(&functions.outline()),
        frames: solver.text.is_none().then(|| solver::frames(wishes, &poses)),
        solver: solver.text,
        unrecorded: solver.unrecorded,
    })
}

/// All numbers that were given are numbers.
fn check(wishes: &Wishes) -> Result<(), ReportError> {
    let named = |quantities: &[kin_core::Quantity], values: &[f64]| {
        let mut pairs = quantities.iter().zip(values);
        pairs
            .find(|(_, value)| !value.is_finite())
            .map(|(quantity, _)| quantity.name)
    };
    let description = wishes.linkage.description();
    let culprit = named(description.parameters, wishes.linkage.parameters())
        .or_else(|| named(description.inputs, &wishes.inputs))
        .or((!wishes.speed.is_finite()).then_some("the speed"));
    if let Some(quantity) = culprit {
        return Err(ReportError::NotFinite {
            quantity: quantity.to_owned(),
        });
    }
    if wishes.speed == 0.0 {
        return Err(ReportError::NoSpeed);
    }
    match wishes.range {
        Some([from, to]) if !(to - from > 0.0 && (to - from).is_finite()) => Err(ReportError::NoRange { from, to }),
        _ => Ok(()),
    }
}

/// The index of the input that moves.
fn moving(wishes: &Wishes) -> Result<usize, ReportError> {
    let inputs = wishes.linkage.description().inputs;
    let Some(name) = &wishes.moving else { return Ok(0) };
    let found = inputs.iter().position(|input| input.name == name);
    found.ok_or_else(|| ReportError::NoSuchInput {
        name: name.clone(),
        inputs: inputs.iter().map(|input| input.name.to_owned()).collect(),
    })
}

/// The names of the quantities that are plotted at first.
fn plots(wishes: &Wishes) -> Result<Vec<String>, ReportError> {
    let description = wishes.linkage.description();
    let quantities = description.unknowns.iter().chain(description.outputs);
    let names: Vec<String> = quantities.map(|quantity| quantity.name.to_owned()).collect();
    match wishes.plots.iter().find(|wanted| !names.contains(wanted)) {
        Some(name) => Err(ReportError::NoSuchQuantity {
            name: name.clone(),
            quantities: names,
        }),
        None if wishes.plots.is_empty() => Ok(names),
        None => Ok(wishes.plots.clone()),
    }
}

/// The line of inputs along which the moving input goes: its value is the distance along the line.
fn line(wishes: &Wishes, moving: usize) -> (Vec<f64>, Vec<f64>) {
    let mut from = wishes.inputs.clone();
    let mut direction = vec![0.0; from.len()];
    (from[moving], direction[moving]) = (0.0, 1.0);
    (from, direction)
}

/// The place of the range where the most is missing.
fn not_closed(poses: &[way::At]) -> Option<NotClosed> {
    let failed = poses.iter().filter_map(|(at, pose)| Some((*at, pose.as_ref().err()?)));
    let margin = |error: &kin_core::SolveError| match error.failure {
        kin_core::Failure::OutOfReach { margin } => Some(margin),
        _ => None,
    };
    // a failure without a margin is told only if no other has one
    let least = |error| margin(error).unwrap_or(f64::INFINITY);
    let (at, error) = failed.min_by(|(_, one), (_, other)| least(one).total_cmp(&least(other)))?;
    Some(NotClosed {
        text: error.to_string(),
        unknowns: error.block.to_owned(),
        margin: margin(error),
        at,
    })
}

/// What tells one design from another, in hexadecimal digits.
fn hash(wishes: &Wishes) -> String {
    let mut hash = Hash::new();
    let mut add = |text: &str| {
        hash.update(text);
        hash.update([0]);
    };
    add(env!("CARGO_PKG_VERSION"));
    let description = wishes.linkage.description();
    add(description.name);
    description.equations.iter().for_each(|equation| add(equation));
    add(wishes.declaration.as_deref().unwrap_or_default());
    for (quantity, value) in description.parameters.iter().zip(wishes.linkage.parameters()) {
        add(quantity.name);
        add(&format!("{value:?}"));
    }
    HEXLOWER.encode(&hash.finalize())
}

/// A number to nine significant figures, for what is only drawn.
fn short(value: f64) -> f64 {
    format!("{value:.8e}").parse().unwrap_or(value)
}
