//! Any mechanism by slices of numbers, so that what is done with all of them is compiled once.

use std::marker::PhantomData;

use kin_core::batch::{Outcome, Summary, Vectors};
use kin_core::prelude::*;
use kin_core::{Description, Obstacle, TrackError, track};
use kin_tests::batches::{Poses, Table};
use kin_tests::counting::{Calls, Counting, calls_of};
use kin_tests::mechanisms::cases::Inputs;

use super::taylor::{TERMS, Taylor};
use super::topology::Topology;

/// A value and its derivatives through snap.
pub(crate) type Rates = [f64; TERMS];

/// Which of several positions.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Guide {
    /// The argument for the assembly with this number.
    Assembly(usize),
    /// That near these values of the unknowns.
    Near(Vec<f64>),
}

/// Dimensions and inputs.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Problem {
    /// The dimensions, scalar by scalar.
    pub(crate) parameters: Vec<f64>,
    /// The inputs and their derivatives.
    pub(crate) inputs: Vec<Rates>,
}

/// A value that does not move.
#[must_use]
pub(crate) fn at_rest(value: f64) -> Rates {
    [value, 0.0, 0.0, 0.0, 0.0]
}

impl Problem {
    /// The same dimensions at rest at other inputs.
    #[must_use]
    pub(crate) fn at(&self, inputs: &[f64]) -> Self {
        Self {
            parameters: self.parameters.clone(),
            inputs: inputs.iter().copied().map(at_rest).collect(),
        }
    }

    /// The inputs alone.
    #[must_use]
    pub(crate) fn values(&self) -> Vec<f64> {
        self.inputs.iter().map(|rates| rates[0]).collect()
    }
}

/// The numbers of a pose.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Found {
    /// The unknowns, with the angle of a direction.
    pub(crate) unknowns: Vec<Rates>,
    /// The same as the pose holds them: with the cosine of a direction.
    pub(crate) columns: Vec<Rates>,
    /// The sines of directions.
    pub(crate) sines: Vec<Option<f64>>,
    /// The scalar outputs.
    pub(crate) outputs: Vec<Rates>,
}

impl Found {
    /// The unknowns alone.
    #[must_use]
    pub(crate) fn position(&self) -> Vec<f64> {
        self.unknowns.iter().map(|rates| rates[0]).collect()
    }

    /// Whether all of it is finite.
    #[must_use]
    pub(crate) fn is_finite(&self) -> bool {
        let motions = [&self.unknowns, &self.columns, &self.outputs];
        motions.into_iter().flatten().flatten().all(|value| value.is_finite())
            && self.sines.iter().flatten().all(|sine| sine.is_finite())
    }
}

/// Where something is in the way of a track.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Place {
    /// The part of the way until there.
    pub(crate) fraction: f64,
    /// The unknowns there.
    pub(crate) unknowns: Vec<f64>,
}

fn place<I, U: AsRef<[f64]>>(obstacle: &Obstacle<I, U>) -> Place {
    Place {
        fraction: obstacle.fraction,
        unknowns: obstacle.unknowns.as_ref().to_vec(),
    }
}

/// Where a track ended, or why.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Ending {
    /// There, with these unknowns.
    Arrived(Vec<f64>),
    /// At a limit position.
    Limit(Place),
    /// At a change point.
    ChangePoint(Place),
    /// At a pole, with the last unknowns before it.
    Unbounded(Place),
    /// Where the mechanism's own solver fails.
    Failed(SolveError),
    /// Where rounding hides what is near, or where an unknown jumps: the inputs there.
    Lost(Vec<f64>),
    /// After more steps than a track may take.
    Endless,
}

/// The results of a batch.
pub(crate) type Batch = (Table, Vec<Outcome>, Summary);

/// A mechanism by slices of numbers.
pub(crate) trait Engine {
    /// Its summary.
    fn description(&self) -> Description;

    /// How many assemblies have names.
    fn assembly_count(&self) -> usize;

    /// The closure written by hand.
    fn closure(&self, parameters: &[Taylor], inputs: &[Taylor], unknowns: &[Taylor]) -> Vec<Taylor>;

    /// Through snap.
    ///
    /// # Errors
    /// As the mechanism.
    fn solve(&self, problem: &Problem, guide: &Guide) -> Result<Found, SolveError>;

    /// The same in single precision.
    ///
    /// # Errors
    /// As the mechanism.
    fn solve_single(&self, problem: &Problem, guide: &Guide) -> Result<Found, SolveError>;

    /// The position alone.
    ///
    /// # Errors
    /// As the mechanism.
    fn position(&self, problem: &Problem, guide: &Guide) -> Result<Vec<f64>, SolveError>;

    /// The number of the assembly to which values of the unknowns belong.
    fn assembly_near(&self, problem: &Problem, near: &[f64]) -> Option<usize>;

    /// All at once. The guides are all of one assembly, or all are values near by.
    fn batch(&self, problems: &[Problem], guides: &[Guide], vectors: Vectors) -> Batch;

    /// The same on all cores.
    fn batch_in_parallel(&self, problems: &[Problem], guides: &[Guide], vectors: Vectors) -> Batch;

    /// From unknowns that are known at a problem's inputs to other inputs; and how often it asked the mechanism.
    fn track(&self, problem: &Problem, from: &[f64], to: &[f64]) -> (Ending, Calls);
}

/// The engine of a topology.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Of<T>(PhantomData<T>);

impl<T> Default for Of<T> {
    fn default() -> Self {
        Self(PhantomData)
    }
}

type Single<M> = <M as Mechanism>::With<f32>;

impl<T: Topology> Of<T> {
    fn mechanism(problem: &Problem) -> T::Mechanism {
        T::Mechanism::from_parameters(Row::from_fn(|index| problem.parameters[index]))
    }

    fn inputs(problem: &Problem) -> Inputs<T::Mechanism> {
        Row::from_fn(|index| Motion::new(problem.inputs[index]))
    }

    fn assembly(index: usize) -> <T::Mechanism as Mechanism>::Assembly {
        T::Mechanism::assembly(index).expect("there are as many assemblies")
    }

    fn poses(problems: &[Problem], guides: &[Guide]) -> Poses<T::Mechanism> {
        Poses {
            mechanisms: problems.iter().map(Self::mechanism).collect(),
            inputs: problems.iter().map(Self::inputs).collect(),
            near: guides
                .iter()
                .filter_map(|guide| match guide {
                    Guide::Near(near) => Some(Row::from_fn(|index| near[index])),
                    Guide::Assembly(_) => None,
                })
                .collect(),
        }
    }

    fn common(guides: &[Guide]) -> Option<<T::Mechanism as Mechanism>::Assembly> {
        match guides.first() {
            Some(Guide::Assembly(index)) => Some(Self::assembly(*index)),
            _ => None,
        }
    }
}

fn found<P: Pose>(pose: &P) -> Found {
    fn rates<S: Scalar, R: Row<S>>(motions: &[R]) -> Vec<Rates> {
        let rates = |motion: &R| std::array::from_fn(|order| motion.as_ref()[order].real());
        motions.iter().map(rates).collect()
    }
    Found {
        unknowns: rates(pose.unknown_motions().as_ref()),
        columns: rates(pose.unknown_columns().as_ref()),
        sines: pose
            .unknown_sines()
            .as_ref()
            .iter()
            .map(|sine| sine.map(Number::real))
            .collect(),
        outputs: rates(pose.output_motions().as_ref()),
    }
}

#[expect(clippy::cast_possible_truncation, reason = "the numbers have been rounded before")]
fn single(value: f64) -> f32 {
    value as f32
}

impl<T: Topology> Engine for Of<T> {
    fn description(&self) -> Description {
        T::Mechanism::DESCRIPTION
    }

    fn assembly_count(&self) -> usize {
        T::Mechanism::ASSEMBLY_COUNT
    }

    fn closure(&self, parameters: &[Taylor], inputs: &[Taylor], unknowns: &[Taylor]) -> Vec<Taylor> {
        T::closure(parameters, inputs, unknowns)
    }

    fn solve(&self, problem: &Problem, guide: &Guide) -> Result<Found, SolveError> {
        let (mechanism, inputs) = (Self::mechanism(problem), Self::inputs(problem));
        let pose = match guide {
            Guide::Assembly(index) => mechanism.solve_motion(inputs, Self::assembly(*index)),
            Guide::Near(near) => mechanism.solve_motion_near(inputs, Row::from_fn(|index| near[index])),
        };
        pose.map(|pose| found(&pose))
    }

    fn solve_single(&self, problem: &Problem, guide: &Guide) -> Result<Found, SolveError> {
        let mechanism =
            Single::<T::Mechanism>::from_parameters(Row::from_fn(|index| single(problem.parameters[index])));
        let inputs = Row::from_fn(|index| {
            let rates: &Rates = &problem.inputs[index];
            <<Single<T::Mechanism> as Mechanism>::Motion<f32> as Row<f32>>::from_fn(|order| single(rates[order]))
        });
        let pose = match guide {
            Guide::Assembly(index) => mechanism.solve_motion(inputs, Self::assembly(*index)),
            Guide::Near(near) => mechanism.solve_motion_near(inputs, Row::from_fn(|index| single(near[index]))),
        };
        pose.map(|pose| found(&pose))
    }

    fn position(&self, problem: &Problem, guide: &Guide) -> Result<Vec<f64>, SolveError> {
        let (mechanism, inputs) = (Self::mechanism(problem), Row::from_fn(|index| problem.inputs[index][0]));
        let unknowns = match guide {
            Guide::Assembly(index) => mechanism.solve_position(inputs, Self::assembly(*index)),
            Guide::Near(near) => mechanism.solve_position_near(inputs, Row::from_fn(|index| near[index])),
        };
        unknowns.map(|unknowns| unknowns.as_ref().to_vec())
    }

    fn assembly_near(&self, problem: &Problem, near: &[f64]) -> Option<usize> {
        let (mechanism, inputs) = (Self::mechanism(problem), Row::from_fn(|index| problem.inputs[index][0]));
        let assembly = mechanism.assembly_near(inputs, Row::from_fn(|index| near[index]));
        T::Mechanism::assemblies().position(|other| other == assembly)
    }

    fn batch(&self, problems: &[Problem], guides: &[Guide], vectors: Vectors) -> Batch {
        Self::poses(problems, guides).solve(Self::common(guides), vectors)
    }

    fn batch_in_parallel(&self, problems: &[Problem], guides: &[Guide], vectors: Vectors) -> Batch {
        T::solve_in_parallel(&Self::poses(problems, guides), Self::common(guides), vectors)
    }

    fn track(&self, problem: &Problem, from: &[f64], to: &[f64]) -> (Ending, Calls) {
        let mechanism = Counting(Self::mechanism(problem));
        let (result, calls) = calls_of(|| {
            track(
                &mechanism,
                Row::from_fn(|index| problem.inputs[index][0]),
                Row::from_fn(|index| from[index]),
                Row::from_fn(|index| to[index]),
            )
        });
        let ending = match result {
            Ok(unknowns) => Ending::Arrived(unknowns.as_ref().to_vec()),
            Err(TrackError::TurningPoint(obstacle)) => Ending::Limit(place(&obstacle)),
            Err(TrackError::ChangePoint(obstacle)) => Ending::ChangePoint(place(&obstacle)),
            Err(TrackError::Pole(obstacle)) => Ending::Unbounded(place(&obstacle)),
            Err(TrackError::Failed(error)) => Ending::Failed(error),
            Err(TrackError::Lost(halt)) => Ending::Lost(halt.inputs.as_ref().to_vec()),
            Err(_) => Ending::Endless,
        };
        (ending, calls)
    }
}
