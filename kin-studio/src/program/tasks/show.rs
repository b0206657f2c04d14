//! `kin show`: the quantities of a mechanism.

use std::fmt::Write as _;

use kin_core::{Dimension, Quantity};

use super::super::case::Typed;
use super::super::fault::Fault;
use super::super::file::Told;
use super::super::motion::InputMotion;
use super::super::subject::{Example, Subject};
use super::super::text::{self, Column, Units};
use super::print;

pub(super) fn run(subject: &dyn Subject, told: &Told) -> Result<(), Fault> {
    let description = subject.description();
    let example = if told.set.is_empty() {
        subject.example()
    } else {
        Some(of_file(subject, told)?)
    };
    let mut out = format!("{}\n", description.name);
    let values = |of: fn(&Example) -> &Vec<f64>| example.as_ref().map(of);
    for (head, quantities, values) in [
        (
            "dimensions",
            description.parameters,
            values(|example| &example.parameters),
        ),
        ("inputs", description.inputs, values(|example| &example.inputs)),
        ("unknowns", description.unknowns, None),
        ("outputs", description.outputs, None),
    ] {
        if !quantities.is_empty() {
            let _ = write!(out, "\n{}", section(head, quantities, values));
        }
    }
    out.push_str("\nequations\n");
    for equation in description.equations {
        let _ = writeln!(out, "  {equation}");
    }
    out.push_str("\nsolution\n");
    for block in description.blocks {
        let _ = writeln!(out, "  {}: {}", block.unknowns, block.solution);
    }
    let assemblies = subject.assemblies();
    match assemblies.as_slice() {
        [] => out.push_str("\nassemblies: as many as the dimensions allow, chosen by values of the unknowns nearby\n"),
        [_] => {}
        names => {
            out.push_str("\nassemblies\n");
            for name in names {
                let _ = writeln!(out, "  {name}");
            }
        }
    }
    print(&out)
}

/// The values of a file.
fn of_file(subject: &dyn Subject, told: &Told) -> Result<Example, Fault> {
    let case = Typed {
        set: told.set.clone(),
        over: told.over.clone(),
        assembly: told.assembly.clone(),
        ..Typed::default()
    }
    .case(subject)?;
    Ok(Example {
        parameters: case.parameters,
        inputs: case.motions.iter().map(InputMotion::start).collect(),
        assembly: case.assembly,
    })
}

fn section(head: &str, quantities: &[Quantity], values: Option<&Vec<f64>>) -> String {
    let units = Units {
        in_degrees: true,
        length: "",
    };
    let mut columns = vec![
        Column::words("", vec![String::new(); quantities.len()]),
        Column::words("", quantities.iter().map(|one| one.name.to_owned()).collect()),
    ];
    if let Some(values) = values {
        let texts = quantities
            .iter()
            .zip(values)
            .map(|(one, value)| units.text(one.dimension, 0, *value));
        columns.push(Column::words("", texts.collect()));
    }
    let kind = |one: &Quantity| match one.dimension {
        Dimension::Length => "length",
        Dimension::Angle => "angle",
        Dimension::Scalar => "number",
    };
    columns.push(Column::words(
        "",
        quantities.iter().map(|one| kind(one).to_owned()).collect(),
    ));
    let used: usize = columns.iter().map(|column| column.width() + 2).sum();
    let room = text::width().saturating_sub(used);
    let words = quantities.iter().map(|one| shortened(one.description, room));
    columns.push(Column::words("", words.collect()));
    for column in &mut columns {
        column.head.clear();
    }
    format!("{head}\n{}", text::table(&columns))
}

/// A text that fits.
fn shortened(text: &str, room: usize) -> String {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    if text.chars().count() <= room {
        text
    } else {
        let kept: String = text.chars().take(room.saturating_sub(1)).collect();
        format!("{}…", kept.trim_end())
    }
}
