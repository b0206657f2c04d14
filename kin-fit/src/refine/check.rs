//! Circuit, branch, order and closure of a design, by its full cycle.

use std::f64::consts::TAU;

use kin_core::Number as _;
use kin_core::cycle::{Branch, Incomplete};
use kin_core::linkage::{AnyCycle, AnyLinkage};

use super::defect::Defect;
use super::figures::{self, Figures};
use crate::design::Design;
use crate::functions::Change;
use crate::margins::{driver_turns, grashof};
use crate::objective::Objective;
use crate::term::{Sense, Term, Travel};

/// The part of a revolution by which targets may exceed it: the rounding of a few sums of inputs.
const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The part of a branch from the first target to the last: where it begins, and the signed way from there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    pub(super) from: f64,
    pub(super) way: f64,
}

pub(super) fn check(objective: &Objective, design: &Design) -> Result<Figures, Defect> {
    let undecided = |reason: String| Defect::Undecided { reason };
    let Some(assembly) = design.choice.index() else {
        return Err(undecided("its assembly depends on the dimensions".to_owned()));
    };
    margins(objective, design)?;
    let from = objective.inputs_at(0.0);
    let mut direction = vec![0.0; from.len()];
    direction[objective.moving] = 1.0;
    let linkage = AnyLinkage::new(objective.functions, design.parameters());
    let cycle = linkage
        .cycle_along(&from, &direction)
        .map_err(|error| undecided(error.to_string()))?;
    let mut assemblies = cycle.undecided_assemblies().iter();
    if let Some((_, [low, high])) = assemblies.find(|(index, _)| *index == assembly) {
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
    let OneBranch { branch: index, periods } = one_branch(&cycle, assembly, &inputs)?;
    let branch = &cycle.branches()[index];
    let way = in_order(objective, branch, cycle.period(), &inputs, &periods)?;
    if objective.travel == Travel::Revolution && !branch.is_full_revolution() {
        return Err(Defect::Closure {
            input: branch.ends()[1].input,
        });
    }
    let figures = figures::figures(objective, &linkage, assembly, branch, index, way).map_err(undecided)?;
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
pub(super) fn first_unclosed(objective: &Objective, design: &Design) -> Defect {
    let inputs = objective.inputs_of(design);
    let posed = objective.posed(&design.values, &design.choice);
    let is_unclosed = |input: &&f64| posed.solve(objective.inputs(Change::constant(**input))).is_none();
    let unclosed = inputs.iter().find(is_unclosed).or(inputs.first());
    Defect::Closure {
        input: unclosed.copied().unwrap_or(f64::NAN),
    }
}

/// Grashof's margin and that of the driver are positive where a term asks for them.
fn margins(objective: &Objective, design: &Design) -> Result<(), Defect> {
    let name = objective.description().inputs[objective.moving].name;
    let forms = objective.posed(&design.values, &design.choice).forms();
    for term in &objective.terms {
        for form in &forms {
            let (name, margin) = match term {
                Term::Grashof { .. } => ("Grashof", grashof(form, name)),
                Term::DriverTurns { .. } => ("the driver", driver_turns(form, name)),
                _ => continue,
            };
            if let Some(margin) = margin
                && margin.value <= 0.0
            {
                let margin = margin.value;
                return Err(Defect::Margin { term: name, margin });
            }
        }
    }
    Ok(())
}

/// The branch that holds all targets, and how many periods each input lies beyond the range of the branch.
struct OneBranch {
    branch: usize,
    periods: Vec<f64>,
}

fn one_branch(cycle: &AnyCycle<'_>, assembly: usize, inputs: &[f64]) -> Result<OneBranch, Defect> {
    let mut first: Option<(usize, usize)> = None;
    let mut periods = Vec::with_capacity(inputs.len());
    for (target, &input) in inputs.iter().enumerate() {
        let mut at = cycle
            .at(input)
            .filter(|(_, branch)| branch.assembly() == Some(assembly));
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
        periods.push(if period.is_finite() {
            ((input - branch.range().start()) / period).floor()
        } else {
            0.0
        });
    }
    Ok(OneBranch {
        branch: first.map_or(0, |(index, _)| index),
        periods,
    })
}

/// Whether the targets follow each other in one direction of the input, within one revolution and on one branch.
fn in_order(
    objective: &Objective,
    branch: &Branch,
    period: Option<f64>,
    inputs: &[f64],
    periods: &[f64],
) -> Result<Way, Defect> {
    let is_closed = branch.is_full_revolution();
    let period = period.unwrap_or(TAU);
    if !is_closed && let Some(target) = (1..periods.len()).find(|target| periods[*target] != periods[target - 1]) {
        // The way between them leaves the branch.
        let [low, high] = branch.ends().map(|end| end.input);
        return Err(Defect::Closure {
            input: if periods[target] > periods[target - 1] {
                high
            } else {
                low
            },
        });
    }
    let way = |sense: f64| {
        let mut passed = 0.0;
        for target in 1..inputs.len() {
            let step = sense * (inputs[target] - inputs[target - 1]);
            let step = if is_closed { step.rem_euclid(period) } else { step };
            passed += step;
            // Two equal targets may be passed at once.
            let is_next =
                step > 0.0 || step == 0.0 && objective.targets[target].values == objective.targets[target - 1].values;
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
