//! `kin fit`: dimensions by least squares, from points of a path or from values of an unknown.

use std::fmt::Write as _;

use kin_core::Dimension;
use kin_core::any::{Description, Quantity};
use kin_fit::{Candidate, Deviation, Fit, FitError, Measured, Objective, usual_bounds};

use super::super::command::Fit as Options;
use super::super::progress::watched;
use super::super::text::{self, Column, Units};
use super::print;
use crate::case::Case;
use crate::case::fault::{Fault, similar};
use crate::case::file::Settings;
use crate::case::motion::InputMotion;
use crate::case::subject::Subject;
use crate::case::value::{self, Lengths};

pub(super) fn run(subject: &Subject, options: &Options, settings: &Settings) -> Result<(), Fault> {
    let typed = options.setup.typed(settings);
    let case = typed.case_without_range(subject, 0.0)?;
    let mut lengths = match case.length {
        "" => Lengths::default(),
        name => Lengths::named(name).map_err(Fault::Wrong)?,
    };
    let data = read(subject, options, &mut lengths)?;
    // a range is for the rows whose input is sought
    let case = match first_input(&data, case.lead) {
        Some(begin) => typed.case_without_range(subject, begin)?,
        None => typed.case(subject)?,
    };
    let fit = fit(subject, options, &case, &data, &mut lengths)?;
    let sought = fit.variables(fit.start()).len();
    if data.count() < sought {
        eprintln!(
            "note: {} numbers are given for {sought} that may change, so many linkages fit alike: vary fewer \
             dimensions",
            data.count()
        );
    }
    let fitted = watched("fitting", 1, |_| fit.least());
    print(&shown(subject, &case, &data, &fit, &fitted.design))?;
    // the code of the program states whether the numbers are met
    match fit.unclosed_rows(&fitted.design) {
        0 => {}
        unclosed => {
            return Err(Fault::failed(format!(
                "with what was found, the mechanism does not close in {unclosed} of {} rows",
                data.values.len()
            )));
        }
    }
    match fitted.lowering {
        None => Ok(()),
        Some((name, part)) => Err(Fault::failed(format!(
            "what was found is no minimum: a change of `{name}` alone takes away {:.2} % of the sum of squares. Fit \
             again from there with the `--set` above, or vary fewer dimensions",
            100.0 * part
        ))),
    }
}

/// The first value of an input that every row has.
fn first_input(data: &Measured, input: usize) -> Option<f64> {
    let all: Option<Vec<f64>> = data.inputs.iter().map(|row| row[input]).collect();
    all?.first().copied()
}

/// The fit with the bounds that were typed.
fn fit(
    subject: &Subject,
    options: &Options,
    case: &Case,
    data: &Measured,
    lengths: &mut Lengths,
) -> Result<Fit, Fault> {
    let description = subject.description();
    let varied = varied(description, &options.vary)?;
    let name = |index: usize| description.parameters[index].name;
    let of_dimension = |index: usize| usual_bounds(description, &case.parameters, index);
    let mut bounds: Vec<_> = varied.iter().map(|index| of_dimension(*index)).collect();
    for text in &options.within {
        let Some((wanted, range)) = text.split_once('=') else {
            return Err(Fault::wrong(format!(
                "`{text}` is no name with a range, as in `--within r2=10..50`"
            )));
        };
        let wanted = wanted.trim();
        let index = varied.iter().position(|index| name(*index) == wanted).ok_or_else(|| {
            let names = varied.iter().map(|index| name(*index));
            Fault::wrong(format!(
                "no dimension `{wanted}` may change; {}",
                similar(wanted, names)
            ))
        })?;
        let dimension = description.parameters[varied[index]].dimension;
        let (low, high) =
            value::range(dimension, range, lengths).map_err(|message| Fault::wrong(format!("{wanted}: {message}")))?;
        bounds[index] = low.min(high)..=low.max(high);
    }
    let standing: Vec<f64> = case.motions.iter().map(InputMotion::start).collect();
    let lead = &case.motions[case.lead];
    let range = match lead.stations().as_slice() {
        &[from, to] => [from, to],
        _ => lead.extent().into(),
    };
    let choice = subject.choice(case, &standing)?;
    let mut objective =
        Objective::measured(subject.fit_functions(), data, case.lead, &standing, range).map_err(Fault::wrong)?;
    for (index, bounds) in varied.into_iter().zip(bounds) {
        objective = objective.bounds(name(index), bounds).map_err(Fault::wrong)?;
    }
    let start = Candidate::with_parameters(case.parameters.clone(), choice);
    Fit::new(objective, &start).map_err(|error| match error {
        FitError::NothingCloses => Fault::failed(format!("{error}: give better ones by `--set`")),
        FitError::NoStart => Fault::failed(error),
        error => Fault::wrong(error),
    })
}

/// Reads the file of numbers.
fn read(subject: &Subject, options: &Options, lengths: &mut Lengths) -> Result<Measured, Fault> {
    let path = options.data.display();
    let text = std::fs::read_to_string(&options.data)
        .map_err(|error| Fault::wrong(format!("{path} cannot be read: {error}")))?;
    let description = subject.description();
    let names: Vec<&Quantity<'_>> = quantities(description);
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .flexible(true)
        .trim(csv::Trim::All)
        .from_reader(text.trim_start_matches('\u{feff}').as_bytes());
    let mut records = reader
        .records()
        .filter(|record| !record.as_ref().is_ok_and(|record| record.iter().all(str::is_empty)));
    let unread = |error: csv::Error| Fault::wrong(format!("{path} cannot be read: {error}"));
    let Some(head) = records.next().transpose().map_err(unread)? else {
        return Err(Fault::wrong(format!(
            "{path} is empty: its first line names the columns"
        )));
    };
    let mut columns = Vec::new();
    for cell in &head {
        let (name, unit) = match cell.split_once('[') {
            Some((name, unit)) => (name.trim(), unit.trim_end_matches(']').trim()),
            None => (cell, ""),
        };
        // a length without a unit, as a sweep writes it
        let unit = if unit == "L" { "" } else { unit };
        let input = description.inputs.iter().position(|input| input.name == name);
        let value = names.iter().position(|quantity| quantity.name == name);
        let role = match (input, value) {
            (Some(index), _) => Some((true, index, description.inputs[index].dimension)),
            (None, Some(index)) => Some((false, index, names[index].dimension)),
            // rates and remarks of a table that this program wrote
            _ if is_of_a_sweep(description, name) => None,
            _ => {
                let all = description
                    .inputs
                    .iter()
                    .chain(names.iter().copied())
                    .map(|one| one.name);
                return Err(Fault::wrong(format!(
                    "{path}: no quantity is called `{name}`; {}",
                    similar(name, all)
                )));
            }
        };
        if let Some((.., Dimension::Angle)) = role
            && unit.is_empty()
        {
            return Err(Fault::wrong(format!(
                "{path}: the angle `{name}` has no unit: name the column `{name} [deg]`"
            )));
        }
        columns.push(role.map(|role| (role, unit)));
    }
    let mut data = Measured {
        columns: columns
            .iter()
            .filter_map(|column| {
                column
                    .as_ref()
                    .and_then(|((is_input, index, _), _)| (!is_input).then_some(*index))
            })
            .collect(),
        inputs: Vec::new(),
        values: Vec::new(),
    };
    if data.columns.is_empty() {
        let first = names.first().map_or("theta4", |quantity| quantity.name);
        return Err(Fault::wrong(format!(
            "{path} has no column of an unknown or an output, such as `{first}`"
        )));
    }
    for record in records {
        let record = record.map_err(unread)?;
        let line = record.position().map_or(0, csv::Position::line);
        let (mut inputs, mut values) = (vec![None; description.inputs.len()], Vec::new());
        for (cell, column) in record.iter().chain(std::iter::repeat("")).zip(&columns) {
            let Some(((is_input, index, dimension), unit)) = column else {
                continue;
            };
            let number = if cell.is_empty() {
                None
            } else {
                let value = value::quantity(*dimension, &format!("{cell}{unit}"), lengths)
                    .map_err(|message| Fault::wrong(format!("{path}, line {line}: {message}")))?;
                Some(value)
            };
            if *is_input {
                inputs[*index] = number;
            } else {
                values.push(number);
            }
        }
        if values.iter().any(Option::is_some) {
            data.inputs.push(inputs);
            data.values.push(values);
        }
    }
    if data.values.is_empty() {
        return Err(Fault::wrong(format!(
            "{path} has no rows of numbers below the names of the columns"
        )));
    }
    Ok(data)
}

/// Whether a sweep writes a column of this name.
fn is_of_a_sweep(description: &Description<'_>, name: &str) -> bool {
    let all = description
        .inputs
        .iter()
        .chain(description.unknowns)
        .chain(description.outputs);
    let is_rate = |quantity: &Quantity<'_>| {
        name.strip_prefix(quantity.name)
            .is_some_and(|rest| rest.starts_with('_'))
    };
    ["outcome", "margin", "time", "row", ""].contains(&name) || all.into_iter().any(is_rate)
}

fn quantities<'d>(description: &'d Description<'d>) -> Vec<&'d Quantity<'d>> {
    description.unknowns.iter().chain(description.outputs).collect()
}

/// The dimensions, how far each column is from its values, and the dimensions as they are typed.
fn shown(subject: &Subject, case: &Case, data: &Measured, fit: &Fit, found: &kin_fit::Design) -> String {
    let description = subject.description();
    let units = Units {
        in_degrees: case.in_degrees,
        length: case.length,
    };
    let names = description.parameters.iter();
    let variables = fit.variables(fit.start());
    let sought: Vec<(usize, &Quantity<'_>, [f64; 2])> = names
        .enumerate()
        .filter_map(|(index, quantity)| {
            let (.., bounds) = variables.iter().find(|(name, ..)| name == quantity.name)?;
            Some((index, quantity, *bounds))
        })
        .collect();
    let column = |value: &dyn Fn(usize, [f64; 2]) -> f64| {
        let texts = sought.iter();
        texts
            .map(|(index, quantity, bounds)| units.text(quantity.dimension, 0, value(*index, *bounds)))
            .collect::<Vec<_>>()
    };
    let values = found.parameters();
    let remark = |(index, _, [low, high]): &(usize, &Quantity<'_>, [f64; 2])| {
        let value = values[*index];
        let is_at_bound = (value - low).min(high - value) < 1e-3 * (high - low);
        if is_at_bound { "at its bound" } else { "" }.to_owned()
    };
    let mut out = text::table(&[
        Column::words(
            "dimension",
            sought.iter().map(|(_, one, _)| one.name.to_owned()).collect(),
        ),
        Column::numbers("lowest", column(&|_, [low, _]| low)),
        Column::numbers("start", column(&|index, _| fit.start().parameters()[index])),
        Column::numbers("found", column(&|index, _| values[index])),
        Column::numbers("highest", column(&|_, [_, high]| high)),
        Column::words("", sought.iter().map(remark).collect()),
    ]);
    out.push('\n');
    let quantities = quantities(description);
    let deviations = fit.deviations(found).into_iter().zip(fit.deviations(fit.start()));
    for (column, (after, before)) in data.columns.iter().zip(deviations) {
        let quantity = quantities[*column];
        let deviation = |of_rows: Option<Deviation>| match of_rows {
            Some(Deviation {
                root_mean_square,
                count,
            }) => {
                let value = units.text(quantity.dimension, 0, root_mean_square);
                let rows = if count == 1 { "row" } else { "rows" };
                format!("by {value} in the mean of {count} {rows}")
            }
            None => "in no row, since none closes".to_owned(),
        };
        let _ = writeln!(
            out,
            "{}: deviates {}; at the start {}",
            quantity.name,
            deviation(after),
            deviation(before)
        );
    }
    let set = sought.iter().map(|(index, one, _)| {
        let value = values[*index];
        match one.dimension {
            Dimension::Angle => format!("--set {}={:?}deg", one.name, value.to_degrees()),
            Dimension::Length => format!("--set {}={value:?}{}", one.name, case.length),
            Dimension::Scalar => format!("--set {}={value:?}", one.name),
        }
    });
    let _ = writeln!(out, "\n{}", set.collect::<Vec<_>>().join(" "));
    out
}

/// The dimensions of these names; the name of a point stands for its coordinates.
fn varied(description: &Description<'_>, names: &[String]) -> Result<Vec<usize>, Fault> {
    let all = description.parameters.iter().enumerate();
    if names.is_empty() {
        return Ok(all.map(|(index, _)| index).collect());
    }
    let mut varied = Vec::new();
    for name in names {
        let point = format!("{name}.");
        let indices = all
            .clone()
            .filter(|(_, quantity)| quantity.name == name || quantity.name.starts_with(&point));
        let before = varied.len();
        varied.extend(indices.map(|(index, _)| index));
        if varied.len() == before {
            let names = description.parameters.iter().map(|quantity| quantity.name);
            return Err(Fault::wrong(format!(
                "there is no dimension `{name}`; {}",
                similar(name, names)
            )));
        }
    }
    varied.sort_unstable();
    varied.dedup();
    Ok(varied)
}
