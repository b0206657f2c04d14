//! `kin cycle`: all circuits and branches.

use std::fmt::Write as _;

use kin_core::cycle::{BlockClass, EndKind};

use super::super::command::Setup;
use super::super::fault::Fault;
use super::super::file::Told;
use super::super::progress::watched;
use super::super::subject::{CircuitOf, Subject};
use super::super::text::{self, Column, Units};
use super::print;

pub(super) fn run(subject: &dyn Subject, setup: &Setup, told: &Told) -> Result<(), Fault> {
    // the input passes all its values, wherever it begins
    let case = setup.typed(told).case_without_range(subject, 0.0)?;
    let description = subject.description();
    let input = description.inputs[case.lead];
    let units = Units {
        in_degrees: case.in_degrees,
        length: case.length,
    };
    let found = watched("searching all circuits", 1, |_| subject.cycle(&case))?;
    let branches: usize = found.circuits.iter().map(|circuit| circuit.branches.len()).sum();
    let count = |number: usize, word: &str, words: &str| format!("{number} {}", if number == 1 { word } else { words });
    let mut out = format!(
        "{} over {}: {}, {}; {}\n",
        description.name,
        input.name,
        count(found.circuits.len(), "circuit", "circuits"),
        count(branches, "branch", "branches"),
        if found.incomplete.is_empty() {
            "there are no others".to_owned()
        } else {
            format!("there may be others: {}", found.incomplete.join(", and "))
        }
    );
    for (block, class) in &found.classes {
        let _ = writeln!(out, "{block}: {}", class_in_words(*class));
    }
    if found.circuits.is_empty() {
        print(&out)?;
        return Err(Fault::open("the mechanism closes nowhere with these dimensions"));
    }
    let at = |value: f64| units.text(input.dimension, 0, value);
    for (index, circuit) in found.circuits.iter().enumerate() {
        let full = circuit
            .branches
            .iter()
            .all(|branch| branch.ends[0] == EndKind::FullTurn);
        let word = if full {
            "the input goes round"
        } else {
            "the input swings"
        };
        let _ = writeln!(out, "\ncircuit {}: {word}", index + 1);
        let mut table = branch_columns(circuit, &at);
        indent(&mut table);
        out.push_str(&text::table(&table));
        let names = description.unknowns.iter().chain(description.outputs);
        let strokes: Vec<_> = names
            .zip(&circuit.strokes)
            .filter_map(|(quantity, stroke)| Some((quantity, stroke.as_ref()?)))
            .collect();
        let column = |end: usize, is_place: bool| {
            let cells = strokes.iter().map(|(quantity, stroke)| {
                let (value, place) = stroke[end];
                if is_place {
                    format!("at {}", at(place))
                } else {
                    units.text(quantity.dimension, 0, value)
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
        if let Some((block, angle, place)) = circuit.transmission {
            let angle = units.text(kin_core::Dimension::Angle, 0, angle);
            let _ = writeln!(out, "  worst transmission angle {angle} at {}, of {block}", at(place));
        }
    }
    print(&out)
}

fn branch_columns(circuit: &CircuitOf, at: &impl Fn(f64) -> String) -> Vec<Column> {
    let cells = |cell: &dyn Fn(usize) -> String| (0..circuit.branches.len()).map(cell).collect::<Vec<_>>();
    let branch = |index: usize| &circuit.branches[index];
    // a full turn begins anywhere
    let is_turn = |index: usize| branch(index).ends[0] == EndKind::FullTurn;
    let place = |index: usize, side: usize| {
        if is_turn(index) {
            "-".to_owned()
        } else {
            at(branch(index).range[side])
        }
    };
    let kind = |index: usize, side: usize| {
        if is_turn(index) && side == 0 {
            String::new()
        } else {
            end(branch(index).ends[side]).to_owned()
        }
    };
    let mut columns = vec![
        Column::numbers("from", cells(&|index| place(index, 0))),
        Column::words("", cells(&|index| kind(index, 0))),
        Column::numbers("to", cells(&|index| place(index, 1))),
        Column::words("", cells(&|index| kind(index, 1))),
    ];
    let names = cells(&|index| branch(index).assembly.clone());
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

fn end(kind: EndKind) -> &'static str {
    match kind {
        EndKind::Limit => "limit",
        EndKind::ChangePoint => "change point",
        EndKind::Domain => "end of a domain",
        EndKind::Pole => "pole",
        EndKind::Range => "end of the range",
        EndKind::FullTurn => "full turn",
        _ => "lost",
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
    super::super::snake(name).replace('_', " ")
}
