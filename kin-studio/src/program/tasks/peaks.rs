//! `kin peaks`: the extremes of every quantity and its rates.

use std::fmt::Write as _;

use kin_core::any::Quantity;
use kin_core::{Dimension, RATES};

use super::super::case::Case;
use super::super::command::Peaks;
use super::super::fault::Fault;
use super::super::file::Told;
use super::super::progress::watched;
use super::super::subject::{Extent, Reached, Subject};
use super::super::text::{self, Column, Units};
use super::print;

/// The highest order of a rate that is shown.
const HIGHEST: usize = 4;

pub(super) fn run(subject: &Subject, options: &Peaks, told: &Told) -> Result<(), Fault> {
    let case = options.setup.typed(told).case(subject)?;
    let description = subject.description();
    let quantities: Vec<&Quantity<'_>> = description.unknowns.iter().chain(description.outputs).collect();
    let highest = description.order.min(HIGHEST);
    let whole: Vec<(String, Dimension, usize)> = quantities
        .iter()
        .flat_map(|quantity| (0..=highest).map(move |order| (label(quantity, order), quantity.dimension, order)))
        .collect();
    let wanted: Vec<_> = if options.of.is_empty() {
        whole
    } else {
        // the name of a quantity stands for all its rates
        let mut some = Vec::new();
        for name in &options.of {
            let of_quantity = quantities.iter().find(|quantity| quantity.name == name);
            let own: Vec<_> = whole
                .iter()
                .filter(|(label, ..)| {
                    label == name
                        || of_quantity
                            .is_some_and(|quantity| (0..=highest).any(|order| *label == self::label(quantity, order)))
                })
                .cloned()
                .collect();
            if own.is_empty() {
                let names = whole.iter().map(|(label, ..)| label.as_str());
                return Err(Fault::wrong(format!(
                    "there is no quantity `{name}`; {}",
                    super::super::fault::similar(name, names)
                )));
            }
            some.extend(own);
        }
        some
    };
    let found: Result<Vec<Extent>, Fault> = watched("searching extremes", wanted.len(), |step| {
        wanted
            .iter()
            .map(|(name, ..)| {
                let extent = subject.extent(&case, name);
                step();
                extent
            })
            .collect()
    });
    print(&shown(subject, &case, &wanted, &found?))?;
    subject.closes(&case)
}

fn label(quantity: &Quantity<'_>, order: usize) -> String {
    match order.checked_sub(1) {
        None => quantity.name.to_owned(),
        Some(rate) => format!("{}_{}", quantity.name, RATES[rate]),
    }
}

fn shown(subject: &Subject, case: &Case, wanted: &[(String, Dimension, usize)], found: &[Extent]) -> String {
    let units = Units {
        in_degrees: case.in_degrees,
        length: case.length,
    };
    let input = subject.description().inputs[case.lead];
    let is_over_time = case.time_of_laws().is_some();
    let place = |at: f64| {
        if is_over_time {
            format!("at {} s", text::digits(at))
        } else {
            format!("at {}", units.text(input.dimension, 0, at))
        }
    };
    let value = |reached: &Reached, dimension: Dimension| match reached.value {
        None => "unbounded".to_owned(),
        Some(value) => text::digits(units.value(dimension, value)),
    };
    let where_ = |reached: &Reached| {
        format!(
            "{}{}",
            place(reached.at),
            if reached.is_limit { ", a limit" } else { "" }
        )
    };
    let all = || wanted.iter().zip(found);
    let rms = all().map(|((_, dimension, _), extent)| match &extent.rms {
        Ok(mean) => text::digits(units.value(*dimension, mean.value)),
        Err(_) => "-".to_owned(),
    });
    let mut columns = vec![
        Column::words("quantity", wanted.iter().map(|(name, ..)| name.clone()).collect()),
        Column::words(
            "unit",
            wanted
                .iter()
                .map(|(_, dimension, order)| units.unit(*dimension, *order))
                .collect(),
        ),
        Column::numbers(
            "lowest",
            all().map(|((_, one, _), extent)| value(&extent.lowest, *one)).collect(),
        ),
        Column::words("", all().map(|(_, extent)| where_(&extent.lowest)).collect()),
        Column::numbers(
            "highest",
            all()
                .map(|((_, one, _), extent)| value(&extent.highest, *one))
                .collect(),
        ),
        Column::words("", all().map(|(_, extent)| where_(&extent.highest)).collect()),
        Column::numbers("rms", rms.collect()),
    ];
    columns.truncate(text::fitting(&columns, text::width()));
    let mut out = text::table(&columns);
    if !is_over_time {
        let speed = units.text(input.dimension, 1, case.speed());
        let sign = if case.motions[case.lead].end() < case.motions[case.lead].start() {
            "-"
        } else {
            ""
        };
        let _ = writeln!(out, "{} moves at {sign}{speed}", input.name);
    }
    out
}
