//! The reports of faults in the structure, each at the position of its cause.

use std::collections::BTreeSet;

use quote::ToTokens;

use crate::algebra::Misfit;
use crate::mistakes::Mistakes;
use crate::model::{Model, Origin, Request};
use crate::program::order_name;
use crate::room::with_room;
use crate::structure::{Block, Fault, Method, Structure, dyads};
use crate::syntax::Declaration;

/// Reports the reasons why a declaration cannot be solved.
pub(crate) fn faults(model: &Model, origins: &[Origin], faults: &[Fault], mistakes: &mut Mistakes) {
    let names = |unknowns: &[usize]| {
        list(unknowns.iter(), |&unknown| {
            format!("`{}`", model.unknowns[unknown].name)
        })
    };
    for fault in faults {
        match fault {
            &Fault::Cancels { unknown } => {
                let name = &model.unknowns[unknown].name;
                mistakes.error(
                    name,
                    format_args!("unknown `{name}` cancels out of every equation: nothing determines it"),
                );
            }
            &Fault::WithoutUnknown { equation } => mistakes.error(
                whole(model, origins[equation]),
                format_args!(
                    "every unknown cancels out of this {}, so it determines none: remove it",
                    origins[equation].part
                ),
            ),
            Fault::Underdetermined { unknowns, equations } => mistakes.error(
                &model.unknowns[unknowns[0]].name,
                format_args!(
                    "too few equations: {} {} determined by {} only; add {}, or make one of them an input ({})",
                    names(unknowns),
                    if unknowns.len() == 1 { "is" } else { "are" },
                    count(equations.len(), "scalar equation"),
                    count(unknowns.len() - equations.len(), "equation"),
                    mobility(model, origins),
                ),
            ),
            Fault::Overdetermined {
                unknowns,
                equations,
                surplus,
            } => {
                let together: BTreeSet<usize> = equations.iter().map(|&equation| origins[equation].equation).collect();
                for &surplus in surplus {
                    let origin = origins[surplus];
                    let others = together.iter().filter(|&&other| other != origin.equation);
                    let others = list(others, |&other| format!("`{}`", model.equations[other].text));
                    let beside = if others.is_empty() {
                        String::new()
                    } else {
                        format!(" beside {others}")
                    };
                    mistakes.error(
                        whole(model, origin),
                        format_args!(
                            "too many equations: {} for {} ({}); this {} is one too many{}: remove it, or declare \
                             the quantity that it determines as an unknown ({}; a plane equation counts as two, an \
                             equation in space as three){}",
                            count(equations.len(), "scalar equation"),
                            count(unknowns.len(), "unknown"),
                            names(unknowns),
                            origin.part,
                            beside,
                            mobility(model, origins),
                            model.equations[origin.equation].which(),
                        ),
                    );
                }
            }
            Fault::Dependent {
                unknowns,
                equations,
                repeats,
            } => match *repeats {
                Some((first, second)) => mistakes.error(
                    whole(model, origins[second]),
                    format_args!(
                        "this {} repeats that of `{}`, so {} {} not determined; replace it by an \
                         independent equation{}",
                        origins[second].part,
                        model.equations[origins[first].equation].text,
                        names(unknowns),
                        if unknowns.len() == 1 { "is" } else { "are" },
                        model.equations[origins[second].equation].which(),
                    ),
                ),
                None => mistakes.error(
                    whole(model, origins[*equations.last().expect("a block has equations")]),
                    format_args!(
                        "the equations for {} depend on each other and do not determine them; replace this one by an \
                         independent equation",
                        names(unknowns),
                    ),
                ),
            },
        }
    }
}

/// Reports that a declaration is too large to be derived in reasonable time, and how to make it smaller.
pub(crate) fn size(declaration: &Declaration, order: usize, mistakes: &mut Mistakes) {
    mistakes.error(
        &declaration.name,
        format_args!(
            "this mechanism is too large: its formulas have more than a million different terms at {}; ask for a lower \
             `order`, for fewer outputs or no sensitivities, or turn a `let` that many formulas contain into an \
             unknown with an equation of its own, so that it is differentiated once",
            order_name(order),
        ),
    );
}

/// Reports a constant of the equations that does not fit an `f64`. Its source is unknown, so the constant farthest from
/// 1 is underlined.
pub(crate) fn constants(declaration: &Declaration, model: &Model, misfit: Misfit, mistakes: &mut Mistakes) {
    let message =
        format!("constants that follow from this one are {misfit}: choose a unit in which the numbers are closer to 1");
    match model.extreme_constant {
        Some(extent) => mistakes.error(extent, message),
        None => mistakes.error(&declaration.name, message),
    }
}

/// Reports ranges of coupled unknowns. A range chooses one of two solutions, but coupled equations may have any number.
pub(crate) fn ranges(model: &Model, blocks: &[Block], mistakes: &mut Mistakes) {
    for part in blocks.iter().flat_map(|block| &block.parts) {
        if !matches!(part.method, Method::Newton { .. }) {
            continue;
        }
        for &unknown in &part.unknowns {
            let unknown_in_model = &model.unknowns[unknown];
            if let Some(range) = &unknown_in_model.range {
                mistakes.error(
                    &unknown_in_model.name,
                    format_args!(
                        "the range `{}` cannot choose the assembly of `{}`, which has no closed form: remove it, and \
                         choose the assembly by values near the position, as in `position_near(.., [..])`",
                        range.text, unknown_in_model.name,
                    ),
                );
            }
        }
    }
}

/// Reports requests for items that the mechanism does not have.
pub(crate) fn requests(model: &Model, structure: &Structure, mistakes: &mut Mistakes) {
    for requested in &model.requests {
        let has_dyads = || {
            let Structure {
                graph,
                residuals,
                blocks,
            } = structure;
            with_room(|| !dyads(&mut graph.clone(), residuals, blocks).is_empty())
        };
        if requested.request == Request::TransmissionAngles && !has_dyads() {
            mistakes.error(
                &requested.name,
                "the mechanism is not solved by dyads of two links, or of a link and a slider, so there is no \
                 transmission angle: write the closure as a loop of vectors, or remove this",
            );
        }
    }
}

/// The degrees of freedom that the equations leave, and the number of inputs that drive them.
fn mobility(model: &Model, origins: &[Origin]) -> String {
    let (unknowns, inputs, equations) = (model.unknowns.len(), model.inputs.len(), origins.len());
    let left = (unknowns + inputs).checked_sub(equations).map_or_else(
        || format!("-{}", equations - unknowns - inputs),
        |left| left.to_string(),
    );
    format!(
        "{} and {} less {} leave a mobility of {left}, to be driven by {}",
        count(unknowns, "unknown"),
        count(inputs, "input"),
        count(equations, "scalar equation"),
        count(inputs, "input"),
    )
}

fn whole(model: &Model, origin: Origin) -> impl ToTokens {
    &model.equations[origin.equation].tokens
}

/// The items of a list that are named. There may be as many lists of all names as there are names.
const MOST_LISTED: usize = 20;

/// `a`, `b` and `c`.
fn list<T>(mut all: impl Iterator<Item = T>, write: impl Fn(T) -> String) -> String {
    let mut items: Vec<String> = all.by_ref().take(MOST_LISTED).map(write).collect();
    let rest = all.count();
    if rest > 0 {
        items.push(count(rest, "other"));
    }
    match items.as_slice() {
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        _ => items.concat(),
    }
}

fn count(number: usize, noun: &str) -> String {
    match number {
        0 => format!("no {noun}"),
        1 => format!("1 {noun}"),
        _ => format!("{number} {noun}s"),
    }
}
