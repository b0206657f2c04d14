//! The list of assemblies, and the argument of the solver for each.

use std::collections::{BTreeMap, BTreeSet};

use kin_core::any::AssemblyChoice;
use kin_core::linkage::{AnyCycle, AnyLinkage};

use super::shown::{ShownAssembly, between_values, distance, part_in, samples};
use super::solver::Solver;
use crate::names::symbol;
use crate::report::model::{Argument, Assembly};

/// Positions that differ less are the same: radians, or parts of a length.
const SAME: f64 = 1e-6;

/// All assemblies along a line that close somewhere, and the index of the shown assembly.
pub(super) fn on_line(
    solver: &Solver,
    cycle: &AnyCycle<'_>,
    shown_assembly: &ShownAssembly,
    range: [f64; 2],
) -> (Vec<Assembly>, usize) {
    if let Some(shown) = shown_assembly.assembly.index() {
        let circuit = |number: usize| {
            let mut branches = cycle.branches().iter();
            let branch = branches.find(|branch| branch.assembly() == Some(number));
            branch.map(kin_core::cycle::Branch::circuit)
        };
        return numbered(solver, &numbers(cycle, shown), shown, &circuit);
    }
    let mut all: Vec<Assembly> = Vec::new();
    let shown = shown(cycle, shown_assembly, range);
    for &index in &shown {
        let branch = &cycle.branches()[index];
        let ([low, high], periods) = part_in(cycle, branch, range).unwrap_or((branch.ends().map(|end| end.input), 0.0));
        let at = between_values(low, high);
        // a branch is at least known by its samples
        let found = cycle.position_on(index, at - periods);
        let (sample, unknowns) = &branch.samples()[branch.samples().len() / 2];
        let (at, unknowns) = match &found {
            Ok(unknowns) => (at, unknowns.as_slice()),
            Err(_) => (*sample, unknowns.as_slice()),
        };
        all.push(near(solver, at, unknowns, index + 1, Some(branch.circuit())));
    }
    let first = shown_assembly.branches.first();
    let index = first.and_then(|first| shown.iter().position(|index| index == first));
    let index = index.unwrap_or_else(|| {
        let (at, unknowns) = &shown_assembly.start;
        all.push(near(solver, *at, unknowns, all.len() + 1, None));
        all.len() - 1
    });
    (all, index)
}

/// All assemblies under laws that close somewhere, and the index of the shown assembly. Those of coupled blocks are the
/// positions where the laws begin. `inputs` gives the inputs at a time.
pub(super) fn under_laws(
    solver: &Solver,
    linkage: &AnyLinkage<'_>,
    shown_assembly: &ShownAssembly,
    range: [f64; 2],
    inputs: &dyn Fn(f64) -> Vec<f64>,
) -> (Vec<Assembly>, usize) {
    if let Some(shown) = shown_assembly.assembly.index() {
        let samples: Vec<Vec<f64>> = samples(range).into_iter().map(inputs).collect();
        let closes = |number: &usize| {
            let choice = AssemblyChoice::Index(*number);
            let mut samples = samples.iter();
            *number == shown || samples.any(|inputs| linkage.position(inputs, choice.position()).is_ok())
        };
        let numbers: Vec<usize> = (0..linkage.assembly_count()).filter(closes).collect();
        return numbered(solver, &numbers, shown, &|_| None);
    }
    let (at, unknowns) = &shown_assembly.start;
    let description = linkage.description();
    // the search answers for the other assemblies alone: the shown assembly is known
    let others = linkage.positions_at(&inputs(*at)).map(|(all, _)| all);
    let is_other = |position: &Vec<f64>| distance(description, position, unknowns) > SAME;
    let others = others.unwrap_or_default().into_iter().filter(is_other);
    let positions = std::iter::once(unknowns.clone()).chain(others);
    let all = positions
        .enumerate()
        .map(|(index, position)| near(solver, *at, &position, index + 1, None));
    (all.collect(), 0)
}

/// The assemblies of closed forms by their numbers, and the index of the one that is shown.
fn numbered(
    solver: &Solver,
    numbers: &[usize],
    shown: usize,
    circuit: &dyn Fn(usize) -> Option<usize>,
) -> (Vec<Assembly>, usize) {
    let entry = |number: &usize| Assembly {
        name: name(&solver.assemblies, *number),
        argument: argument(&solver.assemblies, *number),
        at: None,
        circuit: circuit(*number),
    };
    let index = numbers.iter().position(|number| *number == shown);
    (numbers.iter().map(entry).collect(), index.unwrap_or(0))
}

/// An assembly of a coupled block, by values nearby.
fn near(solver: &Solver, at: f64, unknowns: &[f64], number: usize, circuit: Option<usize>) -> Assembly {
    Assembly {
        name: format!("assembly {number}"),
        argument: Argument::Several(solver.near.iter().cloned().zip(unknowns.iter().copied()).collect()),
        at: Some(at),
        circuit,
    }
}

/// The index of the assembly to which a branch belongs, if it is listed.
pub(super) fn of_branch(
    cycle: &AnyCycle<'_>,
    shown_assembly: &ShownAssembly,
    range: [f64; 2],
    branch: usize,
) -> Option<usize> {
    let Some(index) = shown_assembly.assembly.index() else {
        return shown(cycle, shown_assembly, range)
            .iter()
            .position(|index| *index == branch);
    };
    let assembly = cycle.branches()[branch].assembly();
    let mut numbers = numbers(cycle, index).into_iter();
    numbers.position(|number| assembly == Some(number))
}

/// The branches of which a part lies in the range, and the branch of the shown assembly. An assembly of another branch
/// would show the numbers of the branch to which Newton's method goes from values nearby.
fn shown(cycle: &AnyCycle<'_>, shown_assembly: &ShownAssembly, range: [f64; 2]) -> Vec<usize> {
    let is_of_shown = |index: usize| shown_assembly.branches.first() == Some(&index);
    let branches = cycle.branches().iter().enumerate();
    branches
        .filter(|(index, branch)| is_of_shown(*index) || part_in(cycle, branch, range).is_some())
        .map(|(index, _)| index)
        .collect()
}

/// The numbers of the assemblies that close somewhere, and of the shown assembly.
fn numbers(cycle: &AnyCycle<'_>, shown: usize) -> Vec<usize> {
    let closing = cycle.branches().iter().filter_map(kin_core::cycle::Branch::assembly);
    let numbers: BTreeSet<usize> = closing.chain([shown]).collect();
    numbers.into_iter().collect()
}

/// Whether each choice of the assembly with this number is crossed: the bits of the number, the first choice first.
fn crossed(choices: &[String], number: usize) -> impl Iterator<Item = (&String, bool)> {
    let last = choices.len();
    let choices = choices.iter().enumerate();
    choices.map(move |(choice, name)| (name, (number >> (last - 1 - choice)) & 1 == 1))
}

fn argument(choices: &[String], number: usize) -> Argument {
    let sign = |is_crossed: bool| if is_crossed { -1.0 } else { 1.0 };
    match choices {
        [] => Argument::One(1.0),
        [_] => Argument::One(sign(number == 1)),
        several => {
            let signs = crossed(several, number).map(|(name, is_crossed)| (name.clone(), sign(is_crossed)));
            Argument::Several(signs.collect::<BTreeMap<_, _>>())
        }
    }
}

fn name(choices: &[String], number: usize) -> String {
    let blocks = |wanted: bool| {
        let blocks = crossed(choices, number).filter(move |(_, is_crossed)| *is_crossed == wanted);
        blocks
            .map(|(name, _)| {
                let unknowns: Vec<String> = name.split('_').map(symbol).collect();
                unknowns.join(" ")
            })
            .collect::<Vec<_>>()
    };
    let (open, crossed) = (blocks(false), blocks(true));
    match (choices, open.as_slice(), crossed.as_slice()) {
        ([], ..) => "the only assembly".to_owned(),
        ([_], [_], _) => "open".to_owned(),
        ([_], ..) => "crossed".to_owned(),
        (_, _, []) => "all open".to_owned(),
        (_, [], _) => "all crossed".to_owned(),
        (_, open, crossed) if crossed.len() <= open.len() => format!("open but {}", crossed.join(", ")),
        (_, open, _) => format!("crossed but {}", open.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::{argument, name};
    use crate::report::model::Argument;

    #[test]
    fn choices_are_the_bits_of_the_number() {
        let choices = ["theta3_theta4", "phi", "x"].map(String::from);
        let Argument::Several(signs) = argument(&choices, 0b011) else {
            panic!("there are three choices");
        };
        assert_eq!((signs["theta3_theta4"], signs["phi"], signs["x"]), (1.0, -1.0, -1.0));
        for (number, text) in [
            (0, "all open"),
            (7, "all crossed"),
            (0b100, "open but θ₃ θ₄"),
            (0b011, "crossed but θ₃ θ₄"),
        ] {
            assert_eq!(name(&choices, number), text);
        }
        assert_eq!(argument(&choices[..1], 1), Argument::One(-1.0));
    }
}
