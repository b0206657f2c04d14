//! The report of a mechanism, gathered from kin-core.

mod assemblies;
mod circuits;
mod contacts;
mod describe;
mod drive;
mod forces;
mod line;
mod peaks;
mod shown;
mod solver;
mod transmission;
mod way;

use data_encoding::HEXLOWER;
use hmac_sha256::Hash;
use kin_core::any::{AssemblyChoice, Description, Quantity};
use kin_core::in_small_letters;
use kin_core::law::{Law, Piecewise};
use kin_core::sweep::SmoothDrive;

use self::line::Line;
use self::shown::ShownAssembly;
use self::solver::Solver;
use self::way::Way;
use super::ReportError;
use super::draft::{WayWished, Wishes};
use super::model::{Assembly, Cycle, Drive, FORMAT, Forces, NotClosed, Report, Units, Variable};

/// The report that is wished for.
pub(super) fn report(wishes: &Wishes<'_>) -> Result<Report, ReportError> {
    check(wishes)?;
    let solver = Solver::record(wishes.functions);
    match &wishes.way {
        WayWished::UnderLaws(laws, range) => under_laws(wishes, solver, laws, *range),
        WayWished::OneInput | WayWished::Between(_) => along_line(wishes, solver),
    }
}

/// The parts of a report that are known before its poses.
struct Known {
    drive: Drive,
    range: [f64; 2],
    speed: f64,
    /// The assemblies, and the index of the shown assembly.
    assemblies: (Vec<Assembly>, usize),
    period: Option<f64>,
    cycle: Option<Cycle>,
}

fn along_line(wishes: &Wishes<'_>, solver: Solver) -> Result<Report, ReportError> {
    let linkage = &wishes.linkage;
    let line = Line::new(wishes)?;
    let cycle = line
        .cycle(linkage)
        .map_err(|error| ReportError::ClosesNowhere { error })?;
    let shown = ShownAssembly::on_line(wishes, &line, &cycle)?;
    let range = match line.range {
        Some(range) => range,
        None => shown.range(&cycle, line.start)?,
    };
    let way = Way::along(linkage, &line, range, &cycle, &shown)?;
    let known = Known {
        drive: drive::of(
            &line.sweep(linkage, &shown.assembly, range),
            linkage.description(),
            Variable::Input,
            range,
        )?,
        range,
        speed: line.speed,
        assemblies: assemblies::on_line(&solver, &cycle, &shown, range),
        period: cycle.period(),
        cycle: Some(circuits::of(wishes, &cycle, &shown, range)),
    };
    moved(wishes, solver, &way, known)
}

fn under_laws(
    wishes: &Wishes<'_>,
    solver: Solver,
    laws: &[&dyn Piecewise<f64>],
    range: [f64; 2],
) -> Result<Report, ReportError> {
    let linkage = &wishes.linkage;
    let sweep = |assembly: &AssemblyChoice| {
        let sweep = linkage.sweep(assembly.clone());
        sweep.under_laws(laws, range[0]..=range[1], way::ROWS)
    };
    // the inputs move in all assemblies alike
    let any = AssemblyChoice::Index(0);
    let drive = drive::of(&sweep(&any), linkage.description(), Variable::Time, range)?;
    let inputs = |time: f64| -> Vec<f64> { laws.iter().map(|law| law.at::<1>(time).value()).collect() };
    let shown = ShownAssembly::under_laws(wishes, range, &inputs)?;
    let way = Way::under_laws(sweep(&shown.assembly));
    let known = Known {
        period: period(laws, &drive, range),
        drive,
        range,
        speed: 1.0,
        assemblies: assemblies::under_laws(&solver, linkage, &shown, range, &inputs),
        cycle: None,
    };
    moved(wishes, solver, &way, known)
}

/// The report of a motion.
fn moved<D: SmoothDrive>(
    wishes: &Wishes<'_>,
    solver: Solver,
    way: &Way<'_, D>,
    known: Known,
) -> Result<Report, ReportError> {
    let (functions, description) = (wishes.functions, wishes.linkage.description());
    let inputs = 0..description.inputs.len();
    let standing: Vec<Option<f64>> = inputs.map(|input| drive::standing(&known.drive, input)).collect();
    let poses = way.poses();
    if poses.iter().all(|(_, pose)| pose.is_err())
        && let Some((_, Err(error))) = poses.first()
    {
        return Err(ReportError::ClosesNowhere { error: *error });
    }
    let quantities = quantities(description, known.drive.variable, &standing);
    let found = if wishes.has_peaks {
        peaks::find(wishes, way, &quantities, drive::dwells(&known.drive))
    } else {
        peaks::Found::default()
    };
    let (assemblies, assembly) = known.assemblies;
    let forces = forces::of(wishes, way);
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
        parameters: describe::quantities(description.parameters, &solver.parameters, |parameter| {
            wishes.linkage.parameters().get(parameter).copied()
        }),
        inputs: describe::quantities(description.inputs, &solver.inputs, |input| standing[input]),
        unknowns: describe::quantities(description.unknowns, &solver.unknowns, |_| None),
        outputs: describe::quantities(description.outputs, &solver.outputs, |_| None),
        plots: plots(wishes, &quantities, forces.as_ref())?,
        moving: standing.iter().position(Option::is_none).unwrap_or(0),
        drive: known.drive,
        range: known.range,
        period: known
            .period
            .filter(|_| comes_back(description, known.range, known.period, &poses)),
        speed: known.speed,
        assemblies,
        assembly,
        coupled: wishes.linkage.assembly_count() == 0,
        space: functions.is_space(),
        cycle: known.cycle,
        extremes: found.extremes,
        rms: found.rms,
        unanswered: found.unanswered,
        transmission: transmission::of(wishes, way, &poses),
        sensitivities: found.sensitivities,
        formulas: describe::formulas(&functions.formulas()),
        blocks: describe::blocks(description),
        operations: describe::operations(description),
        not_closed: not_closed(wishes, &poses),
        outline: describe::outline(&functions.outline()),
        forces,
        frames: solver.text.is_none().then(|| solver::frames(wishes, &poses)),
        solver: solver.text,
        unrecorded: solver.unrecorded,
    })
}

/// Checks that the wishes about the motion fit together, and that all given numbers are finite.
fn check(wishes: &Wishes<'_>) -> Result<(), ReportError> {
    let of_one = [
        ("at", wishes.at.is_some()),
        ("moving", wishes.moving.is_some()),
        ("range", wishes.range.is_some()),
    ];
    let (beside, unread) = match &wishes.way {
        WayWished::OneInput => ("", Vec::new()),
        WayWished::Between(_) => ("between", of_one.to_vec()),
        WayWished::UnderLaws(..) => (
            "under_laws",
            [&of_one[..], &[("speed", wishes.speed.is_some())]].concat(),
        ),
    };
    if let Some((wish, _)) = unread.into_iter().find(|(_, is_said)| *is_said) {
        return Err(ReportError::SaidTwice { wish, beside });
    }
    let description = wishes.linkage.description();
    let given: &[Vec<f64>] = match &wishes.way {
        WayWished::Between(ends) => ends,
        _ => wishes.at.as_slice(),
    };
    let speed = wishes.speed.unwrap_or(1.0);
    let culprit = not_finite(description.parameters, wishes.linkage.parameters())
        .or_else(|| given.iter().find_map(|inputs| not_finite(description.inputs, inputs)))
        .or((!speed.is_finite()).then_some("the speed"));
    if let Some(quantity) = culprit {
        return Err(ReportError::NotFinite {
            quantity: quantity.to_owned(),
        });
    }
    if speed == 0.0 {
        return Err(ReportError::NoSpeed);
    }
    let range = match &wishes.way {
        WayWished::UnderLaws(_, range) => Some(*range),
        _ => wishes.range,
    };
    match range {
        Some([from, to]) if !(to - from > 0.0 && (to - from).is_finite()) => Err(ReportError::NoRange { from, to }),
        _ => Ok(()),
    }
}

/// The name of a quantity whose value is not finite.
fn not_finite<'d>(quantities: &[Quantity<'d>], values: &[f64]) -> Option<&'d str> {
    let mut pairs = quantities.iter().zip(values);
    let culprit = pairs.find(|(_, value)| !value.is_finite());
    culprit.map(|(quantity, _)| quantity.name)
}

/// The quantities that are plotted: unknowns and outputs, and under laws the inputs that move as well.
fn quantities<'d>(description: &Description<'d>, variable: Variable, standing: &[Option<f64>]) -> Vec<Quantity<'d>> {
    let inputs = description.inputs.iter().zip(standing);
    let moving = inputs.filter(|(_, stands)| variable == Variable::Time && stands.is_none());
    let results = description.unknowns.iter().chain(description.outputs);
    results.chain(moving.map(|(input, _)| input)).copied().collect()
}

/// The names of the quantities that are plotted at first. Forces are plotted at first only if they are named.
fn plots(
    wishes: &Wishes<'_>,
    quantities: &[Quantity<'_>],
    forces: Option<&Forces>,
) -> Result<Vec<String>, ReportError> {
    let names: Vec<String> = quantities.iter().map(|quantity| quantity.name.to_owned()).collect();
    let of_forces: Vec<String> = forces.iter().flat_map(|forces| forces.names()).collect();
    let is_there = |wanted: &String| names.contains(wanted) || of_forces.contains(wanted);
    match wishes.plots.iter().find(|wanted| !is_there(wanted)) {
        Some(name) => Err(ReportError::NoSuchQuantity {
            name: name.clone(),
            quantities: [names, of_forces].concat(),
        }),
        None if wishes.plots.is_empty() => Ok(names),
        None => Ok(wishes.plots.clone()),
    }
}

/// The length of the range, if all laws begin again at its end. A law that rests repeats itself in any range.
fn period(laws: &[&dyn Piecewise<f64>], drive: &Drive, [from, to]: [f64; 2]) -> Option<f64> {
    let repeats = |law: &dyn Piecewise<f64>| {
        let cycles = (to - from) / law.duration();
        law.repeats() && cycles > 0.5 && (cycles - cycles.round()).abs() < 1e-9
    };
    let mut all = laws.iter().enumerate();
    all.all(|(input, law)| drive::standing(drive, input).is_some() || repeats(*law))
        .then_some(to - from)
}

/// Whether the mechanism closes all over the range, and returns to its first position if the range is one period.
fn comes_back(description: &Description<'_>, [from, to]: [f64; 2], period: Option<f64>, poses: &[way::At]) -> bool {
    let all: Option<Vec<_>> = poses.iter().map(|(_, pose)| pose.as_ref().ok()).collect();
    let Some(all) = all else { return false };
    let is_one = period.is_some_and(|period| (to - from - period).abs() < 1e-9 * period);
    match all.as_slice() {
        [first, .., last] if is_one => shown::distance(description, first.unknowns(), last.unknowns()) < 1e-6,
        _ => true,
    }
}

/// The value of the variable at which the largest length is missing.
fn not_closed(wishes: &Wishes<'_>, poses: &[way::At]) -> Option<NotClosed> {
    let failed = poses.iter().filter_map(|(at, pose)| Some((*at, pose.as_ref().err()?)));
    let margin = |error: &kin_core::SolveError| match error.failure {
        kin_core::Failure::OutOfReach { margin } => Some(margin),
        _ => None,
    };
    // a failure without a margin is reported only if no failure has a margin
    let least = |error| margin(error).unwrap_or(f64::INFINITY);
    let (at, error) = failed.min_by(|(_, one), (_, other)| least(one).total_cmp(&least(other)))?;
    Some(NotClosed {
        text: wishes.named(error),
        unknowns: wishes.named(error.block),
        margin: margin(error),
        at,
    })
}

/// The digest that distinguishes designs, in hexadecimal digits.
fn hash(wishes: &Wishes<'_>) -> String {
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

/// A number to nine significant figures, for drawings.
fn short(value: f64) -> f64 {
    format!("{value:.8e}").parse().unwrap_or(value)
}
