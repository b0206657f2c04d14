//! `kin peaks`: the extremes of every quantity and its rates.

use kin_core::Dimension;
use kin_core::any::Quantity;

use super::super::command::Peaks;
use super::super::progress::watched;
use super::super::text::{self, Column, Units};
use super::print;
use super::sweep::{headed, note_speed_jumps};
use crate::case::Case;
use crate::case::columns::columns_of;
use crate::case::columns::{self, label};
use crate::case::fault::Fault;
use crate::case::file::Settings;
use crate::case::loads::ForceColumn;
use crate::case::subject::{Extent, Subject};
use crate::forces::Reached;

/// The highest order of a rate that is shown.
const HIGHEST: usize = 4;

/// A quantity whose extremes are sought.
#[derive(Clone)]
struct Sought {
    name: String,
    unit: String,
    /// The factor from the mechanism's unit to this unit.
    size: f64,
    force: Option<ForceColumn>,
}

pub(super) fn run(subject: &Subject, options: &Peaks, settings: &Settings) -> Result<(), Fault> {
    let all = options.setup.typed(settings).each_assembly(subject);
    let (mut texts, mut cases) = (Vec::new(), Vec::new());
    for (assembly, typed) in &all {
        let case = typed.case(subject)?;
        if cases.is_empty() {
            note_speed_jumps(subject, &case)?;
        }
        let wanted = sought(subject, &case, options, settings)?;
        let forces = subject.forces_of(&case);
        let found: Result<Vec<Extent>, Fault> = watched("searching extremes", wanted.len(), |step| {
            wanted
                .iter()
                .map(|one| {
                    let extent = match (&one.force, &forces) {
                        (Some(force), Some(forces)) => forces.extent(force),
                        _ => subject.extent(&case, &one.name),
                    };
                    step();
                    extent
                })
                .collect()
        });
        texts.push(headed(assembly, all.len(), shown(subject, &case, &wanted, &found?)));
        cases.push(case);
    }
    print(&texts.join("\n"))?;
    cases.iter().try_for_each(|case| subject.closes(case))
}

/// The quantities that are sought: the columns of the file, or the names that were typed, where the name of a quantity
/// stands for all its rates.
fn sought(subject: &Subject, case: &Case, options: &Peaks, settings: &Settings) -> Result<Vec<Sought>, Fault> {
    let description = subject.description();
    let units = case.units();
    let highest = description.order.min(HIGHEST);
    let rates = |quantity: &Quantity<'_>| -> Vec<Sought> {
        let one = |order| Sought {
            name: label(quantity.name, order),
            unit: units.unit(quantity.dimension, order),
            size: units.value(quantity.dimension, 1.0),
            force: None,
        };
        (0..=highest).map(one).collect()
    };
    let results = description.unknowns.iter().chain(description.outputs);
    let force = |force: &ForceColumn| Sought {
        name: force.name(description),
        unit: force.unit(description),
        size: force.size(description, case.metres()),
        force: Some(force.clone()),
    };
    let columns_of_forces = case.forces(subject);
    let forces: Vec<Sought> = columns_of_forces.all.iter().map(force).collect();
    if options.of.is_empty() && !settings.columns.is_empty() {
        let names = columns_of(subject, &[], settings)?;
        let all: Vec<Sought> = description
            .inputs
            .iter()
            .chain(results.clone())
            .flat_map(rates)
            .collect();
        let all = || all.iter().chain(&forces);
        // inputs are sought only if the file names them
        let named = names
            .iter()
            .filter_map(|name| all().find(|one| one.name == *name).cloned());
        let named: Vec<Sought> = named.collect();
        if !named.is_empty() {
            return Ok(named);
        }
    }
    // forces in joints are sought only if they are named
    let efforts = columns_of_forces.efforts().map(force);
    let whole: Vec<Sought> = results.clone().flat_map(rates).chain(efforts).collect();
    if options.of.is_empty() || options.of.iter().any(|name| name == columns::ALL) {
        return Ok(whole);
    }
    let mut some = Vec::new();
    for name in &options.of {
        let of_quantity = results.clone().find(|quantity| quantity.name == name).map(rates);
        if let Some(rates) = of_quantity {
            some.extend(rates);
        } else {
            let all: Vec<Sought> = results.clone().flat_map(rates).chain(forces.clone()).collect();
            let names: Vec<String> = all.iter().map(|one| one.name.clone()).collect();
            let chosen = columns::named(name, &names);
            let chosen = chosen.map_err(|message| Fault::Wrong(columns_of_forces.advice(name).unwrap_or(message)))?;
            some.extend(all.iter().filter(|one| chosen.contains(&one.name.as_str())).cloned());
        }
    }
    Ok(some)
}

/// The form in which a position of the motion is shown: as an input, or as the time.
pub(super) struct Variable {
    units: Units,
    /// The dimension of the input; none for the time.
    input: Option<Dimension>,
}

impl Variable {
    pub(super) fn new(subject: &Subject, case: &Case) -> Self {
        let input = subject.description().inputs[case.lead].dimension;
        Self {
            units: case.units(),
            input: case.time_of_laws().is_none().then_some(input),
        }
    }

    pub(super) fn unit(&self) -> String {
        self.input.map_or("s".to_owned(), |input| self.units.unit(input, 0))
    }

    /// A position in its unit.
    pub(super) fn value(&self, at: f64) -> f64 {
        self.input.map_or(at, |input| self.units.value(input, at))
    }

    /// A position in words.
    pub(super) fn text(&self, at: f64, is_limit: bool) -> String {
        let value = match self.input {
            None => format!("{} s", text::digits(at)),
            Some(input) => self.units.text(input, 0, at),
        };
        format!("at {value}{}", if is_limit { ", a limit" } else { "" })
    }
}

fn shown(subject: &Subject, case: &Case, wanted: &[Sought], found: &[Extent]) -> String {
    let variable = Variable::new(subject, case);
    let value = |reached: &Reached, one: &Sought| match reached.value {
        None => "unbounded".to_owned(),
        Some(value) => text::digits(value * one.size),
    };
    let where_ = |reached: &Reached| variable.text(reached.at, reached.is_limit);
    let all = || wanted.iter().zip(found);
    let rms = all().map(|(one, extent)| match &extent.rms {
        Ok(mean) => text::digits(mean.value * one.size),
        Err(_) => "-".to_owned(),
    });
    let mut columns = vec![
        Column::words("quantity", wanted.iter().map(|one| one.name.clone()).collect()),
        Column::words("unit", wanted.iter().map(|one| one.unit.clone()).collect()),
        Column::numbers(
            "lowest",
            all().map(|(one, extent)| value(&extent.lowest, one)).collect(),
        ),
        Column::words("", all().map(|(_, extent)| where_(&extent.lowest)).collect()),
        Column::numbers(
            "highest",
            all().map(|(one, extent)| value(&extent.highest, one)).collect(),
        ),
        Column::words("", all().map(|(_, extent)| where_(&extent.highest)).collect()),
        Column::numbers("rms", rms.collect()),
    ];
    columns.truncate(text::fitting(&columns, text::width()));
    text::table(&columns) + &moves_at(subject, case)
}

/// The speed of the input, in a separate line; nothing under laws.
pub(super) fn moves_at(subject: &Subject, case: &Case) -> String {
    if case.time_of_laws().is_some() {
        return String::new();
    }
    let input = subject.description().inputs[case.lead];
    let speed = case.units().text(input.dimension, 1, case.speed());
    let is_back = case.motions[case.lead].end() < case.motions[case.lead].start();
    format!("{} moves at {}{speed}\n", input.name, if is_back { "-" } else { "" })
}
