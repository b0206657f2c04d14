//! Refinement as a file: the goal, and the numbers that may change.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt;

use serde::Deserialize;

use crate::adjustable::Adjustable;
use crate::design::Candidate;
use crate::error::ObjectiveError;
use crate::functions::FitFunctions;
use crate::minimise::Evolution;
use crate::objective::Objective;
use crate::refine::Settings;
use crate::term::{Sense, Term, Travel};

/// A refinement, as a JSON file states it. Lengths are in the unit of the mechanism, angles in radians.
///
/// A number that may change is written as its two bounds.
///
/// ```
/// use kin_core::any::Of;
/// use kin_core::library::HoekenLinkage;
/// use kin_fit::{Job, polish};
///
/// let job = Job::read(r#"{
///     "mechanism": "hoeken_linkage",
///     "goal": { "path": { "point": "tracer", "targets": [[0, 4.0], [1, 4.0], [2, 4.0], [3, 4.0], [4, 4.0]] } },
///     "bounds": { "crank": [0.5, 1.5], "coupler": [2, 3] },
///     "terms": [{ "transmission": { "aim": 0.72, "floor": 0.7, "weight": 1 } }],
///     "evaluations": 200
/// }"#)?;
/// let hoeken = Of::<HoekenLinkage>::FUNCTIONS;
/// let candidates = job.candidates(hoeken, "id,ground,crank,coupler,assembly\n7,2,1.1,2.6,open\n", 20)?;
/// let found = polish(&job.objective(hoeken)?, &candidates, &job.settings(0))?;
/// assert_eq!(found.results.len() + found.dropped.len(), 1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Job {
    /// The mechanism, in small letters with underscores.
    pub mechanism: String,
    goal: Goal,
    inputs: Option<Vec<f64>>,
    within: Option<[f64; 2]>,
    weights: Option<Vec<f64>>,
    #[serde(default)]
    bounds: BTreeMap<String, [f64; 2]>,
    placement: Option<[Adjustable; 3]>,
    phase: Option<Adjustable>,
    pace: Option<Adjustable>,
    offset: Option<Adjustable>,
    scale: Option<Adjustable>,
    #[serde(default)]
    terms: Vec<Term>,
    #[serde(default)]
    travel: Travel,
    #[serde(default)]
    sense: Sense,
    moving: Option<String>,
    #[serde(default)]
    at: BTreeMap<String, f64>,
    seed: Option<u64>,
    evaluations: Option<u64>,
    spread: Option<f64>,
    steps: Option<u64>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
enum Goal {
    Path {
        point: String,
        targets: Vec<[f64; 2]>,
    },
    Motion {
        point: String,
        angle: String,
        radian: f64,
        targets: Vec<[f64; 3]>,
    },
    Function {
        quantity: String,
        pairs: Vec<[f64; 2]>,
    },
}

/// The reason why a job or its candidates cannot be read.
#[non_exhaustive]
pub enum JobError {
    /// The file is no job; the message has the line and the column.
    Json(serde_json::Error),
    /// The objective does not fit the mechanism.
    Objective(ObjectiveError),
    /// A line of the candidates.
    Candidate {
        /// The line, from 1 on.
        line: usize,
        /// The mistake in it.
        message: String,
    },
}

impl fmt::Display for JobError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Json(error) => write!(formatter, "the job cannot be read: {error}"),
            Self::Objective(error) => error.fmt(formatter),
            Self::Candidate { line, message } => write!(formatter, "candidates, line {line}: {message}"),
        }
    }
}

kin_core::__debug_by_display!(JobError);

impl Error for JobError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Json(error) => Some(error),
            Self::Objective(error) => Some(error),
            Self::Candidate { .. } => None,
        }
    }
}

impl From<ObjectiveError> for JobError {
    fn from(error: ObjectiveError) -> Self {
        Self::Objective(error)
    }
}

impl Job {
    /// Reads a job.
    ///
    /// # Errors
    /// [`JobError::Json`], with line and column.
    pub fn read(text: &str) -> Result<Self, JobError> {
        serde_json::from_str(text).map_err(JobError::Json)
    }

    /// The objective of the job.
    ///
    /// # Errors
    /// [`JobError::Objective`], if it does not fit the mechanism.
    pub fn objective(&self, functions: &'static dyn FitFunctions) -> Result<Objective, JobError> {
        let mut objective = match &self.goal {
            Goal::Path { point, targets } => Objective::path(functions, point, targets.iter().copied()),
            Goal::Motion {
                point,
                angle,
                radian,
                targets,
            } => Objective::motion(functions, point, angle, *radian, targets.iter().copied()),
            Goal::Function { quantity, pairs } => Objective::function(functions, quantity, pairs.iter().copied()),
        }?;
        for (name, [low, high]) in &self.bounds {
            objective = objective.bounds(name, *low..=*high)?;
        }
        objective = with(objective, self.inputs.clone(), Objective::prescribed)?;
        objective = with(objective, self.within, |objective, [low, high]| {
            objective.within(low..=high)
        })?;
        objective = with(objective, self.weights.clone(), Objective::weights)?;
        objective = with(objective, self.placement, |objective, [x, y, angle]| {
            objective.placement(x, y, angle)
        })?;
        objective = with(objective, self.phase, Objective::phase)?;
        objective = with(objective, self.pace, Objective::pace)?;
        objective = with(objective, self.offset, Objective::offset)?;
        objective = with(objective, self.scale, Objective::scale)?;
        objective = with(objective, self.moving.as_deref(), Objective::moving)?;
        for (name, value) in &self.at {
            objective = objective.standing(name, *value)?;
        }
        objective = self.terms.iter().copied().fold(objective, Objective::term);
        Ok(objective.travel(self.travel).sense(self.sense))
    }

    /// The settings by which candidates are polished, on a number of threads; 0 stands for all threads of the machine.
    #[must_use]
    pub fn settings(&self, threads: usize) -> Settings {
        let (settings, evolution) = (Settings::default(), Evolution::default());
        Settings {
            seed: self.seed.unwrap_or(settings.seed),
            evolution: Some(Evolution {
                evaluations: self.evaluations.unwrap_or(evolution.evaluations),
                spread: self.spread.unwrap_or(evolution.spread),
                population: evolution.population,
            }),
            steps: self.steps.unwrap_or(settings.steps),
            threads,
        }
    }

    /// Candidates from the `best` first rows of a table, as a query writes it: comma-separated values with a line of
    /// names. It has a column for each parameter, in which a dot may be written `_`. Columns `id`, `assembly`,
    /// `placed_x`, `placed_y`, `placed_turn` and `input_phase` are read too, and others are ignored. A row without an
    /// assembly is a candidate in each assembly of the mechanism.
    ///
    /// # Errors
    /// [`JobError::Candidate`].
    pub fn candidates(
        &self,
        functions: &'static dyn FitFunctions,
        table: &str,
        best: usize,
    ) -> Result<Vec<Candidate>, JobError> {
        let read = crate::table::read(functions, table, best)?;
        Ok(read.into_iter().map(|(candidate, _)| candidate).collect())
    }
}

/// The objective with a setting of a job, if the job has the setting.
fn with<V>(
    objective: Objective,
    value: Option<V>,
    set: impl FnOnce(Objective, V) -> Result<Objective, ObjectiveError>,
) -> Result<Objective, ObjectiveError> {
    match value {
        Some(value) => set(objective, value),
        None => Ok(objective),
    }
}
