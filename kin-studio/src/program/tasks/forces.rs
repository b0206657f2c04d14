//! `kin forces`: what the joints and the drives of a motion bear.

use kin_core::reaction::{Efficiency, ReactionPart};
use serde_json::{Map, Value, json};

use super::super::command::Forces;
use super::super::progress::watched;
use super::super::text::{self, Column};
use super::peaks::{Variable, moves_at};
use super::sweep::{headed, note_speed_jumps};
use super::{print, prove, write};
use crate::case::Case;
use crate::case::fault::Fault;
use crate::case::file::Settings;
use crate::case::loads::{ForceColumn, HEAT};
use crate::case::subject::{CaseForces, Extent, Subject};
use crate::forces::{Force, ROUNDING, Reached, ratio};
use crate::tables::quoted;

/// A force over the motion, in its unit. What is not determined is not a number, and what has no bound is infinite.
struct Borne {
    name: String,
    /// The bodies on which it acts, and that exert it; none of a drive.
    bodies: [String; 2],
    unit: String,
    /// The value that is largest in size, and where.
    peak: f64,
    at: f64,
    is_limit: bool,
    rms: f64,
    lowest: f64,
    /// The size of the largest rate.
    rate: f64,
}

pub(super) fn run(subject: &Subject, options: &Forces, settings: &Settings) -> Result<(), Fault> {
    check(subject, settings)?;
    let all = options.setup.typed(settings).each_assembly(subject);
    let (mut texts, mut objects, mut cases, mut are_proved) = (Vec::new(), Vec::new(), Vec::new(), true);
    for (assembly, typed) in &all {
        let case = typed.case(subject)?;
        if cases.is_empty() {
            note_speed_jumps(subject, &case)?;
        }
        if !options.prove.is_empty() {
            let (text, is_proved) = prove::shown(subject, &case, &options.prove, &options.tolerance)?;
            texts.push(headed(assembly, all.len(), text));
            are_proved &= is_proved;
            continue;
        }
        let (borne, efficiency) = match subject.forces_of(&case) {
            Some(forces) => (borne(subject, &case, &forces)?, efficiency(&case, &forces)?),
            None => (Vec::new(), None),
        };
        let one_of_several = (all.len() > 1).then_some(assembly.as_str());
        if options.csv.is_some() {
            texts.push(csv(
                subject,
                &case,
                (&borne, efficiency),
                one_of_several,
                cases.is_empty(),
            ));
        } else if options.json.is_some() {
            objects.push(object(subject, &case, &borne, efficiency, one_of_several));
        } else {
            texts.push(headed(assembly, all.len(), shown(subject, &case, &borne, efficiency)));
        }
        cases.push(case);
    }
    match (&options.csv, &options.json) {
        (Some(path), _) => write(path, &texts.concat())?,
        (_, Some(path)) => {
            let only = if objects.len() == 1 { objects.pop() } else { None };
            write(path, &(only.unwrap_or(Value::Array(objects)).to_string() + "\n"))?;
        }
        _ => print(&texts.join("\n"))?,
    }
    if !are_proved {
        return Err(Fault::failed("a limit is not proved"));
    }
    cases.iter().try_for_each(|case| subject.closes(case))
}

/// Whether there are loads and bodies. All that is missing is named at once.
fn check(subject: &Subject, settings: &Settings) -> Result<(), Fault> {
    let mut missing = Vec::new();
    if settings.loads.is_empty() {
        missing.push(
            "forces come from loads, and there are none: write a `.kin` file with `loads { mass of crank = 2kg at \
             (30mm, 0), inertia 0.02kgm2; }`, or with forces, as in `force tip = (0, -10N);`"
                .to_owned(),
        );
    }
    missing.extend(
        subject
            .forces(&settings.loads.stated(1.0))
            .no_joints()
            .map(ToString::to_string),
    );
    if missing.is_empty() {
        return Ok(());
    }
    Err(Fault::Wrong(missing.join("\n\n")))
}

/// The force of each joint, the moment of each slide, and the effort and the power of each drive.
fn borne(subject: &Subject, case: &Case, forces: &CaseForces<'_>) -> Result<Vec<Borne>, Fault> {
    let columns = case.forces(subject).all;
    let is_of_joint = |column: &&ForceColumn| matches!(column.force, Force::Reaction(..));
    let values = columns.iter().filter(|column| column.order == 0);
    let own = values.filter(|column| !column.is_coordinate());
    let (joints, drives): (Vec<_>, Vec<_>) = own.partition(is_of_joint);
    let own = [joints, drives].concat();
    let (mut all, mut faults) = (Vec::new(), Vec::new());
    watched("searching forces", own.len(), |step| {
        for column in &own {
            let rates = |other: &&ForceColumn| other.force == column.force && other.order == 1;
            let found = forces.extent(column).map_err(|fault| faults.push(fault)).ok();
            let rates = columns.iter().find(rates).filter(|_| found.is_some());
            let rate = match &found {
                Some(found) if is_steady(found) => rates.map(|_| NOTHING),
                _ => rates.and_then(|rates| forces.peak(rates).ok()),
            };
            step();
            let is_moment = matches!(column.force, Force::Reaction(_, ReactionPart::Moment));
            // a guide need not hold a moment
            if !is_moment || !found.as_ref().is_some_and(|found| peak(found).value == Some(0.0)) {
                let name = column.name(subject.description());
                let unit = column.unit(subject.description());
                let size = column.size(subject.description(), case.metres());
                let bodies = forces.bodies_of(&column.force);
                all.push(Borne::new([name, unit], bodies, size, found.as_ref(), rate));
            }
        }
    });
    let is_known = all.iter().any(|one| !one.bodies[0].is_empty() && !one.peak.is_nan());
    match faults.into_iter().next() {
        Some(fault) if !is_known => return Err(fault),
        Some(fault) => eprintln!("note: {fault}"),
        None => {}
    }
    Ok(all)
}

/// The mean powers of drives and of friction in watts, if a joint has friction.
fn efficiency(case: &Case, forces: &CaseForces<'_>) -> Result<Option<Efficiency>, Fault> {
    let found = forces.efficiency().transpose()?;
    let watts = case.metres().powi(2);
    Ok(found.map(|found| Efficiency {
        input: found.input * watts,
        heat: found.heat * watts,
    }))
}

/// The value that is largest in size; of two that differ by rounding, the positive one.
fn peak(extent: &Extent) -> Reached {
    let Extent { lowest, highest, .. } = *extent;
    let size = |reached: Reached| reached.value.map_or(f64::INFINITY, f64::abs);
    if size(lowest) > size(highest) * (1.0 + STEADY) {
        lowest
    } else {
        highest
    }
}

/// The rate of what does not change.
const NOTHING: Reached = Reached {
    value: Some(0.0),
    at: 0.0,
    is_limit: false,
};

/// Whether a force does not change but for rounding, in which nothing is to be sought.
fn is_steady(extent: &Extent) -> bool {
    let [lowest, highest] = [extent.lowest, extent.highest].map(|reached| reached.value);
    let change = lowest.zip(highest).map(|(lowest, highest)| highest - lowest);
    change.is_some_and(|change| change <= STEADY * peak(extent).value.map_or(0.0, f64::abs))
}

/// A change or a difference by this part of a force is rounding.
const STEADY: f64 = 1e-10;

impl Borne {
    /// What was found of a force, of which one has this size in its unit.
    fn new(
        [name, unit]: [String; 2],
        bodies: [String; 2],
        size: f64,
        found: Option<&Extent>,
        rate: Option<Reached>,
    ) -> Self {
        let value = |reached: Reached| reached.value.map_or(f64::INFINITY, |value| value * size);
        let highest = found.map(peak);
        let own = highest.map_or(f64::NAN, value);
        let lowest = found.map_or(f64::NAN, |extent| value(extent.lowest));
        let rms = found.and_then(|extent| extent.rms.as_ref().ok());
        Self {
            name,
            bodies,
            unit,
            peak: own,
            at: highest.map_or(f64::NAN, |highest| highest.at),
            is_limit: highest.is_some_and(|highest| highest.is_limit),
            rms: rms.map_or(f64::NAN, |rms| rms.value * size),
            lowest: if lowest.abs() < ROUNDING * own.abs() {
                0.0
            } else {
                lowest
            },
            rate: rate.map_or(f64::NAN, |rate| value(rate).abs()),
        }
    }
}

fn shown(subject: &Subject, case: &Case, all: &[Borne], efficiency: Option<Efficiency>) -> String {
    let variable = Variable::new(subject, case);
    let words =
        |head, of: &dyn Fn(&Borne) -> &str| Column::words(head, all.iter().map(|one| of(one).to_owned()).collect());
    let numbers = |head, of: &dyn Fn(&Borne) -> f64| {
        let text = |one: &Borne| match of(one) {
            value if value.is_infinite() => "unbounded".to_owned(),
            value => text::digits(value),
        };
        Column::numbers(head, all.iter().map(text).collect())
    };
    let at = |one: &Borne| {
        if one.at.is_nan() {
            String::new()
        } else {
            variable.text(one.at, one.is_limit)
        }
    };
    let columns = [
        words("force", &|one| &one.name),
        words("on", &|one| &one.bodies[0]),
        words("by", &|one| &one.bodies[1]),
        words("unit", &|one| &one.unit),
        numbers("peak", &|one| one.peak),
        Column::words("", all.iter().map(at).collect()),
        numbers("rms", &|one| one.rms),
        numbers("lowest", &|one| one.lowest),
        numbers("rate", &|one| one.rate),
    ];
    let powers = efficiency.map_or_else(String::new, |mean| {
        let ratio = ratio(mean).map_or_else(String::new, |ratio| format!("; efficiency {}", text::digits(ratio)));
        let [input, heat] = [mean.input, mean.heat].map(text::digits);
        format!("drives give {input} W in the mean, and friction turns {heat} W into heat{ratio}\n")
    });
    text::table(&columns) + &powers + &moves_at(subject, case)
}

/// The same as an object of JSON. What is not determined is null, and what has no bound is the word `unbounded`.
fn object(
    subject: &Subject,
    case: &Case,
    all: &[Borne],
    efficiency: Option<Efficiency>,
    assembly: Option<&str>,
) -> Value {
    let variable = Variable::new(subject, case);
    let number = |value: f64| {
        if value.is_infinite() {
            json!("unbounded")
        } else {
            json!(Some(value).filter(|value| value.is_finite()))
        }
    };
    let one = |one: &Borne| {
        let [on, by] = &one.bodies;
        json!({
            "force": one.name, "on": on, "by": by, "unit": one.unit,
            "peak": number(one.peak), "at": number(variable.value(one.at)), "at_unit": variable.unit(),
            "rms": number(one.rms), "lowest": number(one.lowest), "rate": number(one.rate),
        })
    };
    let mut object = Map::new();
    if let Some(assembly) = assembly {
        object.insert("assembly".to_owned(), json!(assembly));
    }
    object.insert("forces".to_owned(), all.iter().map(one).collect());
    if let Some(mean) = efficiency {
        let powers = json!({ "input": mean.input, "heat": mean.heat, "ratio": ratio(mean), "unit": "W" });
        object.insert("efficiency".to_owned(), powers);
    }
    Value::Object(object)
}

/// The rows of a file, behind their head if they come first, each behind its assembly if there are several. With
/// friction, the mean of its heat stands in its row, and rows for the mean power of all drives and for the efficiency
/// follow.
fn csv(
    subject: &Subject,
    case: &Case,
    (all, efficiency): (&[Borne], Option<Efficiency>),
    assembly: Option<&str>,
    is_first: bool,
) -> String {
    let variable = Variable::new(subject, case);
    let number = |value: f64| {
        if value.is_nan() {
            String::new()
        } else {
            value.to_string()
        }
    };
    let at = format!("at [{}]", variable.unit());
    let head = [
        "force", "on", "by", "unit", "peak", &at, "rms", "lowest", "rate", "mean",
    ]
    .map(str::to_owned);
    let head = assembly
        .map(|_| "assembly".to_owned())
        .into_iter()
        .chain(head)
        .collect();
    let line = |words: [&str; 4], numbers: [f64; 6]| -> Vec<String> {
        let words = assembly.into_iter().chain(words).map(quoted);
        words.chain(numbers.map(number)).collect()
    };
    let row = |one: &Borne| {
        let [on, by] = &one.bodies;
        let mean = efficiency
            .filter(|_| one.name == HEAT)
            .map_or(f64::NAN, |mean| mean.heat);
        let numbers = [one.peak, variable.value(one.at), one.rms, one.lowest, one.rate, mean];
        line([&one.name, on, by, &one.unit], numbers)
    };
    let means = efficiency.into_iter().flat_map(|mean| {
        let ratio = ratio(mean).unwrap_or(f64::NAN);
        [("drives_power", "W", mean.input), ("efficiency", "", ratio)]
    });
    let only_mean = |mean: f64| core::array::from_fn(|column| if column == 5 { mean } else { f64::NAN });
    let means = means.map(|(name, unit, mean)| line([name, "", "", unit], only_mean(mean)));
    let lines = is_first
        .then_some(head)
        .into_iter()
        .chain(all.iter().map(row))
        .chain(means);
    lines.map(|cells: Vec<String>| cells.join(",") + "\n").collect()
}
