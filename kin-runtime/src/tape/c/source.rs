//! The source of a solver in C: a function for each order, and one for all.

use std::collections::BTreeSet;
use std::format;
use std::string::String;
use std::vec::Vec;

use crate::tape::c::header::order_name;
use crate::tape::c::writer::CWriter;
use crate::tape::c::{Text, comment, quoted};
use crate::tape::runtime::{self, RuntimeParts};
use crate::tape::stages::Stages;
use crate::tape::structure::Tape;
use crate::tape::{Condition, TapeNode, TapeStep, Value};

/// The values that later orders take from earlier ones.
pub(super) struct Inherited {
    pub(super) values: Vec<Value>,
}

impl Inherited {
    pub(super) fn new(tape: &Tape<'_>) -> Self {
        let stages = Stages::new(tape);
        let mut values = BTreeSet::new();
        for order in 1..=tape.order {
            for value in taken(tape, &stages, order) {
                if is_carried(tape, value) && stages.of(value) < order {
                    values.insert(value);
                }
            }
        }
        Self {
            values: values.into_iter().collect(),
        }
    }

    /// The index of a value in the chain.
    pub(super) fn index_of(&self, value: Value) -> Option<usize> {
        self.values.binary_search(&value).ok()
    }
}

/// Whether a value is computed; arguments and constants are there anyway.
fn is_carried(tape: &Tape<'_>, value: Value) -> bool {
    !matches!(
        tape.nodes[value.index()],
        TapeNode::Argument(_) | TapeNode::Constant(_) | TapeNode::Certain(_) | TapeNode::Unknown { .. }
    )
}

/// The values that the steps of an order take, those of the order included.
pub(super) fn taken(tape: &Tape<'_>, stages: &Stages, order: usize) -> Vec<Value> {
    let mut values = Vec::new();
    let mut take = |value: Value| values.push(value);
    for step in tape.steps.iter().filter(|step| stages.of_step(tape, **step) == order) {
        match *step {
            TapeStep::Compute(value) => tape.nodes[value.index()].operands(&mut take),
            TapeStep::Check(index) => {
                let check = &tape.checks[index];
                if let Condition::Holds(truth) = check.condition {
                    take(truth);
                }
                for value in &check.cold {
                    tape.nodes[value.index()].operands(&mut take);
                }
                check.margin.iter().copied().for_each(&mut take);
            }
            TapeStep::Search(index) => given(tape, index).into_iter().for_each(&mut take),
            TapeStep::Factor(system) => tape.systems[system].rows.iter().flatten().copied().for_each(&mut take),
            TapeStep::Solve(solution) => {
                let solution = &tape.solutions[solution];
                solution.right.iter().copied().for_each(&mut take);
                tape.systems[solution.system]
                    .rows
                    .iter()
                    .flatten()
                    .copied()
                    .for_each(&mut take);
            }
        }
    }
    for result in tape
        .results
        .iter()
        .filter(|result| stages.of_order(result.order) == order)
    {
        take(result.value);
    }
    values
}

/// The values that a search takes from outside: guess, sizes, and what its body needs.
fn given(tape: &Tape<'_>, search: usize) -> Vec<Value> {
    let sought = &tape.searches[search];
    sought
        .guess
        .iter()
        .chain(&sought.sizes)
        .copied()
        .chain(tape.given(search))
        .collect()
}

pub(super) fn source(text: &Text<'_>) -> String {
    let (name, tape) = (&text.name, text.tape);
    let mut printed = text.head(&format!("{name}.c"));
    printed.push_str(&format!("#include \"{name}.h\"\n\n"));
    printed.push_str(&runtime::c(RuntimeParts::of(tape), tape.precision));
    let stages = Stages::new(tape);
    let carried = Inherited::new(tape);
    for search in 0..tape.searches.len() {
        printed.push('\n');
        printed.push_str(&equations(text, search));
    }
    if tape.order > 0 {
        for order in 0..=tape.order {
            printed.push('\n');
            printed.push_str(&format!(
                "{}\n{{\n{}}}\n",
                text.signature(&order_name(order), "chain"),
                CWriter::of_order(text, &stages, &carried, order).order("chain->pose.")
            ));
        }
    }
    printed.push('\n');
    let (stages, carried) = (Stages::one(tape), Inherited { values: Vec::new() });
    printed.push_str(&format!(
        "{}\n{{\n{}}}\n",
        text.signature("solve", "pose"),
        CWriter::of_order(text, &stages, &carried, 0).order("pose->")
    ));
    printed.push('\n');
    printed.push_str(&message(text));
    printed
}

fn message(text: &Text<'_>) -> String {
    let (name, upper) = (&text.name, &text.upper);
    let mut printed = format!("const char *{name}_message(int code)\n{{\n    switch (code) {{\n");
    printed.push_str(&format!(
        "    case {upper}_CLOSED:\n        return \"the mechanism closes\";\n"
    ));
    if text.choices().next().is_some() {
        printed.push_str(&format!(
            "    case {upper}_NO_ASSEMBLY:\n        return \"an assembly is neither 1 nor -1\";\n"
        ));
    }
    for (check, code) in text.tape.checks.iter().zip(&text.codes) {
        let words = quoted(&format!("{} ({})", check.name, text.tape.block_of(check)));
        printed.push_str(&format!("    case {code}:\n        return {words};\n"));
    }
    printed.push_str("    default:\n        return \"no such code\";\n    }\n}\n");
    printed
}

/// The residuals and the Jacobian of a search.
fn equations(text: &Text<'_>, search: usize) -> String {
    let number = text.number;
    let about = comment("", "The equations of a block and their partial derivatives.");
    let name = format!("{}_equations_{search}", text.name);
    let indent = " ".repeat("static void (".len() + name.len());
    format!(
        "{about}static void {name}(const void *given, const {number} *unknowns, {number} *residuals,\n{indent}{number} \
         jacobian[KIN_UNKNOWNS][KIN_UNKNOWNS])\n{{\n{}}}\n",
        CWriter::of_search(text, search).equations(search)
    )
}
