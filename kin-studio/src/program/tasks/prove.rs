//! `kin forces --prove`: limits of forces over all inputs and tolerances.

use kin_core::reaction::{ForceProof, ForceVerdict, ProofError, UndecidedReason};

use super::super::progress::watched;
use super::super::text;
use super::peaks::Variable;
use crate::case::Case;
use crate::case::fault::{Fault, similar};
use crate::case::loads::ForceColumn;
use crate::case::subject::Subject;
use crate::case::value::{self, Lengths};

/// A limit of a force, as it was typed.
struct Limit<'t> {
    text: &'t str,
    column: ForceColumn,
    /// In units of the mechanism.
    value: f64,
}

/// What is proved of all limits, and whether all are.
pub(super) fn shown(
    subject: &Subject,
    case: &Case,
    limits: &[String],
    tolerances: &[String],
) -> Result<(String, bool), Fault> {
    let limits: Vec<Limit<'_>> = limits
        .iter()
        .map(|text| Limit::read(text, subject, case))
        .collect::<Result<_, _>>()?;
    let proved: Result<Vec<ForceVerdict>, Fault> = watched("proving limits", limits.len(), |step| {
        let verdicts = limits.iter().map(|limit| {
            let verdict = verdict(subject, case, limit, tolerances);
            step();
            verdict
        });
        verdicts.collect()
    });
    let proved = proved?;
    let lines = limits.iter().zip(&proved);
    let lines = lines.map(|(limit, verdict)| {
        let answer = answer(subject, case, limit, verdict);
        format!("{}: {answer}\n", limit.text.trim())
    });
    let holds = |verdict: &ForceVerdict| matches!(verdict, ForceVerdict::Holds { .. });
    Ok((lines.collect(), proved.iter().all(holds)))
}

impl<'t> Limit<'t> {
    fn read(text: &'t str, subject: &Subject, case: &Case) -> Result<Self, Fault> {
        let description = subject.description();
        let Some((name, limit)) = text.split_once("<=") else {
            return Err(Fault::wrong(format!(
                "`{text}` is not a limit of a force, as in `--prove 'knee_force <= 3kN'`"
            )));
        };
        let columns = case.forces(subject).all;
        let columns = columns
            .into_iter()
            .filter_map(|column| Some((column.kind(description)?, column)));
        let columns: Vec<_> = columns.collect();
        let is_own = |(_, column): &&(_, ForceColumn)| column.name(description) == name.trim();
        let Some((kind, column)) = columns.iter().find(is_own).cloned() else {
            let names: Vec<String> = columns.iter().map(|(_, column)| column.name(description)).collect();
            return Err(Fault::wrong(format!(
                "there is no force `{}`; {}",
                name.trim(),
                similar(name.trim(), names.iter().map(String::as_str))
            )));
        };
        let in_si = value::in_si(kind, limit.trim());
        let in_si = in_si.map_err(|message| Fault::wrong(format!("{}: {message}", name.trim())))?;
        Ok(Self {
            text,
            value: in_si / column.size(description, case.metres()),
            column,
        })
    }
}

/// The proof with all tolerances.
fn with_tolerances<'p>(
    mut proof: ForceProof<'p>,
    subject: &Subject,
    case: &Case,
    tolerances: &[String],
) -> Result<ForceProof<'p>, Fault> {
    let parameters = subject.description().parameters;
    let mut lengths = Lengths::named(case.length).unwrap_or_default();
    for text in tolerances {
        let Some((name, value)) = text.split_once('=') else {
            return Err(Fault::wrong(format!(
                "`{text}` is not a dimension with its tolerance, as in `--tolerance {text}=0.1mm`"
            )));
        };
        let name = name.trim();
        let Some(own) = parameters.iter().find(|parameter| parameter.name == name) else {
            let names = parameters.iter().map(|parameter| parameter.name);
            return Err(Fault::wrong(format!(
                "there is no dimension `{name}`; {}",
                similar(name, names)
            )));
        };
        let value = value::quantity(own.dimension, value, &mut lengths);
        let value = value.map_err(|message| Fault::wrong(format!("{name}: {message}")))?;
        proof = proof.tolerance(name, value).map_err(Fault::wrong)?;
    }
    Ok(proof)
}

fn verdict(subject: &Subject, case: &Case, limit: &Limit<'_>, tolerances: &[String]) -> Result<ForceVerdict, Fault> {
    let Some(forces) = subject.forces_of(case) else {
        return Err(Fault::wrong("forces come from loads, and there are none"));
    };
    let proved = forces.proof(|proof| {
        let force = limit.column.proven(with_tolerances(proof, subject, case, tolerances)?);
        let verdict = force.and_then(|force| force.below(limit.value));
        verdict.or_else(|error| match error {
            ProofError::Undecided(undecided) => Ok(ForceVerdict::Undecided(undecided)),
            error => Err(Fault::wrong(subject.named(error))),
        })
    });
    proved?
}

/// By so much a bound is rounded up or down before six digits of it are shown.
const ROUNDING: f64 = 5e-6;

/// A verdict in words.
fn answer(subject: &Subject, case: &Case, limit: &Limit<'_>, verdict: &ForceVerdict) -> String {
    let description = subject.description();
    let unit = limit.column.unit(description);
    let size = limit.column.size(description, case.metres());
    let number = |value: f64, rounding: f64| format!("{} {unit}", text::digits(value * size * (1.0 + rounding)));
    let variable = Variable::new(subject, case);
    match verdict {
        ForceVerdict::Holds { upper, pieces } => {
            format!("proved, it is at most {} ({pieces} pieces)", number(*upper, ROUNDING))
        }
        ForceVerdict::Fails(reached) => {
            let units = case.units();
            let own = description
                .parameters
                .iter()
                .zip(&case.parameters)
                .zip(&reached.dimensions);
            let changed = own.filter(|((_, own), reached)| own != reached);
            let changed: Vec<String> = changed
                .map(|((parameter, _), value)| {
                    format!("{} = {}", parameter.name, units.text(parameter.dimension, 0, *value))
                })
                .collect();
            let with = if changed.is_empty() { "" } else { ", with " };
            format!(
                "exceeded, it is at least {} {}{with}{}",
                number(reached.force, -ROUNDING),
                variable.text(reached.at, false),
                changed.join(", ")
            )
        }
        ForceVerdict::Undecided(undecided) => {
            let at = variable.text(undecided.range[0], false);
            match undecided.reason {
                UndecidedReason::Pose => format!(
                    "undecided, no pose is proved from {} on: there is a limit or a change point, or the tolerances \
                     reach one",
                    at.trim_start_matches("at ")
                ),
                _ => format!(
                    "undecided, it is at most {} {at} and reaches {} somewhere ({} pieces)",
                    number(undecided.force[1], ROUNDING),
                    number(undecided.force[0], -ROUNDING),
                    undecided.pieces
                ),
            }
        }
    }
}
