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
use kin_core::cycle::FullCycle as _;
use kin_core::{Mechanism, PlaneOrSpace, PointArray, Row as _, in_small_letters};

use self::place::Own;
use self::solver::Solver;
use self::way::Way;
use super::model::{FORMAT, NotClosed, Report, Units};
use super::{Draft, ReportError};

/// The report that a draft wishes for.
pub(super) fn report<M: Mechanism<Scalar = f64>>(draft: &Draft<M>) -> Result<Report, ReportError> {
    let mechanism = &draft.mechanism;
    let description = M::DESCRIPTION;
    check(draft)?;
    let moving = moving(draft)?;
    let (from, direction) = line::<M>(draft, moving);
    let cycle = mechanism
        .cycle_along(from, direction)
        .map_err(|error| ReportError::ClosesNowhere { error })?;
    let own = Own::find(draft, moving, &cycle)?;
    let range = match draft.range {
        Some(range) => range,
        None => own.range(&cycle, draft.inputs[moving])?,
    };
    let way = Way::new(draft, moving, range, &cycle, &own)?;
    let solver = Solver::record::<M>();
    let poses = way.poses();
    if poses.iter().all(|(_, pose)| pose.is_err())
        && let Some((_, Err(error))) = poses.first()
    {
        return Err(ReportError::ClosesNowhere { error: *error });
    }
    let (assemblies, assembly) = assemblies::list(&solver, &cycle, &own, range);
    let found = peaks::find(&way);
    let closes = poses.iter().all(|(_, pose)| pose.is_ok());
    let parameters = mechanism.parameters();
    Ok(Report {
        format: FORMAT,
        kin: env!("CARGO_PKG_VERSION").to_owned(),
        title: draft.title.clone().unwrap_or_else(|| description.name.to_owned()),
        name: description.name.to_owned(),
        module: in_small_letters(description.name, '_'),
        documentation: draft.documentation.clone(),
        declaration: draft.declaration.clone(),
        hash: hash(draft),
        units: Units {
            length: draft.length.clone(),
            time: draft.time.clone(),
        },
        degrees: draft.degrees,
        order: description.order,
        parameters: describe::quantities(description.parameters, &solver.parameters, Some(parameters.as_ref())),
        inputs: describe::quantities(description.inputs, &solver.inputs, Some(draft.inputs.as_ref())),
        unknowns: describe::quantities(description.unknowns, &solver.unknowns, None),
        outputs: describe::quantities(description.outputs, &solver.outputs, None),
        plots: plots(draft)?,
        moving,
        range,
        period: cycle.period().filter(|_| closes),
        speed: draft.speed,
        assemblies,
        assembly,
        coupled: M::ASSEMBLY_COUNT == 0,
        space: !<<M::Places as PointArray>::Point as PlaneOrSpace>::IS_PLANE,
        cycle: Some(circuits::of(&cycle, &own, moving, range)),
        extremes: found.extremes,
        rms: found.rms,
        unanswered: found.unanswered,
        transmission: transmission::of(&way, &poses),
        sensitivities: found.sensitivities,
        formulas: describe::formulas::<M>(),
        blocks: describe::blocks::<M>(),
        operations: describe::operations::<M>(),
        not_closed: not_closed::<M>(&poses),
        outline: describe::outline::<M>(),
        frames: solver.text.is_none().then(|| solver::frames(&way, &poses)),
        solver: solver.text,
        unrecorded: solver.unrecorded,
    })
}

/// All numbers of the draft are numbers.
fn check<M: Mechanism<Scalar = f64>>(draft: &Draft<M>) -> Result<(), ReportError> {
    let named = |quantities: &[kin_core::Quantity], values: &[f64]| {
        let mut pairs = quantities.iter().zip(values);
        pairs
            .find(|(_, value)| !value.is_finite())
            .map(|(quantity, _)| quantity.name)
    };
    let parameters = draft.mechanism.parameters();
    let culprit = named(M::DESCRIPTION.parameters, parameters.as_ref())
        .or_else(|| named(M::DESCRIPTION.inputs, draft.inputs.as_ref()))
        .or((!draft.speed.is_finite()).then_some("the speed"));
    if let Some(quantity) = culprit {
        return Err(ReportError::NotFinite {
            quantity: quantity.to_owned(),
        });
    }
    if draft.speed == 0.0 {
        return Err(ReportError::NoSpeed);
    }
    match draft.range {
        Some([from, to]) if !(to - from > 0.0 && (to - from).is_finite()) => Err(ReportError::NoRange { from, to }),
        _ => Ok(()),
    }
}

/// The index of the input that moves.
fn moving<M: Mechanism<Scalar = f64>>(draft: &Draft<M>) -> Result<usize, ReportError> {
    let inputs = M::DESCRIPTION.inputs;
    let Some(name) = &draft.moving else { return Ok(0) };
    let found = inputs.iter().position(|input| input.name == name);
    found.ok_or_else(|| ReportError::NoSuchInput {
        name: name.clone(),
        inputs: inputs.iter().map(|input| input.name.to_owned()).collect(),
    })
}

/// The names of the quantities that are plotted at first.
fn plots<M: Mechanism<Scalar = f64>>(draft: &Draft<M>) -> Result<Vec<String>, ReportError> {
    let description = M::DESCRIPTION;
    let quantities = description.unknowns.iter().chain(description.outputs);
    let names: Vec<String> = quantities.map(|quantity| quantity.name.to_owned()).collect();
    match draft.plots.iter().find(|wanted| !names.contains(wanted)) {
        Some(name) => Err(ReportError::NoSuchQuantity {
            name: name.clone(),
            quantities: names,
        }),
        None if draft.plots.is_empty() => Ok(names),
        None => Ok(draft.plots.clone()),
    }
}

/// The line of inputs along which the moving input goes: its value is the distance along the line.
fn line<M: Mechanism<Scalar = f64>>(draft: &Draft<M>, moving: usize) -> (M::Inputs<f64>, M::Inputs<f64>) {
    let own = |input: usize| input == moving;
    (
        M::Inputs::from_fn(|input| if own(input) { 0.0 } else { draft.inputs[input] }),
        M::Inputs::from_fn(|input| if own(input) { 1.0 } else { 0.0 }),
    )
}

/// The place of the range where the most is missing.
fn not_closed<M: Mechanism<Scalar = f64>>(poses: &[way::At<M>]) -> Option<NotClosed> {
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
fn hash<M: Mechanism<Scalar = f64>>(draft: &Draft<M>) -> String {
    let mut hash = Hash::new();
    let mut add = |text: &str| {
        hash.update(text);
        hash.update([0]);
    };
    add(env!("CARGO_PKG_VERSION"));
    add(M::DESCRIPTION.name);
    M::DESCRIPTION.equations.iter().for_each(|equation| add(equation));
    add(draft.declaration.as_deref().unwrap_or_default());
    for (quantity, value) in M::DESCRIPTION
        .parameters
        .iter()
        .zip(draft.mechanism.parameters().as_ref())
    {
        add(quantity.name);
        add(&format!("{value:?}"));
    }
    HEXLOWER.encode(&hash.finalize())
}

/// A number to nine significant figures, for what is only drawn.
fn short(value: f64) -> f64 {
    format!("{value:.8e}").parse().unwrap_or(value)
}
