//! Chunk by chunk through a batch.

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
pub(super) struct Problem<'a, M: Mechanism, G> {
    pub(super) parameters: M::Parameters<Column<'a>>,
    pub(super) inputs: M::Inputs<M::Motion<Column<'a>>>,
    pub(super) guide: G,
}

/// Which of several positions of each pose.
pub(super) trait Guide<M: Mechanism<Scalar = f64>>: Sized {
    /// That of some of the poses.
    #[cfg(feature = "rayon")]
    fn part(&self, range: core::ops::Range<usize>) -> Self;

    /// The columns that it consists of.
    fn columns(&self) -> &[Column<'_>];

    /// The poses from `start` on.
    fn solve_chunk<const W: usize, const FUSED: bool>(
        &self,
        chunk: &Chunk<'_, M, W, FUSED>,
        start: usize,
    ) -> Result<<M::With<Lanes<W, FUSED>> as Mechanism>::Pose, SolveError>;

    /// The pose with an index.
    fn solve_one(&self, mechanism: &M, inputs: M::Inputs<M::Motion<f64>>, index: usize) -> Result<M::Pose, SolveError>;
}

pub(super) struct InAssembly<A>(pub(super) A);

pub(super) struct NearColumns<'a, M: Mechanism>(pub(super) M::Unknowns<Column<'a>>);

/// The mechanisms and inputs of some poses.
pub(super) struct Chunk<'a, M: Mechanism<Scalar = f64>, const W: usize, const FUSED: bool> {
    mechanism: M::With<Lanes<W, FUSED>>,
    inputs: &'a <M::With<Lanes<W, FUSED>> as Mechanism>::Inputs<M::Motion<Lanes<W, FUSED>>>,
}

impl<M: Mechanism<Scalar = f64>> Guide<M> for InAssembly<M::Assembly> {
    #[cfg(feature = "rayon")]
    fn part(&self, _: core::ops::Range<usize>) -> Self {
        Self(self.0)
    }

    fn columns(&self) -> &[Column<'_>] {
        &[]
    }

    #[inline(always)]
    fn solve_chunk<const W: usize, const FUSED: bool>(
        &self,
        chunk: &Chunk<'_, M, W, FUSED>,
        _: usize,
    ) -> Result<<M::With<Lanes<W, FUSED>> as Mechanism>::Pose, SolveError> {
        chunk.mechanism.solve_motion(*chunk.inputs, self.0)
    }

    fn solve_one(&self, mechanism: &M, inputs: M::Inputs<M::Motion<f64>>, _: usize) -> Result<M::Pose, SolveError> {
        mechanism.solve_motion(inputs, self.0)
    }
}

impl<M: Mechanism<Scalar = f64>> Guide<M> for NearColumns<'_, M> {
    #[cfg(feature = "rayon")]
    fn part(&self, range: core::ops::Range<usize>) -> Self {
        let near = self.0.as_ref();
        Self(Row::from_fn(|unknown| near[unknown].part(range.clone())))
    }

    fn columns(&self) -> &[Column<'_>] {
        self.0.as_ref()
    }

    #[inline(always)]
    fn solve_chunk<const W: usize, const FUSED: bool>(
        &self,
        chunk: &Chunk<'_, M, W, FUSED>,
        start: usize,
    ) -> Result<<M::With<Lanes<W, FUSED>> as Mechanism>::Pose, SolveError> {
        let near = self.0.as_ref();
        let near = Row::from_fn(|index| gathered(near[index], start));
        chunk.mechanism.solve_motion_near(*chunk.inputs, near)
    }

    fn solve_one(&self, mechanism: &M, inputs: M::Inputs<M::Motion<f64>>, index: usize) -> Result<M::Pose, SolveError> {
        let near = self.0.as_ref();
        mechanism.solve_motion_near(inputs, Row::from_fn(|unknown| near[unknown].at(index)))
    }
}

/// The numbers of the poses from `start` on.
#[inline(always)]
fn gathered<const W: usize, const FUSED: bool>(column: Column<'_>, start: usize) -> Lanes<W, FUSED> {
    match column {
        Column::Same(value) => Lanes([value; W]),
        // All columns are long enough, and the compiler does not know.
        Column::Each(values) => match values.get(start..).and_then(<[f64]>::first_chunk) {
            Some(values) => Lanes(*values),
            None => Lanes([f64::NAN; W]),
        },
    }
}

impl<M: Mechanism<Scalar = f64>, G: Guide<M>> Problem<'_, M, G> {
    pub(super) fn solve<P: Columns<C>, C: Target>(
        &self,
        poses: &mut P,
        outcomes: &mut [Outcome],
        vectors: Vectors,
    ) -> Result<Summary, LengthMismatch> {
        self.check_lengths(poses, outcomes.len())?;
        Ok(self.sweep(poses, outcomes, vectors))
    }

    /// [`solve`](Self::solve) where all columns are known to be of one length.
    pub(super) fn sweep<P: Columns<C>, C: Target>(
        &self,
        poses: &mut P,
        outcomes: &mut [Outcome],
        vectors: Vectors,
    ) -> Summary {
        // Those that are not will say so.
        outcomes.fill(Outcome::Solved);
        let kernel = Sweep {
            problem: self,
            poses,
            outcomes,
            target: PhantomData,
        };
        vectors.run(kernel)
    }

    pub(super) fn check_lengths<P: Columns<C>, C: Target>(
        &self,
        poses: &mut P,
        count: usize,
    ) -> Result<(), LengthMismatch> {
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
    fn solve_one(&self, index: usize) -> Alone<M> {
        let parameters = self.parameters.as_ref();
        let mechanism = M::from_parameters(Row::from_fn(|parameter| parameters[parameter].at(index)));
        let columns = self.inputs.as_ref();
        let inputs = M::Inputs::from_fn(|input| M::Motion::from_fn(|order| columns[input].as_ref()[order].at(index)));
        (inputs, self.guide.solve_one(&mechanism, inputs, index))
    }

    /// Solves a pose that the lanes could not solve, and files it.
    #[cold]
    #[inline(never)]
    fn settle<P: Columns<C>, C: Target>(&self, index: usize, poses: &mut P) -> Result<(), SolveError> {
        let (inputs, result) = self.solve_one(index);
        let numbers = result.map(|pose| (pose.unknown_columns(), pose.unknown_sines(), pose.output_motions()));
        poses.each(&mut Filing {
            index,
            inputs: inputs.as_ref(),
            numbers: numbers
                .as_ref()
                .map(|(unknowns, sines, outputs)| Numbers {
                    unknowns: unknowns.as_ref(),
                    sines: sines.as_ref(),
                    outputs: outputs.as_ref(),
                })
                .ok(),
        });
        numbers.map(|_| ())
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
            Place::Unknown(index, _) | Place::Sine(index) => &description.unknowns[index],
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
    numbers: Option<Numbers<'r, R>>,
}

/// What has been found of one pose.
struct Numbers<'r, R> {
    unknowns: &'r [R],
    /// Where they are directions.
    sines: &'r [Option<f64>],
    outputs: &'r [R],
}

impl<R: Row<f64>, C: Target> Visitor<'_, C> for Filing<'_, R> {
    fn visit(&mut self, place: Place, there: &mut C) {
        let Some(entry) = there.slice().and_then(|slice| slice.get_mut(self.index)) else {
            return;
        };
        *entry = match (place, &self.numbers) {
            (Place::Input(input, order), _) => self.inputs[input].as_ref()[order],
            (Place::Unknown(unknown, order), Some(found)) => found.unknowns[unknown].as_ref()[order],
            (Place::Sine(unknown), Some(found)) => found.sines[unknown].unwrap_or(*entry),
            (Place::Output(output, order), Some(found)) => found.outputs[output].as_ref()[order],
            (_, None) => f64::NAN,
        };
    }
}

/// Stores what has been found in lanes.
struct Storing<'r, R, const W: usize, const FUSED: bool> {
    start: usize,
    inputs: &'r [R],
    unknowns: &'r [R],
    sines: &'r [Option<Lanes<W, FUSED>>],
    outputs: &'r [R],
}

impl<R: Row<Lanes<W, FUSED>>, C: Target, const W: usize, const FUSED: bool> Visitor<'_, C>
    for Storing<'_, R, W, FUSED>
{
    #[inline(always)]
    fn visit(&mut self, place: Place, there: &mut C) {
        let Some(slice) = there.slice() else {
            return;
        };
        let found = match place {
            Place::Input(index, order) => self.inputs[index].as_ref().get(order),
            Place::Unknown(index, order) => self.unknowns[index].as_ref().get(order),
            Place::Sine(index) => self.sines[index].as_ref(),
            Place::Output(index, order) => self.outputs[index].as_ref().get(order),
        };
        // All targets are long enough, and the compiler does not know.
        let slice = slice.get_mut(self.start..).and_then(<[f64]>::first_chunk_mut);
        if let (Some(slice), Some(found)) = (slice, found) {
            *slice = found.0;
        }
    }
}

/// The inputs of one pose, and what became of it.
type Alone<M> = (
    <M as Mechanism>::Inputs<<M as Mechanism>::Motion<f64>>,
    Result<<M as Mechanism>::Pose, SolveError>,
);

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
    fn run<const W: usize, const FUSED: bool>(self) -> Summary {
        let Self {
            problem,
            poses,
            outcomes,
            ..
        } = self;
        let count = outcomes.len();
        let mut summary = Summary {
            solved: count,
            ..Summary::default()
        };
        let parameters = problem.parameters.as_ref();
        let columns = problem.inputs.as_ref();
        let mut dimensions: <M::With<Lanes<W, FUSED>> as Mechanism>::Parameters<Lanes<W, FUSED>> =
            Row::from_fn(|_| Lanes::constant(0.0));
        let mut inputs: <M::With<Lanes<W, FUSED>> as Mechanism>::Inputs<M::Motion<Lanes<W, FUSED>>> =
            Row::from_fn(|_| Row::from_fn(|_| Lanes::constant(0.0)));
        let varies = parameters.iter().any(|column| column.length().is_some());
        let mut next = 0;
        // Fewer than there are lanes are solved one by one.
        while next < count && count >= W {
            // The last poses of all go with some that have been solved before, and come to the same once more.
            let start = next.min(count - W);
            if varies || start == 0 {
                for (dimension, column) in dimensions.as_mut().iter_mut().zip(parameters) {
                    *dimension = gathered(*column, start);
                }
            }
            for (motion, columns) in inputs.as_mut().iter_mut().zip(columns) {
                for (entry, column) in motion.as_mut().iter_mut().zip(columns.as_ref()) {
                    *entry = gathered(*column, start);
                }
            }
            let chunk = Chunk::<M, W, FUSED> {
                mechanism: M::With::from_parameters(dimensions),
                inputs: &inputs,
            };
            let mut sum = Lanes([f64::NAN; W]);
            if let Ok(pose) = problem.guide.solve_chunk(&chunk, start) {
                let (unknowns, outputs) = (pose.unknown_columns(), pose.output_motions());
                let sines = pose.unknown_sines();
                // Finite if, and only if, all of them are, unless the sum itself goes beyond the range.
                sum = Lanes::constant(0.0);
                for motion in unknowns.as_ref() {
                    for entry in motion.as_ref() {
                        sum = sum + *entry;
                    }
                }
                for sine in sines.as_ref().iter().flatten() {
                    sum = sum + *sine;
                }
                for motion in outputs.as_ref() {
                    for entry in motion.as_ref() {
                        sum = sum + *entry;
                    }
                }
                poses.each(&mut Storing::<_, W, FUSED> {
                    start,
                    inputs: inputs.as_ref(),
                    unknowns: unknowns.as_ref(),
                    sines: sines.as_ref(),
                    outputs: outputs.as_ref(),
                });
            }
            if !sum.sum().is_finite() {
                for (lane, index) in (start..start + W).enumerate() {
                    if !sum.0[lane].is_finite() {
                        let result = problem.settle(index, poses);
                        if index >= next {
                            outcomes[index] = summary.note(index, result);
                        }
                    }
                }
            }
            next = start + W;
        }
        for (index, outcome) in outcomes.iter_mut().enumerate().skip(next) {
            *outcome = summary.note(index, problem.settle(index, poses));
        }
        summary
    }
}
