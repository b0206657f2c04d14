//! The page of the structure: its inputs, its blocks with their assemblies in words, and an example.

use super::documentation::unit;
use super::every;
use crate::emit::compiled::Compiled;
use crate::model::{Quantity, ValueShape};

/// The documentation that follows the user's.
pub(in crate::emit) fn lines(mechanism: &Compiled<'_>) -> Vec<String> {
    let has_choices = !mechanism.choices().is_empty();
    let title = if has_choices {
        " Blocks, in the order in which they are solved, with the meaning of an open assembly for positive lengths:"
    } else {
        " Blocks, in the order in which they are solved:"
    };
    let mut lines = vec![String::new()];
    lines.extend(inputs(mechanism));
    lines.extend([String::new(), title.to_owned()]);
    lines.extend(blocks(mechanism));
    lines.extend([String::new(), " # Example".to_owned(), " ```text".to_owned()]);
    lines.extend(example(mechanism).into_iter().map(|line| format!(" {line}")));
    lines.push(" ```".to_owned());
    lines
}

fn inputs(mechanism: &Compiled<'_>) -> Option<String> {
    (!mechanism.model.inputs.is_empty()).then(|| format!(" Inputs: {}.", mechanism.input_line()))
}

/// The blocks, each with the open assembly of its parts.
fn blocks(mechanism: &Compiled<'_>) -> Vec<String> {
    let choices = mechanism.choices();
    let mut first = 0;
    let mut lines = Vec::new();
    for block in mechanism.blocks {
        let mut line = format!(
            " - `{}`: {}",
            mechanism.names(&block.unknowns),
            mechanism.solution(block)
        );
        for part in (first..first + block.parts.len()).filter(|part| choices.contains(part)) {
            line += ". Open if ";
            line += &mechanism.open_in_words(part);
        }
        first += block.parts.len();
        lines.push(line);
    }
    lines
}

/// Make it, choose the assembly, solve, read.
fn example(mechanism: &Compiled<'_>) -> Vec<String> {
    let model = mechanism.model;
    let fields: Vec<String> = model
        .parameters
        .iter()
        .map(|parameter| match parameter.dimension.shape() {
            ValueShape::Plane => format!("{}: Plane::new(.., ..)", parameter.name),
            ValueShape::Space => format!("{}: Space::new(.., .., ..)", parameter.name),
            _ => format!("{}: ..", parameter.name),
        })
        .collect();
    let make = if fields.is_empty() {
        format!("let linkage = {}::<f64>::from_parameters([]);", model.name)
    } else {
        format!("let linkage = {} {{ {} }};", model.name, fields.join(", "))
    };
    let mut lines = vec![make];
    let names: Vec<String> = model.inputs.iter().map(|input| input.name.to_string()).collect();
    for Quantity { name, dimension, .. } in &model.inputs {
        lines.push(format!(
            "let {name} = Motion::at_constant_speed(1.0, 10.0); // {}, and its velocity",
            unit(*dimension)
        ));
    }
    let fields = mechanism.assembly_fields();
    let assembly = if mechanism.is_coupled() {
        lines.push(if every::is_found(mechanism) {
            let values: Vec<String> = names.iter().map(|name| format!("{name}.position()")).collect();
            format!(
                "let near = linkage.assemblies_at({})?[0]; // or values near the position",
                values.join(", ")
            )
        } else {
            format!(
                "let near = Near([{}]); // values near the position",
                mechanism.unknown_order()
            )
        });
        Some("near".to_owned())
    } else {
        match fields.as_slice() {
            [] => None,
            [_] => Some("Assembly::Open".to_owned()),
            [.., last] => {
                let name = mechanism.assembly_structure();
                lines.push(format!(
                    "let assembly = {name}::all(Assembly::Open).with_{last}(Assembly::Crossed);"
                ));
                Some("assembly".to_owned())
            }
        }
    };
    let arguments: Vec<String> = names.into_iter().chain(assembly).collect();
    lines.push(format!("let pose = linkage.solve({})?;", arguments.join(", ")));
    if let Some(unknown) = model.unknowns.last() {
        lines.push(format!("println!(\"{{}}\", pose.{}.velocity());", unknown.name));
    }
    lines
}
