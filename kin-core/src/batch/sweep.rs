//! Chunk by chunk through a batch.
#![allow(
    clippy::inline_always,
    reason = "what is called, and not inlined, is compiled for the narrowest vectors"
)]

use core::marker::PhantomData;

use super::Column;
use super::dispatch::{Kernel, Vectors};
use super::outcome::{LengthMismatch, Outcome, Summary};
use super::target::{Columns, Place, Target, Visitor};
use crate::lanes::Lanes;
use crate::{Mechanism, Pose, Row, Scalar, SolveError};

/// What `solve_batch` of a mechanism does, by the places of its parameters, inputs, unknowns and outputs.
///
/// # Errors
/// [`LengthMismatch`] if a column or a target is not as long as the outcomes; nothing is solved then.
pub fn solve<'a, M, P, C>(
    parameters: M::Parameters<Column<'a>>,
    inputs: M::Inputs<M::Motion<Column<'a>>>,
    assembly: M::Assembly,
    poses: &mut P,
    outcomes: &mut [Outcome],
    vectors: Vectors,
) -> Result<Summary, LengthMismatch>
where
    M: Mechanism<Scalar = f64>,
    P: Columns<C>,
    C: Target,
{
    let problem = Problem::<M, _> {
        parameters,
        inputs,
        guide: InAssembly(assembly),
    };
    problem.solve(poses, outcomes, vectors)
}

/// [`solve`] with values of the unknowns near each position, instead of an assembly.
///
/// # Errors
/// As for [`solve`].
pub fn solve_near<'a, M, P, C>(
    parameters: M::Parameters<Column<'a>>,
    inputs: M::Inputs<M::Motion<Column<'a>>>,
    near: M::Unknowns<Column<'a>>,
    poses: &mut P,
    outcomes: &mut [Outcome],
    vectors: Vectors,
) -> Result<Summary, LengthMismatch>
where
    M: Mechanism<Scalar = f64>,
    P: Columns<C>,
    C: Target,
{
    let problem = Problem::<M, _> {
        parameters,
        inputs,
        guide: NearColumns::<M>(near),
    };
    problem.solve(poses, outcomes, vectors)
}

/// The columns of a batch, by index.
struct Problem<'a, M: Mechanism, G> {
    parameters: M::Parameters<Column<'a>>,
    inputs: M::Inputs<M::Motion<Column<'a>>>,
    guide: G,
}

/// Which of several positions of each pose.
trait Guide<M: Mechanism<Scalar = f64>> {
    /// The columns that it consists of.
    fn columns(&self) -> &[Column<'_>];

    /// The poses from `start` on.
    fn solve_chunk<const W: usize>(
        &self,
        chunk: &Chunk<'_, M, W>,
        start: usize,
        last: usize,
    ) -> Result<<M::With<Lanes<W>> as Mechanism>::Pose, SolveError>;

    /// The pose with an index.
    fn solve_one(&self, mechanism: &M, inputs: M::Inputs<M::Motion<f64>>, index: usize) -> Result<M::Pose, SolveError>;
}

struct InAssembly<A>(A);

struct NearColumns<'a, M: Mechanism>(M::Unknowns<Column<'a>>);

/// The mechanisms and inputs of some poses.
struct Chunk<'a, M: Mechanism<Scalar = f64>, const W: usize> {
    mechanism: M::With<Lanes<W>>,
    inputs: &'a <M::With<Lanes<W>> as Mechanism>::Inputs<M::Motion<Lanes<W>>>,
}

impl<M: Mechanism<Scalar = f64>> Guide<M> for InAssembly<M::Assembly> {
    fn columns(&self) -> &[Column<'_>] {
        &[]
    }

    #[inline(always)]
    fn solve_chunk<const W: usize>(
        &self,
        chunk: &Chunk<'_, M, W>,
        _: usize,
        _: usize,
    ) -> Result<<M::With<Lanes<W>> as Mechanism>::Pose, SolveError> {
        chunk.mechanism.solve_motion(*chunk.inputs, self.0)
    }

    fn solve_one(&self, mechanism: &M, inputs: M::Inputs<M::Motion<f64>>, _: usize) -> Result<M::Pose, SolveError> {
        mechanism.solve_motion(inputs, self.0)
    }
}

impl<M: Mechanism<Scalar = f64>> Guide<M> for NearColumns<'_, M> {
    fn columns(&self) -> &[Column<'_>] {
        self.0.as_ref()
    }

    #[inline(always)]
    fn solve_chunk<const W: usize>(
        &self,
        chunk: &Chunk<'_, M, W>,
        start: usize,
        last: usize,
    ) -> Result<<M::With<Lanes<W>> as Mechanism>::Pose, SolveError> {
        let near = self.0.as_ref();
        let near = Row::from_fn(|index| gathered(near[index], start, last));
        chunk.mechanism.solve_motion_near(*chunk.inputs, near)
    }

    fn solve_one(&self, mechanism: &M, inputs: M::Inputs<M::Motion<f64>>, index: usize) -> Result<M::Pose, SolveError> {
        let near = self.0.as_ref();
        mechanism.solve_motion_near(inputs, Row::from_fn(|unknown| near[unknown].at(index)))
    }
}

/// The numbers of the poses from `start` on; lanes beyond the last one repeat it.
#[inline(always)]
fn gathered<const W: usize>(column: Column<'_>, start: usize, last: usize) -> Lanes<W> {
    match column {
        Column::Same(value) => Lanes([value; W]),
        Column::Each(values) => match values.get(start..).and_then(<[f64]>::first_chunk) {
            Some(values) => Lanes(*values),
            None => gathered_rest(values, start, last),
        },
    }
}

#[cold]
#[inline(never)]
fn gathered_rest<const W: usize>(values: &[f64], start: usize, last: usize) -> Lanes<W> {
    let at = |index| values.get(index).copied().unwrap_or(f64::NAN);
    Lanes::from_fn(|lane| at(last.min(start + lane)))
}

impl<'a, M: Mechanism<Scalar = f64>, G: Guide<M>> Problem<'a, M, G> {
    fn solve<P: Columns<C>, C: Target>(
        &self,
        poses: &mut P,
        outcomes: &mut [Outcome],
        vectors: Vectors,
    ) -> Result<Summary, LengthMismatch> {
        self.check_lengths(poses, outcomes.len())?;
        let kernel = Sweep {
            problem: self,
            poses,
            outcomes,
            target: PhantomData,
        };
        Ok(vectors.run(kernel))
    }

    fn check_lengths<P: Columns<C>, C: Target>(&self, poses: &mut P, count: usize) -> Result<(), LengthMismatch> {
        let description = M::DESCRIPTION;
        let check = |quantity: &'static str, length: Option<usize>| match length {
            Some(length) if length != count => Err(LengthMismatch {
                quantity,
                poses: count,
                length,
            }),
            _ => Ok(()),
        };
        for (column, quantity) in self.parameters.as_ref().iter().zip(description.parameters) {
            check(quantity.name, column.length())?;
        }
        for (motion, quantity) in self.inputs.as_ref().iter().zip(description.inputs) {
            for column in motion.as_ref() {
                check(quantity.name, column.length())?;
            }
        }
        for (column, quantity) in self.guide.columns().iter().zip(description.unknowns) {
            check(quantity.name, column.length())?;
        }
        let mut lengths = Lengths::<M> {
            poses: count,
            mismatch: None,
            mechanism: PhantomData,
        };
        poses.each(&mut lengths);
        lengths.mismatch.map_or(Ok(()), Err)
    }

    /// The pose with an index, by itself.
    #[cold]
    #[inline(never)]
    fn solve_one(&self, index: usize) -> (M::Inputs<M::Motion<f64>>, Result<M::Pose, SolveError>) {
        let parameters = self.parameters.as_ref();
        let mechanism = M::from_parameters(Row::from_fn(|parameter| parameters[parameter].at(index)));
        let columns = self.inputs.as_ref();
        let inputs = M::Inputs::from_fn(|input| M::Motion::from_fn(|order| columns[input].as_ref()[order].at(index)));
        (inputs, self.guide.solve_one(&mechanism, inputs, index))
    }

    /// Solves a pose that the lanes could not solve, and files it.
    #[cold]
    #[inline(never)]
    fn settle<P: Columns<C>, C: Target>(
        &self,
        index: usize,
        poses: &mut P,
        outcome: &mut Outcome,
        summary: &mut Summary,
    ) {
        let (inputs, result) = self.solve_one(index);
        let numbers = match result {
            Ok(pose) => {
                *outcome = Outcome::Solved;
                summary.solved += 1;
                Some((pose.unknown_motions(), pose.output_motions()))
            }
            Err(error) => {
                *outcome = Outcome::from(&error);
                summary.note_failure(index, error);
                None
            }
        };
        poses.each(&mut Filing {
            index,
            inputs: inputs.as_ref(),
            numbers: numbers
                .as_ref()
                .map(|(unknowns, outputs)| (unknowns.as_ref(), outputs.as_ref())),
        });
    }
}

/// Looks for a target that is not as long as there are poses.
struct Lengths<M> {
    poses: usize,
    mismatch: Option<LengthMismatch>,
    mechanism: PhantomData<M>,
}

impl<M: Mechanism, C: Target> Visitor<'_, C> for Lengths<M> {
    fn visit(&mut self, place: Place, there: &mut C) {
        let description = M::DESCRIPTION;
        let quantity = match place {
            Place::Input(index, _) => &description.inputs[index],
            Place::Unknown(index, _) => &description.unknowns[index],
            Place::Output(index, _) => &description.outputs[index],
        };
        let length = there.slice().map(|slice| slice.len());
        if let (None, Some(length)) = (self.mismatch, length.filter(|length| *length != self.poses)) {
            self.mismatch = Some(LengthMismatch {
                quantity: quantity.name,
                poses: self.poses,
                length,
            });
        }
    }
}

/// Files the numbers of one pose, or NaN if there are none.
struct Filing<'r, R> {
    index: usize,
    inputs: &'r [R],
    /// Unknowns and outputs.
    numbers: Option<(&'r [R], &'r [R])>,
}

impl<R: Row<f64>, C: Target> Visitor<'_, C> for Filing<'_, R> {
    fn visit(&mut self, place: Place, there: &mut C) {
        let Some(entry) = there.slice().and_then(|slice| slice.get_mut(self.index)) else {
            return;
        };
        *entry = match (place, self.numbers) {
            (Place::Input(input, order), _) => self.inputs[input].as_ref()[order],
            (Place::Unknown(unknown, order), Some((unknowns, _))) => unknowns[unknown].as_ref()[order],
            (Place::Output(output, order), Some((_, outputs))) => outputs[output].as_ref()[order],
            (_, None) => f64::NAN,
        };
    }
}

/// Stores what has been found in lanes.
struct Storing<'r, R, const W: usize> {
    start: usize,
    inputs: &'r [R],
    unknowns: &'r [R],
    outputs: &'r [R],
}

impl<R: Row<Lanes<W>>, C: Target, const W: usize> Visitor<'_, C> for Storing<'_, R, W> {
    #[inline(always)]
    fn visit(&mut self, place: Place, there: &mut C) {
        let Some(slice) = there.slice() else {
            return;
        };
        let (motions, index, order) = match place {
            Place::Input(index, order) => (self.inputs, index, order),
            Place::Unknown(index, order) => (self.unknowns, index, order),
            Place::Output(index, order) => (self.outputs, index, order),
        };
        let lanes = &motions[index].as_ref()[order].0;
        match slice.get_mut(self.start..self.start + W) {
            Some(slice) => slice.copy_from_slice(lanes),
            None => store_rest(slice, self.start, lanes),
        }
    }
}

/// Stores as many lanes as there are poses left.
#[cold]
#[inline(never)]
fn store_rest(slice: &mut [f64], start: usize, lanes: &[f64]) {
    for (entry, lane) in slice.iter_mut().skip(start).zip(lanes) {
        *entry = *lane;
    }
}

/// A problem with the places for its results.
struct Sweep<'p, 'a, M: Mechanism<Scalar = f64>, G, P, C> {
    problem: &'p Problem<'a, M, G>,
    poses: &'p mut P,
    outcomes: &'p mut [Outcome],
    target: PhantomData<C>,
}

impl<M, G, P, C> Kernel for Sweep<'_, '_, M, G, P, C>
where
    M: Mechanism<Scalar = f64>,
    G: Guide<M>,
    P: Columns<C>,
    C: Target,
{
    type Result = Summary;

    #[inline(always)]
    fn run<const W: usize>(self) -> Summary {
        let Self {
            problem,
            poses,
            outcomes,
            ..
        } = self;
        let mut summary = Summary::default();
        let Some(last) = outcomes.len().checked_sub(1) else {
            return summary;
        };
        let parameters = problem.parameters.as_ref();
        let columns = problem.inputs.as_ref();
        let mut dimensions: <M::With<Lanes<W>> as Mechanism>::Parameters<Lanes<W>> =
            Row::from_fn(|_| Lanes::constant(0.0));
        let mut inputs: <M::With<Lanes<W>> as Mechanism>::Inputs<M::Motion<Lanes<W>>> =
            Row::from_fn(|_| Row::from_fn(|_| Lanes::constant(0.0)));
        let varies = parameters.iter().any(|column| column.length().is_some());
        for start in (0..=last).step_by(W) {
            if varies || start == 0 {
                for (dimension, column) in dimensions.as_mut().iter_mut().zip(parameters) {
                    *dimension = gathered(*column, start, last);
                }
            }
            for (motion, columns) in inputs.as_mut().iter_mut().zip(columns) {
                for (entry, column) in motion.as_mut().iter_mut().zip(columns.as_ref()) {
                    *entry = gathered(*column, start, last);
                }
            }
            let chunk = Chunk::<M, W> {
                mechanism: M::With::from_parameters(dimensions),
                inputs: &inputs,
            };
            let count = W.min(last + 1 - start);
            let mut all = false;
            let mut sum = Lanes::constant(f64::NAN);
            if let Ok(pose) = problem.guide.solve_chunk(&chunk, start, last) {
                let (unknowns, outputs) = (pose.unknown_motions(), pose.output_motions());
                // Finite if, and only if, all of them are, unless the sum itself goes beyond the range.
                sum = Lanes::constant(0.0);
                for motion in unknowns.as_ref() {
                    for entry in motion.as_ref() {
                        sum = sum + *entry;
                    }
                }
                for motion in outputs.as_ref() {
                    for entry in motion.as_ref() {
                        sum = sum + *entry;
                    }
                }
                all = sum.sum().is_finite();
                poses.each(&mut Storing::<_, W> {
                    start,
                    inputs: inputs.as_ref(),
                    unknowns: unknowns.as_ref(),
                    outputs: outputs.as_ref(),
                });
            }
            let outcomes = &mut outcomes[start..start + count];
            outcomes.fill(Outcome::Solved);
            summary.solved += count;
            if !all {
                for (lane, outcome) in outcomes.iter_mut().enumerate() {
                    if !sum.0[lane].is_finite() {
                        summary.solved -= 1;
                        problem.settle(start + lane, poses, outcome, &mut summary);
                    }
                }
            }
        }
        summary
    }
}
