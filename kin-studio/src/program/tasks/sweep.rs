//! `kin sweep`: many poses as a table, CSV or JSON.

use std::fmt::Write as _;

use kin_core::batch::Outcome;
use kin_core::sweep::{ColumnOf, Table};

use super::super::command::Sweep;
use super::super::progress::watched;
use super::super::text::{self, Column};
use super::{print, write};
use crate::case::Case;
use crate::case::columns::columns_of;
use crate::case::fault::Fault;
use crate::case::file::Settings;
use crate::case::loads::ForceColumn;
use crate::case::subject::Subject;
use crate::forces::Force;
use crate::tables::{Columns, Export as _, quoted};

const ROWS_AS_TEXT: u32 = 13;
const ROWS_IN_A_FILE: u32 = 361;

pub(super) fn run(subject: &Subject, options: &Sweep, settings: &Settings) -> Result<(), Fault> {
    let is_text = options.csv.is_none() && options.json.is_none();
    let rows = options
        .rows
        .unwrap_or(if is_text { ROWS_AS_TEXT } else { ROWS_IN_A_FILE });
    let typed = options.setup.typed(settings);
    let wanted = columns_of(subject, &options.columns, settings)?;
    let all = typed.each_assembly(subject);
    let (mut tables, mut cases) = (Vec::new(), Vec::new());
    for (assembly, typed) in &all {
        let case = typed.case(subject)?;
        if cases.is_empty() {
            note_speed_jumps(subject, &case)?;
        }
        let table = watched("solving", 1, |_| table(subject, &case, rows as usize, &wanted))?;
        tables.push((assembly.as_str(), table));
        cases.push(case);
    }
    if let Some(path) = &options.csv {
        write(path, &csv(&tables, &wanted)?)?;
    } else if let Some(path) = &options.json {
        write(path, &subject.named(json(&tables, &wanted)?))?;
    } else {
        let shown: Result<Vec<String>, Fault> = tables
            .iter()
            .map(|(assembly, table)| Ok(headed(assembly, tables.len(), shown(table, &wanted)?)))
            .collect();
        print(&subject.named(shown?.join("\n")))?;
    }
    for ((_, table), case) in tables.iter().zip(&cases) {
        closes(table)?;
        subject.closes(case)?;
    }
    Ok(())
}

/// Prints where the efforts of masses have no bounds, which no row shows.
pub(super) fn note_speed_jumps(subject: &Subject, case: &Case) -> Result<(), Fault> {
    if case.loads.is_some() {
        for time in subject.speed_jumps(case)? {
            let time = text::digits(time);
            eprintln!("note: at {time} s the speed of an input jumps, where the effort of a mass has no bound");
        }
    }
    Ok(())
}

/// The text of one of several assemblies, below its name.
pub(super) fn headed(assembly: &str, count: usize, text: String) -> String {
    if count > 1 {
        format!("assembly {assembly}\n{text}")
    } else {
        text
    }
}

/// The table in the units that are shown, with the forces that are wanted. Those in joints are shown if they are named.
fn table(subject: &Subject, case: &Case, rows: usize, wanted: &[String]) -> Result<Table, Fault> {
    let mut table = in_units(subject.table(case, rows)?, case);
    let description = subject.description();
    let is_wanted = |force: &ForceColumn| {
        wanted.is_empty() && matches!(force.force, Force::Effort(_)) || wanted.contains(&force.name(description))
    };
    let mut forces = case.forces(subject).all;
    forces.retain(is_wanted);
    let columns = subject
        .forces_of(case)
        .map_or(Ok(Vec::new()), |loads| loads.columns(rows, &forces))?;
    for (force, values) in forces.iter().zip(columns) {
        table = table.with_column(&force.name(description), &force.unit(description), values);
    }
    Ok(table)
}

fn exported<'t>(table: &'t Table, wanted: &[String]) -> Result<Columns<'t>, Fault> {
    let all: Vec<String>;
    let names = if wanted.is_empty() {
        all = table.columns().map(|column| column.label.to_string()).collect();
        &all
    } else {
        wanted
    };
    Columns::named(table, names.iter().map(String::as_str)).map_err(Fault::wrong)
}

/// One table, or several below each other, whose rows begin with the assembly.
fn csv(tables: &[(&str, Table)], wanted: &[String]) -> Result<String, Fault> {
    if let [(_, table)] = tables {
        return Ok(exported(table, wanted)?.to_csv());
    }
    let mut text = String::new();
    for (assembly, table) in tables {
        for (index, line) in exported(table, wanted)?.to_csv().lines().enumerate() {
            match (index, text.is_empty()) {
                (0, true) => text.push_str("assembly"),
                (0, false) => continue,
                _ => text.push_str(&quoted(assembly)),
            }
            text.extend([",", line, "\n"]);
        }
    }
    Ok(text)
}

/// One table, or an array of them, each with its assembly.
fn json(tables: &[(&str, Table)], wanted: &[String]) -> Result<String, Fault> {
    if let [(_, table)] = tables {
        return Ok(exported(table, wanted)?.to_json());
    }
    let objects: Result<Vec<String>, Fault> = tables
        .iter()
        .map(|(assembly, table)| {
            let object = exported(table, wanted)?.to_json();
            // behind the brace that begins it
            let rest = object.get(1..).unwrap_or_default();
            Ok(format!("{{\"assembly\":{},{rest}", serde_json::json!(assembly)))
        })
        .collect();
    Ok(format!("[{}]", objects?.join(",")))
}

/// The table in the units that are shown.
fn in_units(table: Table, case: &Case) -> Table {
    let table = table.units(if case.length.is_empty() { "L" } else { case.length }, "s");
    if case.in_degrees { table.in_degrees() } else { table }
}

/// Rows that do not close are shown, and the code of the program reports them.
fn closes(table: &Table) -> Result<(), Fault> {
    let unclosed = table.rows().filter(|row| !row.outcome().is_solved()).count();
    if unclosed == 0 {
        return Ok(());
    }
    Err(Fault::failed(format!(
        "the mechanism does not close in {unclosed} of {} rows",
        table.count()
    )))
}

fn shown(table: &Table, names: &[String]) -> Result<String, Fault> {
    let variable = table.variable().label.to_string();
    let mut columns = vec![column(&table.variable())];
    let all = || table.columns().filter(|column| column.label.to_string() != variable);
    if names.is_empty() {
        for order in 0..=1 {
            columns.extend(
                all()
                    .filter(|column| column.label.order == order)
                    .map(|column_of| column(&column_of)),
            );
        }
    } else {
        for name in names {
            table.column(name).map_err(Fault::wrong)?;
            columns.extend(
                all()
                    .filter(|one| one.label.to_string() == *name)
                    .map(|column_of| column(&column_of)),
            );
        }
    }
    let outcomes: Vec<String> = table.rows().map(|row| outcome(table, row.index())).collect();
    let has_outcomes = outcomes.iter().any(|text| !text.is_empty());
    let outcomes = Column::words("", outcomes);
    let reserved = if has_outcomes { outcomes.width() + 2 } else { 0 };
    let count = columns.len();
    if names.is_empty() {
        columns.truncate(text::fitting(&columns, text::width().saturating_sub(reserved)));
    }
    let hidden = table.columns().count().saturating_sub(columns.len());
    let is_cut = columns.len() < count || names.is_empty();
    if has_outcomes {
        columns.push(outcomes);
    }
    let mut out = text::table(&columns);
    for limit in table.limits() {
        let unit = table.variable().unit.to_string();
        let side = if limit.closes_before { "up to" } else { "from" };
        let kind = limit.kind;
        let _ = writeln!(
            out,
            "closes {side} {variable} = {} {unit}: {kind} of {}",
            text::digits(limit.at),
            limit.block
        );
    }
    if hidden > 0 && is_cut {
        let _ = writeln!(
            out,
            "{hidden} more columns: `--columns NAMES` shows others, `--csv FILE` writes all"
        );
    }
    Ok(out)
}

fn column(column: &ColumnOf<'_>) -> Column {
    Column {
        head: vec![column.label.to_string(), column.unit.to_string()],
        cells: text::aligned(column.values),
        is_number: true,
    }
}

/// The reason why a row does not close; empty if it does.
fn outcome(table: &Table, row: usize) -> String {
    match (table.outcome(row), table.margin(row)) {
        (Some(outcome), _) if outcome.is_solved() => String::new(),
        (Some(Outcome::OutOfReach { .. }), Some(margin)) => format!("out of reach by {}", text::digits(-margin)),
        (Some(Outcome::Singular), _) => "singular".to_owned(),
        _ => "does not close".to_owned(),
    }
}
