//! Refinement as a file: what is to be generated, and what may change.

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

/// What a file of JSON says about a refinement. Lengths are in the unit of the mechanism, angles in radians.
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
    placement: Option<[Number; 3]>,
    phase: Option<Number>,
    pace: Option<Number>,
    offset: Option<Number>,
    scale: Option<Number>,
    #[serde(default)]
    terms: Vec<JobTerm>,
    #[serde(default)]
    travel: JobTravel,
    #[serde(default)]
    sense: JobSense,
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

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(untagged)]
enum Number {
    Fixed(f64),
    Free([f64; 2]),
}

impl From<Number> for Adjustable {
    fn from(number: Number) -> Self {
        match number {
            Number::Fixed(value) => Self::Fixed(value),
            Number::Free(bounds) => Self::Free(bounds),
        }
    }
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
enum JobTerm {
    Lengths { weight: f64 },
    Box { width: f64, height: f64, weight: f64 },
    Grashof { aim: f64, weight: f64 },
    DriverTurns { aim: f64, weight: f64 },
    Transmission { aim: f64, floor: f64, weight: f64 },
}

impl From<JobTerm> for Term {
    fn from(term: JobTerm) -> Self {
        match term {
            JobTerm::Lengths { weight } => Self::Lengths { weight },
            JobTerm::Box { width, height, weight } => Self::Box { width, height, weight },
            JobTerm::Grashof { aim, weight } => Self::Grashof { aim, weight },
            JobTerm::DriverTurns { aim, weight } => Self::DriverTurns { aim, weight },
            JobTerm::Transmission { aim, floor, weight } => Self::Transmission { aim, floor, weight },
        }
    }
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
enum JobTravel {
    #[default]
    Targets,
    Turn,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
enum JobSense {
    #[default]
    Either,
    Forward,
    Backward,
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
        /// What is wrong with it.
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
        if let Some(inputs) = &self.inputs {
            objective = objective.prescribed(inputs.iter().copied())?;
        }
        if let Some([low, high]) = self.within {
            objective = objective.within(low..=high)?;
        }
        if let Some(weights) = &self.weights {
            objective = objective.weights(weights.iter().copied())?;
        }
        for (name, [low, high]) in &self.bounds {
            objective = objective.bounds(name, *low..=*high)?;
        }
        if let Some([x, y, turn]) = self.placement {
            objective = objective.placement(x, y, turn)?;
        }
        if let Some(phase) = self.phase {
            objective = objective.phase(phase)?;
        }
        if let Some(pace) = self.pace {
            objective = objective.pace(pace)?;
        }
        if let Some(offset) = self.offset {
            objective = objective.offset(offset)?;
        }
        if let Some(scale) = self.scale {
            objective = objective.scale(scale)?;
        }
        for term in &self.terms {
            objective = objective.term((*term).into());
        }
        if let Some(moving) = &self.moving {
            objective = objective.moving(moving)?;
        }
        for (name, value) in &self.at {
            objective = objective.standing(name, *value)?;
        }
        let travel = match self.travel {
            JobTravel::Targets => Travel::Targets,
            JobTravel::Turn => Travel::Turn,
        };
        let sense = match self.sense {
            JobSense::Either => Sense::Either,
            JobSense::Forward => Sense::Forward,
            JobSense::Backward => Sense::Backward,
        };
        Ok(objective.travel(travel).sense(sense))
    }

    /// How candidates are polished, on a number of threads; 0 stands for all that the machine has.
    #[must_use]
    pub fn settings(&self, threads: usize) -> Settings {
        let (known, own) = (Settings::default(), Evolution::default());
        Settings {
            seed: self.seed.unwrap_or(known.seed),
            evolution: Some(Evolution {
                evaluations: self.evaluations.unwrap_or(own.evaluations),
                spread: self.spread.unwrap_or(own.spread),
                population: own.population,
            }),
            steps: self.steps.unwrap_or(known.steps),
            threads,
        }
    }

    /// Candidates from the `best` first rows of a table, as a query writes it: comma-separated values with a line of names. It has a column for each parameter, in
    /// which a dot may be written `_`. Columns `id`, `assembly`, `placed_x`, `placed_y`, `placed_turn` and `input_phase` are read too, and others are left aside.
    /// Without an assembly, every one of the mechanism is a candidate of its own.
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
