//! The whole program, by the cheapest of several ways to derive it.
//!
//! The equations are differentiated as typed and multiplied out, and the cheaper form with influence coefficients as well. Each way is
//! carried through to the scheduled program and its operations are counted; the cheapest way is kept.

mod candidate;
mod extras;
mod forms;
mod guards;
mod naming;
mod task;
mod telltales;
#[cfg(test)]
mod tests;

pub(crate) use task::Task;

use candidate::Candidate;
use forms::{Derived, Form, forms};

use crate::derive::{Influences, TooLarge};
use crate::passes::Pass;
use crate::program::{Solvers, Trial};

/// As many expressions as the largest declarations that compile in minutes have: some hundred thousand operations.
pub(crate) const MOST_EXPRESSIONS: usize = 1_000_000;

/// Tries both forms, and the cheaper one with influence coefficients, and keeps the cheapest.
///
/// # Errors
/// If the derivatives take too many expressions.
pub(crate) fn plan(task: &Task<'_>) -> Result<Solvers, TooLarge> {
    let mut trials = Vec::new();
    let forms = forms(task);
    let is_form_given_up = forms.iter().any(|form| form.formulas.is_given_up);
    let mut kept = None;
    for form in forms {
        let other = attempt(task, form, Influences::Separate, &mut trials)?;
        kept = Some(cheaper(kept, other));
    }
    let mut kept = kept.expect("there is at least one form");
    if task.passes.include(Pass::Influences) {
        let other = attempt(task, kept.1.form.clone(), Influences::Collected, &mut trials)?;
        kept = cheaper(Some(kept), other);
    }
    let (mut candidate, derived) = kept;
    if task.parameters > 0 {
        candidate = with_sensitivities(task, derived)?;
    }
    Ok(candidate.finish(task, trials, is_form_given_up))
}

/// One way, with the factors that terms share taken out if that is cheaper.
fn attempt(
    task: &Task<'_>,
    form: Form,
    influences: Influences,
    trials: &mut Vec<Trial>,
) -> Result<(Candidate, Derived), TooLarge> {
    let derived = Derived::new(task, form, influences)?;
    let mut candidate = Candidate::new(task, &derived, &[]);
    trials.push(candidate.trial());
    candidate.take_out_factors(task.passes);
    if candidate.way.takes_out_factors {
        trials.push(candidate.trial());
    }
    Ok((candidate, derived))
}

/// The cheaper of two ways, the first one if they cost the same.
fn cheaper(first: Option<(Candidate, Derived)>, second: (Candidate, Derived)) -> (Candidate, Derived) {
    match first {
        Some(first) if first.0.cost() <= second.0.cost() => first,
        _ => second,
    }
}

/// The program of the way that was kept, with the sensitivities after it.
fn with_sensitivities(task: &Task<'_>, mut derived: Derived) -> Result<Candidate, TooLarge> {
    let own = derived.form.task(task, derived.influences);
    let definitions = derived
        .derivatives
        .sensitivities(&mut derived.graph, own, task.parameters)?;
    let mut candidate = Candidate::new(task, &derived, &definitions);
    candidate.take_out_factors(task.passes);
    Ok(candidate)
}
