//! What the campaign knows of a mechanism and asks of it, by slices of numbers, so that each check is compiled once.

use kin_core::any::{AnyMechanism, AssemblyChoice, ClosureOver, MotionOver, PositionChoice};
use kin_core::batch::{AnyBatch, Column, ColumnChoice, GivenColumns, Outcome, Summary, Vectors};
use kin_core::prelude::*;
use kin_core::{CurveFunctions, Description, Quantity, TrackError, track_between};
use kin_tests::batches::{Poses, Table};
use kin_tests::counting::{Calls, calls_of};

use super::bounded::{Bounded, TERMS};

/// A value and its derivatives through snap.
pub(crate) type Rates = [f64; TERMS];

/// Dimensions and inputs.
#[derive(Clone, Debug, Default, PartialEq)]
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
    /// The unknowns.
    pub(crate) unknowns: Vec<Rates>,
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
        let motions = [&self.unknowns, &self.outputs];
        motions.into_iter().flatten().flatten().all(|value| value.is_finite())
    }
}

/// The results of a batch.
pub(crate) type Batch = (Table, Vec<Outcome>, Summary);

/// The solvers that the campaign compares, and the closure, of which they know nothing.
pub(crate) trait Solvers:
    AnyMechanism + AnyBatch + MotionOver<f64> + MotionOver<f32> + ClosureOver<Bounded>
{
}

impl<F: AnyMechanism + AnyBatch + MotionOver<f64> + MotionOver<f32> + ClosureOver<Bounded>> Solvers for F {}

/// A mechanism.
#[derive(Clone, Copy)]
pub(crate) struct Topology {
    /// Its functions.
    pub(crate) solvers: &'static dyn Solvers,
    /// The same, with its calls counted.
    pub(crate) counted: &'static dyn CurveFunctions,
    /// [`Poses::solve_in_parallel`], the bounds of which a mechanism meets and a type parameter cannot promise in one
    /// place.
    pub(crate) in_parallel: fn(&[Problem], &[AssemblyChoice], Vectors) -> Batch,
}

impl Topology {
    /// Its summary.
    pub(crate) fn description(&self) -> &'static Description {
        self.solvers.description()
    }

    /// The residual of each scalar equation, in the order of the declaration, left side less right.
    pub(crate) fn closure(&self, parameters: &[Bounded], inputs: &[Bounded], unknowns: &[Bounded]) -> Vec<Bounded> {
        let mut residuals = vec![Bounded::constant(0.0); unknowns.len()];
        self.solvers.closure(parameters, inputs, unknowns, &mut residuals);
        residuals
    }

    /// Through snap.
    ///
    /// # Errors
    /// As the mechanism.
    pub(crate) fn solve(&self, problem: &Problem, assembly: &AssemblyChoice) -> Result<Found, SolveError> {
        self.solve_in::<f64>(self.solvers, problem, assembly)
    }

    /// The same in single precision.
    ///
    /// # Errors
    /// As the mechanism.
    pub(crate) fn solve_single(&self, problem: &Problem, assembly: &AssemblyChoice) -> Result<Found, SolveError> {
        self.solve_in::<f32>(self.solvers, problem, assembly)
    }

    fn solve_in<T: Number>(
        &self,
        solvers: &dyn MotionOver<T>,
        problem: &Problem,
        assembly: &AssemblyChoice,
    ) -> Result<Found, SolveError> {
        let numbers = |values: &[f64]| -> Vec<T> { values.iter().copied().map(T::constant).collect() };
        let zeros = |quantities: &[Quantity]| vec![T::constant(0.0); quantities.len() * TERMS];
        let rates = |motions: &[T]| -> Vec<Rates> {
            let motions = motions.chunks_exact(TERMS);
            motions
                .map(|motion| std::array::from_fn(|order| motion[order].real()))
                .collect()
        };
        let near;
        let choice = match assembly {
            AssemblyChoice::Index(index) => PositionChoice::Assembly(*index),
            AssemblyChoice::Near(values) => {
                near = numbers(values);
                PositionChoice::Near(&near)
            }
        };
        let (parameters, inputs) = (numbers(&problem.parameters), numbers(problem.inputs.as_flattened()));
        let (mut unknowns, mut outputs) = (zeros(self.description().unknowns), zeros(self.description().outputs));
        solvers.motion(&parameters, &inputs, choice, &mut unknowns, &mut outputs)?;
        Ok(Found {
            unknowns: rates(&unknowns),
            outputs: rates(&outputs),
        })
    }

    /// The position alone.
    ///
    /// # Errors
    /// As the mechanism.
    pub(crate) fn position(&self, problem: &Problem, assembly: &AssemblyChoice) -> Result<Vec<f64>, SolveError> {
        let mut unknowns = vec![0.0; self.description().unknowns.len()];
        let (inputs, choice) = (problem.values(), assembly.position());
        self.solvers
            .position(&problem.parameters, &inputs, choice, &mut unknowns)?;
        Ok(unknowns)
    }

    /// The index of the assembly to which values of the unknowns belong.
    pub(crate) fn assembly_at(&self, problem: &Problem, near: &[f64]) -> Option<usize> {
        self.solvers.assembly_at(&problem.parameters, &problem.values(), near)
    }

    /// All at once. They are all of one assembly, or all near values.
    pub(crate) fn batch(&self, problems: &[Problem], assemblies: &[AssemblyChoice], vectors: Vectors) -> Batch {
        let numbers = |count: usize, number: &dyn Fn(usize, usize) -> f64| -> Vec<Vec<f64>> {
            let column = |place: usize| (0..problems.len()).map(|pose| number(pose, place)).collect();
            (0..count).map(column).collect()
        };
        let near = |pose: usize, place: usize| match &assemblies[pose] {
            AssemblyChoice::Near(near) => near[place],
            AssemblyChoice::Index(_) => f64::NAN,
        };
        let Description {
            parameters,
            inputs,
            unknowns,
            ..
        } = self.description();
        let numbers = [
            numbers(parameters.len(), &|pose, place| problems[pose].parameters[place]),
            numbers(inputs.len() * TERMS, &|pose, place| {
                problems[pose].inputs.as_flattened()[place]
            }),
            numbers(unknowns.len(), &near),
        ];
        let [parameters, inputs, near] = numbers
            .each_ref()
            .map(|columns| -> Vec<Column<'_>> { columns.iter().map(Column::from).collect() });
        let inputs: Vec<&[Column<'_>]> = inputs.chunks_exact(TERMS).collect();
        let given = GivenColumns {
            parameters: &parameters,
            inputs: &inputs,
            choice: assemblies[0]
                .index()
                .map_or(ColumnChoice::Near(&near), ColumnChoice::Assembly),
        };
        let mut table = Table::new(self.description(), problems.len());
        let mut outcomes = vec![Outcome::Unsolved; problems.len()];
        let summary = self
            .solvers
            .solve_batch(given, &mut table.wanted(), &mut outcomes, vectors);
        (table, outcomes, summary.expect("all columns are of one length"))
    }

    /// From unknowns that are known at a problem's inputs to other inputs; and how often it asked the mechanism.
    pub(crate) fn track(&self, problem: &Problem, from: &[f64], to: &[f64]) -> (Ending, Calls) {
        calls_of(|| track_between(self.counted, &problem.parameters, &problem.values(), from, to))
    }
}

/// The unknowns at the end of a track, or what is in its way.
pub(crate) type Ending = Result<Vec<f64>, TrackError<Vec<f64>, Vec<f64>>>;

/// The poses of a batch in the types of their mechanism.
pub(crate) fn poses<M: Mechanism<Scalar = f64>>(problems: &[Problem], assemblies: &[AssemblyChoice]) -> Poses<M> {
    let mechanism = |problem: &Problem| M::from_parameters(Row::from_fn(|index| problem.parameters[index]));
    let inputs = |problem: &Problem| Row::from_fn(|index| M::Motion::from_fn(|order| problem.inputs[index][order]));
    let near = |assembly: &AssemblyChoice| match assembly {
        AssemblyChoice::Near(near) => Some(Row::from_fn(|index| near[index])),
        AssemblyChoice::Index(_) => None,
    };
    Poses {
        mechanisms: problems.iter().map(mechanism).collect(),
        inputs: problems.iter().map(inputs).collect(),
        near: assemblies.iter().filter_map(near).collect(),
    }
}
