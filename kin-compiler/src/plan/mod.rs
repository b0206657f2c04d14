//! The whole program, by the cheapest of several ways to derive it.
//!
//! The equations are differentiated as typed and multiplied out, and the cheaper form also with influence coefficients.
//! Each way is carried through to the scheduled program, whose operations are counted. The cheapest way is kept.

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
use forms::{Derived, EquationForm, forms};

use crate::derive::{Influences, TooLarge};
use crate::passes::Pass;
use crate::program::{Solvers, Trial};

/// The largest number of expressions. The largest declarations that compile within minutes have as many, and some
/// hundred thousand operations.
pub(crate) const MOST_EXPRESSIONS: usize = 1_000_000;

/// Tries both forms, and the cheaper form with influence coefficients, and keeps the cheapest way.
///
/// # Errors
/// Returns an error if the derivatives take too many expressions.
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

/// One way to derive the program. Shared factors are taken out if that is cheaper.
fn attempt(
    task: &Task<'_>,
    form: EquationForm,
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

/// The cheaper of two ways, the first one if the costs are equal.
fn cheaper(first: Option<(Candidate, Derived)>, second: (Candidate, Derived)) -> (Candidate, Derived) {
    match first {
        Some(first) if first.0.cost() <= second.0.cost() => first,
        _ => second,
    }
}

/// The program of the best way, with the sensitivities after it.
fn with_sensitivities(task: &Task<'_>, mut derived: Derived) -> Result<Candidate, TooLarge> {
    let form_task = derived.form.task(task, derived.influences);
    let definitions = derived
        .derivatives
        .sensitivities(&mut derived.graph, form_task, task.parameters)?;
    let mut candidate = Candidate::new(task, &derived, &definitions);
    candidate.take_out_factors(task.passes);
    Ok(candidate)
}
