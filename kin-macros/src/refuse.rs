//! What the structure's faults are called, each at the place of its cause.

use quote::ToTokens;

use crate::model::Model;
use crate::report::Report;
use crate::structure::Fault;

/// The declared equation that a scalar equation is a part of, and which part.
#[derive(Clone, Copy)]
pub(crate) struct Origin {
    pub(crate) equation: usize,
    pub(crate) part: &'static str,
}

/// Reports why a declaration cannot be solved.
pub(crate) fn refuse(model: &Model, origins: &[Origin], faults: &[Fault], report: &mut Report) {
    let names = |unknowns: &[usize]| -> String {
        list(
            unknowns
                .iter()
                .map(|&unknown| format!("`{}`", model.unknowns[unknown].name)),
        )
    };
    for fault in faults {
        match fault {
            Fault::Underdetermined { unknowns, equations } => report.error(
                &model.unknowns[unknowns[0]].name,
                format_args!(
                    "too few equations: {} {} determined by {} only; add {}, or make one of them an input",
                    names(unknowns),
                    if unknowns.len() == 1 { "is" } else { "are" },
                    count(equations.len(), "scalar equation"),
                    count(unknowns.len() - equations.len(), "equation"),
                ),
            ),
            Fault::Overdetermined {
                unknowns,
                equations,
                surplus,
            } => {
                let origin = origins[surplus[0]];
                report.error(
                    whole(model, origin),
                    format_args!(
                        "too many equations: {} for {} ({}); this {} is one too many: remove it, or declare what it \
                         determines as unknown (a plane equation counts as two)",
                        count(equations.len(), "scalar equation"),
                        count(unknowns.len(), "unknown"),
                        names(unknowns),
                        origin.part,
                    ),
                );
            }
            Fault::Dependent {
                unknowns,
                equations,
                repeats,
            } => match *repeats {
                Some((first, second)) => report.error(
                    whole(model, origins[second]),
                    format_args!(
                        "this {} says the same as that of `{}`, so {} {} not determined; replace it by an \
                         equation of its own",
                        origins[second].part,
                        model.equations[origins[first].equation].text,
                        names(unknowns),
                        if unknowns.len() == 1 { "is" } else { "are" },
                    ),
                ),
                None => report.error(
                    whole(model, origins[*equations.last().expect("a block has equations")]),
                    format_args!(
                        "the equations for {} depend on each other and do not determine them; replace this one by an \
                         equation of its own",
                        names(unknowns),
                    ),
                ),
            },
        }
    }
}

fn whole(model: &Model, origin: Origin) -> impl ToTokens {
    &model.equations[origin.equation].tokens
}

/// `a`, `b` and `c`.
fn list(items: impl Iterator<Item = String>) -> String {
    let items: Vec<String> = items.collect();
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
