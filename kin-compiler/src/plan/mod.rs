//! The whole program, by the cheapest of several ways to derive it.
//!
//! The equations are differentiated multiplied out and with their products left, and both with and without influence
//! coefficients. Each way is carried through to the scheduled program, whose operations are counted. The cheapest way
//! is kept.

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
use forms::{Derived, forms};

use crate::derive::{Influences, TooLarge};
use crate::passes::Pass;
use crate::program::Solvers;

/// The largest number of expressions. The largest declarations that compile within minutes have as many, and some
/// hundred thousand operations.
pub(crate) const MOST_EXPRESSIONS: usize = 1_000_000;

/// Tries both forms with and without influence coefficients, and keeps the cheapest way.
///
/// # Errors
/// Returns an error if the derivatives take too many expressions.
pub(crate) fn plan(task: &Task<'_>) -> Result<Solvers, TooLarge> {
    let forms = forms(task);
    let is_form_given_up = forms.iter().any(|form| form.formulas.is_given_up);
    let mut trials = Vec::new();
    let mut candidates = Vec::new();
    let influences: &[Influences] = if task.passes.include(Pass::Influences) {
        &[Influences::Separate, Influences::Collected]
    } else {
        &[Influences::Separate]
    };
    for form in forms {
        for &influences in influences {
            let derived = Derived::new(task, form.clone(), influences)?;
            let candidate = Candidate::new(task, &derived, &[]);
            trials.push(candidate.trial());
            candidates.push((candidate, derived));
        }
    }
    let cost = |(candidate, _): &(Candidate, Derived)| candidate.cost();
    let least = candidates.iter().map(cost).min().unwrap_or_default();
    // a way that costs a twenty-fifth more has never become the cheapest by leaving its shared factors
    candidates.retain(|candidate| cost(candidate) <= least + least / 25);
    for (candidate, _) in &mut candidates {
        if candidate.leave_factors(task.passes) {
            trials.push(candidate.trial());
        }
    }
    let (mut candidate, derived) = candidates.into_iter().min_by_key(cost).expect("there is a way");
    if task.parameters > 0 {
        candidate = with_sensitivities(task, derived)?;
    }
    Ok(candidate.finish(task, trials, is_form_given_up))
}

/// The program of the best way, with the sensitivities after it.
fn with_sensitivities(task: &Task<'_>, mut derived: Derived) -> Result<Candidate, TooLarge> {
    let form_task = derived.form.task(task, derived.influences);
    let definitions = derived
        .derivatives
        .sensitivities(&mut derived.graph, form_task, task.parameters)?;
    let mut candidate = Candidate::new(task, &derived, &definitions);
    candidate.leave_factors(task.passes);
    Ok(candidate)
}
