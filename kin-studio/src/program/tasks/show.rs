//! `kin show`: the quantities of a mechanism.

use std::fmt::Write as _;

use kin_core::Dimension;
use kin_core::any::Quantity;

use super::super::text::{self, Column, Units};
use super::print;
use crate::case::fault::Fault;
use crate::case::file::Settings;
use crate::case::subject::Subject;
use crate::case::{Known, Typed};

pub(super) fn run(subject: &Subject, settings: &Settings) -> Result<(), Fault> {
    print(&shown(subject, settings)?)
}

fn shown(subject: &Subject, settings: &Settings) -> Result<String, Fault> {
    let description = subject.description();
    let known = if *settings == Settings::default() {
        of_library(subject)
    } else {
        Some(of_file(subject, settings)?)
    };
    let units = Units {
        in_degrees: true,
        length: known.as_ref().map_or("", |known| known.length),
    };
    let mut out = format!("{}\n", description.name);
    let parameters = known
        .as_ref()
        .map(|known| known.parameters.iter().copied().map(Some).collect());
    let inputs = known.map(|known| known.inputs);
    for (head, quantities, values) in [
        ("dimensions", description.parameters, parameters),
        ("inputs", description.inputs, inputs),
        ("unknowns", description.unknowns, None),
        ("outputs", description.outputs, None),
    ] {
        if !quantities.is_empty() {
            let _ = write!(out, "\n{}", section(head, quantities, values, units));
        }
    }
    let formulas = subject.formulas();
    for (head, formula) in [
        ("equations", formulas.closure),
        ("equations of the outputs", formulas.outputs),
    ] {
        if !formula.text.is_empty() {
            let _ = write!(out, "\n{head}\n");
        }
        for line in formula.text.lines() {
            let _ = writeln!(out, "  {line}");
        }
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
    Ok(out)
}

/// The values of the library, which have no unit of length.
fn of_library(subject: &Subject) -> Option<Known> {
    subject.example().map(|example| Known {
        parameters: example.parameters.clone(),
        inputs: example.inputs.iter().copied().map(Some).collect(),
        length: "",
    })
}

/// The values of a file.
fn of_file(subject: &Subject, settings: &Settings) -> Result<Known, Fault> {
    Typed {
        set: settings.set.clone(),
        over: settings.over.clone(),
        assembly: settings.assembly.clone(),
        ..Typed::default()
    }
    .first_assembly(subject)
    .known(subject)
}

/// A line for each quantity, with its value if that is known.
fn section(head: &str, quantities: &[Quantity<'_>], values: Option<Vec<Option<f64>>>, units: Units) -> String {
    let mut columns = vec![
        Column::words("", vec![String::new(); quantities.len()]),
        Column::words("", quantities.iter().map(|one| one.name.to_owned()).collect()),
    ];
    if let Some(values) = values {
        let texts = quantities
            .iter()
            .zip(values)
            .map(|(one, value)| value.map_or_else(String::new, |value| units.text(one.dimension, 0, value)));
        columns.push(Column::words("", texts.collect()));
    }
    let kind = |one: &Quantity<'_>| match one.dimension {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::subject::Subject;
    use kin_core::library::{Pantograph, SliderCrank};

    /// The values of a file have its unit, and an input of which it says nothing has no value.
    #[test]
    fn a_file_needs_no_motion() {
        let set = ["upper=30mm", "lower=3cm", "factor=2", "y=-15mm"];
        let settings = Settings {
            set: set.map(str::to_owned).to_vec(),
            ..Settings::default()
        };
        let out = shown(&Subject::of::<Pantograph>(), &settings).unwrap();
        for line in [
            "upper   30 mm  length",
            "lower   30 mm  length",
            "y  -15 mm  length",
            "x          length",
        ] {
            assert!(out.contains(line), "{out}");
        }
        // what the file says of the assembly is compared with the mechanism as well
        for (assembly, is_one) in [("open", true), ("1", false)] {
            let assembly = Some(assembly.to_owned());
            let set = ["r=30mm", "l=80mm"].map(str::to_owned).to_vec();
            let settings = Settings {
                set,
                assembly,
                ..Settings::default()
            };
            assert_eq!(shown(&Subject::of::<SliderCrank>(), &settings).is_ok(), is_one);
        }
    }
}
