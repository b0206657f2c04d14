//! Circuit, branch, order and closure of a design, by its full cycle.

use std::f64::consts::TAU;

use kin_core::cycle::{Branch, Cycle, FullCycle, Incomplete};
use kin_core::{Mechanism, Row};

use super::defect::Defect;
use super::figures::{self, Figures};
use crate::objective::{Design, Objective, Sense, Term, Travel, driver_turns, grashof};

/// The part of a turn by which targets may pass it as a whole: the rounding of a few sums of inputs.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The part of a branch from the first target to the last: where it begins, and the signed way from there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    pub(super) from: f64,
    pub(super) way: f64,
}

pub(super) fn check<M: Mechanism<Scalar = f64>>(
    objective: &Objective<M>,
    design: &Design<M>,
) -> Result<Figures, Defect> {
    let own = design.mechanism();
    let undecided = |reason: String| Defect::Undecided { reason };
    margins(objective, &own)?;
    let from = objective.inputs::<M>(0.0);
    let direction: M::Inputs<f64> = Row::from_fn(|index| if index == objective.moving { 1.0 } else { 0.0 });
    let cycle = own
        .cycle_along(from, direction)
        .map_err(|error| undecided(error.to_string()))?;
    if let Some((_, [low, high])) = cycle
        .undecided()
        .iter()
        .find(|(assembly, _)| *assembly == design.assembly)
    {
        return Err(undecided(format!(
            "the assembly between the inputs {low:.6} and {high:.6}"
        )));
    }
    if let Some(reason) = cycle
        .incomplete()
        .iter()
        .find(|reason| matches!(reason, Incomplete::Rounding { .. }))
    {
        return Err(undecided(reason.to_string()));
    }
    let inputs = objective.inputs_of(design);
    let places = one_branch(&cycle, design.assembly, &inputs)?;
    let index = places.branch;
    let branch = &cycle.branches()[index];
    let way = in_order(objective, branch, cycle.period(), &inputs, &places.turns)?;
    if objective.travel == Travel::Turn && !branch.is_full_turn() {
        return Err(Defect::Closure {
            input: branch.ends()[1].input,
        });
    }
    let figures = figures::figures(objective, design, &cycle, index, way).map_err(undecided)?;
    for term in &objective.terms {
        if let (Term::Transmission { floor, .. }, Some(least)) = (*term, figures.transmission)
            && least.value < floor
        {
            return Err(Defect::Transmission {
                angle: least.value,
                input: least.input,
                floor,
            });
        }
    }
    Ok(figures)
}

/// The first target at which a design does not close.
pub(super) fn first_open<M: Mechanism<Scalar = f64>>(objective: &Objective<M>, design: &Design<M>) -> Defect {
    let own = design.mechanism();
    let inputs = objective.inputs_of(design);
    let is_open = |input: &&f64| own.position(objective.inputs::<M>(**input), design.assembly).is_err();
    let open = inputs.iter().find(is_open).or(inputs.first());
    Defect::Closure {
        input: open.copied().unwrap_or(f64::NAN),
    }
}

/// Grashof's margin and that of the driver are positive where a term asks for them.
fn margins<M: Mechanism<Scalar = f64>>(objective: &Objective<M>, own: &M) -> Result<(), Defect> {
    let name = M::DESCRIPTION.inputs[objective.moving].name;
    for term in &objective.terms {
        for form in own.block_forms().as_ref() {
            let (name, margin) = match term {
                Term::Grashof { .. } => ("Grashof", grashof(form, name)),
                Term::DriverTurns { .. } => ("the driver", driver_turns(form, name)),
                _ => continue,
            };
            if let Some(margin) = margin
                && margin <= 0.0
            {
                return Err(Defect::Margin { term: name, margin });
            }
        }
    }
    Ok(())
}

/// The branch that holds all targets, and how many periods each input lies beyond the range of the branch.
struct Places {
    branch: usize,
    turns: Vec<f64>,
}

fn one_branch<M: Mechanism<Scalar = f64>>(
    cycle: &Cycle<M>,
    assembly: M::Assembly,
    inputs: &[f64],
) -> Result<Places, Defect> {
    let mut first: Option<(usize, usize)> = None;
    let mut turns = Vec::with_capacity(inputs.len());
    for (target, &input) in inputs.iter().enumerate() {
        let mut at = cycle
            .at(input)
            .filter(|(index, _)| cycle.assembly_of(*index) == Some(assembly));
        let Some((index, branch)) = at.next() else {
            return Err(Defect::Closure { input });
        };
        let circuit = branch.circuit();
        let (known, known_circuit) = *first.get_or_insert((index, circuit));
        let targets = [0, target];
        if circuit != known_circuit {
            return Err(Defect::Circuit {
                targets,
                circuits: [known_circuit, circuit],
            });
        }
        if index != known {
            return Err(Defect::Branch {
                targets,
                branches: [known, index],
            });
        }
        let period = cycle.period().unwrap_or(f64::INFINITY);
        turns.push(if period.is_finite() {
            ((input - branch.range().start()) / period).floor()
        } else {
            0.0
        });
    }
    Ok(Places {
        branch: first.map_or(0, |(index, _)| index),
        turns,
    })
}

/// Whether the targets follow each other in one direction of the input, within one turn and without leaving the branch.
fn in_order<M: Mechanism<Scalar = f64>>(
    objective: &Objective<M>,
    branch: &Branch,
    period: Option<f64>,
    inputs: &[f64],
    turns: &[f64],
) -> Result<Way, Defect> {
    let is_closed = branch.is_full_turn();
    let period = period.unwrap_or(TAU);
    if !is_closed && let Some(target) = (1..turns.len()).find(|target| turns[*target] != turns[target - 1]) {
        // The way between them leaves the branch.
        let [low, high] = branch.ends().map(|end| end.input);
        return Err(Defect::Closure {
            input: if turns[target] > turns[target - 1] { high } else { low },
        });
    }
    let way = |sense: f64| {
        let mut passed = 0.0;
        for target in 1..inputs.len() {
            let step = sense * (inputs[target] - inputs[target - 1]);
            let step = if is_closed { step.rem_euclid(period) } else { step };
            passed += step;
            // Two equal targets may be passed at once.
            let is_next = step > 0.0 || step == 0.0 && objective.targets[target] == objective.targets[target - 1];
            if !is_next || is_closed && passed > period * (1.0 + ROUNDING) {
                return Err(target);
            }
        }
        Ok(sense * passed)
    };
    let tried = match objective.sense {
        Sense::Forward => way(1.0),
        Sense::Backward => way(-1.0),
        Sense::Either => way(1.0).or_else(|first| way(-1.0).map_err(|other| other.max(first))),
    };
    match tried {
        Ok(way) => Ok(Way { from: inputs[0], way }),
        Err(target) => Err(Defect::Order {
            target,
            inputs: [inputs[target - 1], inputs[target]],
        }),
    }
}
