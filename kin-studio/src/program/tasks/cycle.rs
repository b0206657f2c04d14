//! `kin cycle`: all circuits and branches.

use std::fmt::Write as _;

use kin_core::cycle::{BlockClass, Branch, EndKind};
use kin_core::in_small_letters;

use super::super::command::Setup;
use super::super::progress::watched;
use super::super::text::{self, Column, Units};
use super::print;
use crate::case::fault::Fault;
use crate::case::file::Settings;
use crate::case::subject::Subject;

pub(super) fn run(subject: &Subject, setup: &Setup, settings: &Settings) -> Result<(), Fault> {
    // the cycle covers all values of the input in all assemblies
    let typed = setup.typed(settings).first_assembly(subject);
    let case = typed.case_without_range(subject, 0.0)?;
    let description = subject.description();
    let input = description.inputs[case.lead];
    let units = Units {
        in_degrees: case.in_degrees,
        length: case.length,
    };
    let found = watched("searching all circuits", 1, |_| subject.cycle(&case))?;
    let count = |number: usize, word: &str, words: &str| format!("{number} {}", if number == 1 { word } else { words });
    let mut out = format!(
        "{} over {}: {}, {}; {}\n",
        description.name,
        input.name,
        count(found.circuits().len(), "circuit", "circuits"),
        count(found.branches().len(), "branch", "branches"),
        if found.is_complete() {
            "there are no others".to_owned()
        } else {
            let reasons: Vec<String> = found.incomplete().iter().map(ToString::to_string).collect();
            format!("there may be others: {}", reasons.join(", and "))
        }
    );
    for (block, class) in subject.classes(&case) {
        let _ = writeln!(out, "{block}: {}", class_in_words(class));
    }
    if found.circuits().is_empty() {
        print(&subject.named(out))?;
        return Err(Fault::failed("the mechanism closes nowhere with these dimensions"));
    }
    let at = |value: f64| units.text(input.dimension, 0, value);
    let assemblies = subject.assemblies();
    for (index, circuit) in found.circuits().iter().enumerate() {
        let branches: Vec<&Branch> = circuit
            .branches()
            .iter()
            .map(|branch| &found.branches()[*branch])
            .collect();
        let full = branches.iter().all(|branch| branch.is_full_revolution());
        let word = if full {
            "the input goes round"
        } else {
            "the input swings"
        };
        let _ = writeln!(out, "\ncircuit {}: {word}", index + 1);
        let mut table = branch_columns(&branches, &assemblies, &at);
        indent(&mut table);
        out.push_str(&text::table(&table));
        let names = description.unknowns.iter().chain(description.outputs);
        let (mut strokes, mut without) = (Vec::new(), String::new());
        for quantity in names {
            match found.along(index).of(quantity.name).stroke() {
                Ok(stroke) => strokes.push((quantity, stroke)),
                Err(error) => {
                    let _ = writeln!(without, "  {}: {error}", quantity.name);
                }
            }
        }
        let column = |end: usize, is_input: bool| {
            let cells = strokes.iter().map(|(quantity, stroke)| {
                let end = [stroke.low, stroke.high][end];
                if is_input {
                    format!("at {}", at(end.input))
                } else {
                    units.text(quantity.dimension, 0, end.value)
                }
            });
            cells.collect::<Vec<_>>()
        };
        let mut table = vec![
            Column::words(
                "quantity",
                strokes.iter().map(|(quantity, _)| quantity.name.to_owned()).collect(),
            ),
            Column::numbers("lowest", column(0, false)),
            Column::words("", column(0, true)),
            Column::numbers("highest", column(1, false)),
            Column::words("", column(1, true)),
        ];
        indent(&mut table);
        out.push_str(&text::table(&table));
        out.push_str(&without);
        if let Ok(worst) = found.along(index).worst_transmission() {
            let angle = units.text(kin_core::Dimension::Angle, 0, worst.angle);
            let (input, block) = (at(worst.input), worst.block);
            let _ = writeln!(out, "  worst transmission angle {angle} at {input}, of {block}");
        }
    }
    print(&subject.named(out))
}

fn branch_columns(branches: &[&Branch], assemblies: &[String], at: &impl Fn(f64) -> String) -> Vec<Column> {
    let cells = |cell: &dyn Fn(&Branch) -> String| branches.iter().map(|branch| cell(branch)).collect::<Vec<_>>();
    // a full revolution has no ends
    let input = |branch: &Branch, side: usize| {
        if branch.is_full_revolution() {
            "-".to_owned()
        } else {
            at(branch.ends()[side].input)
        }
    };
    let kind = |branch: &Branch, side: usize| {
        if branch.is_full_revolution() && side == 0 {
            String::new()
        } else {
            end(branch.ends()[side].kind)
        }
    };
    let mut columns = vec![
        Column::numbers("from", cells(&|branch| input(branch, 0))),
        Column::words("", cells(&|branch| kind(branch, 0))),
        Column::numbers("to", cells(&|branch| input(branch, 1))),
        Column::words("", cells(&|branch| kind(branch, 1))),
    ];
    let names = cells(&|branch| {
        branch
            .assembly()
            .map_or_else(String::new, |index| assemblies[index].clone())
    });
    if names.iter().any(|name| !name.is_empty()) {
        columns.insert(0, Column::words("assembly", names));
    }
    columns
}

fn indent(columns: &mut [Column]) {
    if let Some(first) = columns.first_mut() {
        for text in first.head.iter_mut().chain(&mut first.cells) {
            text.insert_str(0, "  ");
        }
    }
}

fn end(kind: EndKind) -> String {
    match kind {
        EndKind::Limit(kind) => kind.to_string(),
        EndKind::Range => "end of the range".to_owned(),
        EndKind::FullRevolution => "full revolution".to_owned(),
        _ => "lost".to_owned(),
    }
}

/// The label of a block, as books write it.
fn class_in_words(class: BlockClass) -> String {
    match class {
        BlockClass::FourBar(class) => format!(
            "four-bar, {}, Barker's class {} ({})",
            words(&format!("{class:?}")),
            class.number(),
            class.symbol()
        ),
        BlockClass::SliderCrank(kind) => format!("slider-crank, {}", words(&format!("{kind:?}"))),
        BlockClass::InvertedSliderCrank(kind) => format!("inverted slider-crank, {}", words(&format!("{kind:?}"))),
        _ => String::new(),
    }
}

/// `CrankRocker` as `crank rocker`.
fn words(name: &str) -> String {
    in_small_letters(name, ' ')
}
