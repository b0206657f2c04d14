//! The best candidates of a search, polished and checked.
//!
//! [`polish`] takes each candidate through a bounded evolution strategy (CMA-ES) and through bounded least squares
//! (Levenberg-Marquardt, then a reflective trust region) with exact derivatives. Then the full cycle of the result
//! decides: a good result stays in one circuit and one branch, passes its targets in order, and closes between them.
//! Other results are dropped, each with its [`Defect`].
//!
//! Candidates are refined on several threads. The random numbers of a candidate follow from the seed and from its index
//! in the list, so the results are the same to the last bit for any number of threads.
//!
//! ```
//! use kin_core::any::Of;
//! use kin_core::prelude::*;
//! use kin_fit::{Candidate, Objective, Settings, polish};
//!
//! mechanism! {
//!     /// A four-bar linkage.
//!     struct Rocker { r1: Length, r2: Length, r3: Length, r4: Length }
//!     input theta2: Angle;
//!     unknown theta3: Angle, theta4: Angle;
//!     r2 * cis(theta2) + r3 * cis(theta3) == r1 + r4 * cis(theta4);
//! }
//!
//! // the rocker of a known linkage, at six inputs
//! let known = Rocker { r1: 2.0, r2: 0.5, r3: 1.8, r4: 1.5 };
//! let pairs: Vec<[f64; 2]> = (0..6)
//!     .map(|step| 0.3 * f64::from(step))
//!     .map(|input| Ok([input, known.position(input, Assembly::Open)?.theta4.position()]))
//!     .collect::<Result<_, SolveError>>()?;
//! let objective = Objective::function(Of::<Rocker>::FUNCTIONS, "theta4", pairs)?
//!     .bounds("r2", 0.2..=0.8)?
//!     .bounds("r3", 1.5..=2.5)?
//!     .bounds("r4", 1.0..=2.0)?;
//! let near = Candidate::new(&Rocker { r1: 2.0, r2: 0.4, r3: 1.9, r4: 1.4 }, Assembly::Open);
//! let refinement = polish(&objective, &[near], &Settings::default())?;
//! let best = &refinement.results[0];
//! assert!(best.polished.largest < 1e-12);
//! assert!((best.design.mechanism::<Rocker>().r3 - 1.8).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod check;
mod defect;
mod figures;
mod refined;

pub use defect::{Defect, DefectKind};
pub use figures::{Figures, Least, Range};
pub use refined::{Dropped, Refined, Refinement};

use crate::design::{Candidate, Design, Sought};
use crate::error::ObjectiveError;
use crate::minimise::{self, Evolution, Squares as _, evolve};
use crate::objective::{Goal, Objective};
use crate::threads::each;

/// The settings by which candidates are polished.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The seed of all random numbers.
    pub seed: u64,
    /// The evolution strategy; `None` leaves it out.
    pub evolution: Option<Evolution>,
    /// The largest number of steps of each of the two methods of least squares; the second method takes 50 at most.
    pub steps: u64,
    /// The number of threads; 0 stands for all that the machine has. It has no influence on the results.
    pub threads: usize,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            seed: 1,
            evolution: Some(Evolution::default()),
            steps: 200,
            threads: 0,
        }
    }
}

/// Polishes candidates, and drops those that fail. Results are in ascending order of their sum of squares.
///
/// # Errors
/// [`ObjectiveError`], if a candidate does not fit the objective, nothing is sought, the spread is not positive, or the
/// objective is one of measured rows, for which there is [`Fit`](crate::Fit). A result that fails is no error: it is
/// listed under [`dropped`](Refinement::dropped).
pub fn polish(
    objective: &Objective,
    candidates: &[Candidate],
    settings: &Settings,
) -> Result<Refinement, ObjectiveError> {
    if objective.goal == Goal::Rows {
        return Err(ObjectiveError::NoSuchPart {
            part: "order, which a full cycle could be checked for",
            goal: "an objective of measured rows",
        });
    }
    if objective.sought().is_empty() && !objective.has_free_inputs() {
        return Err(ObjectiveError::NothingToSeek);
    }
    if let Some(Evolution { spread, .. }) = settings.evolution
        && !(spread.is_finite() && spread > 0.0)
    {
        return Err(ObjectiveError::NotPositive {
            name: "spread",
            value: spread,
        });
    }
    let designs = candidates.iter().map(|candidate| objective.design(candidate));
    let designs: Vec<Design> = designs.collect::<Result<_, _>>()?;
    let refined = each(designs.len(), settings.threads, |index| {
        one(objective, candidates[index].id, index, &designs[index], settings)
    });
    Ok(Refinement::sorted(objective.functions, refined))
}

/// Checks a design as it stands: circuit, branch, order, closure and the margins of the terms over the full cycle.
///
/// # Errors
/// The [`Defect`] that is found first.
pub fn check(objective: &Objective, design: &Design) -> Result<Figures, Defect> {
    check::check(objective, design)
}

/// Random numbers of a candidate: the finaliser of `SplitMix64` (G. L. Steele, D. Lea and C. H. Flood, *Fast splittable
/// pseudorandom number generators*, OOPSLA 2014), so that neighbouring indices have unrelated seeds.
fn seed_of(seed: u64, index: usize) -> u64 {
    let mut mixed = seed.wrapping_add((index as u64).wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
    mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    mixed ^ (mixed >> 31)
}

/// The largest number of steps of the second method of least squares. Each takes as long as thirty of the first.
const LAST_STEPS: u64 = 50;
/// The width of the distribution, in shares of the bounds, below which the evolution strategy ends.
const NARROW: f64 = 1e-9;

/// The best design that the evolution strategy finds, with its inputs in order.
fn evolved(objective: &Objective, start: &Design, evolution: Evolution, seed: u64) -> Design {
    let sought = Sought::new(objective, start, objective.sought());
    if sought.bounds().is_empty() || evolution.evaluations == 0 {
        return start.clone();
    }
    let cost = |numbers: &[f64]| objective.penalised_cost(&mut sought.at(numbers));
    let Some((numbers, _)) = evolve(sought.bounds(), &sought.numbers(), &cost, evolution, NARROW, seed) else {
        return start.clone();
    };
    let mut found = sought.at(&numbers);
    let _ = objective.penalised_cost(&mut found);
    found
}

/// Half of the sum of squares; infinite if the mechanism does not close everywhere.
fn cost(objective: &Objective, design: &Design) -> f64 {
    let rows = objective.residuals(design);
    rows.map_or(f64::INFINITY, |rows| {
        0.5 * rows.iter().map(|row| row * row).sum::<f64>()
    })
}

fn one(
    objective: &Objective,
    id: u64,
    index: usize,
    start: &Design,
    settings: &Settings,
) -> Result<Refined, Box<Dropped>> {
    let mut best = start.clone();
    // The design takes its inputs before errors are compared.
    let _ = objective.penalised_cost(&mut best);
    let begun = if objective.residuals(start).is_some() {
        start.clone()
    } else {
        best.clone()
    };
    if let Some(evolution) = settings.evolution {
        best = evolved(objective, &best, evolution, seed_of(settings.seed, index));
    }
    // The better of the start, with its own inputs, and of the result.
    if cost(objective, &begun) < cost(objective, &best) {
        best = begun.clone();
    }
    let sought = Sought::all(objective, &best);
    let (numbers, steps) = minimise::polish(
        &sought,
        &sought.numbers(),
        [settings.steps, settings.steps.min(LAST_STEPS)],
    );
    let polished = sought.at(&numbers);
    let misfits = [&begun, &best, &polished].map(|design| objective.misfit(design));
    let [at_start, at_evolved, Some(at_polished)] = misfits else {
        return Err(Box::new(Dropped {
            id,
            defect: check::first_unclosed(objective, &polished),
            design: polished,
            misfit: None,
        }));
    };
    match check::check(objective, &polished) {
        Ok(figures) => Ok(Refined {
            id,
            start: at_start,
            evolved: at_evolved,
            polished: at_polished,
            cost: cost(objective, &polished),
            steps,
            inputs: objective.inputs_of(&polished),
            design: polished,
            figures,
        }),
        Err(defect) => Err(Box::new(Dropped {
            id,
            defect,
            design: polished,
            misfit: Some(at_polished),
        })),
    }
}
