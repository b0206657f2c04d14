//! The solution of a batch, chunk by chunk.

use core::cell::Cell;
use core::ops::Range;

use num_traits::{Float, Zero};

use super::Column;
use super::conclusion::{Chunk, Conclusion};
use super::destination::{Destination, EntriesOf, Ordinary, ViewOf, numbers};
use super::dispatch::{Kernel, Vectors, is_slow_in_halves};
use super::outcome::{LengthMismatch, Outcome, Summary};
use super::stream::Streams;
use super::target::{Columns, Target};
use super::transmission::{TransmissionColumns, angles_at};
use super::view::{View, gather, gather_all, look, look_at_entries, repeat};
use crate::batch::lanes::{Element, Lanes, verdicts};
use crate::failure::SolveError;
use crate::load::{Balance, LoadError, Loaded as _, LoadsOf};
use crate::mechanism::{Mechanism, Pose};
use crate::number::{Number, Row};

/// The inputs of as many poses as there are lanes, with their derivatives.
type MotionsInLanes<M, const W: usize, const BITS: usize> =
    <<M as Mechanism>::With<Lanes<W, BITS, <M as Mechanism>::Scalar>> as Mechanism>::Inputs<
        <M as Mechanism>::Motion<Lanes<W, BITS, <M as Mechanism>::Scalar>>,
    >;

/// Parameters, unknowns and what depends on the parameters alone, of as many poses as there are lanes.
type ParametersInLanes<M, const W: usize, const BITS: usize> = <<M as Mechanism>::With<
    Lanes<W, BITS, <M as Mechanism>::Scalar>,
> as Mechanism>::Parameters<Lanes<W, BITS, <M as Mechanism>::Scalar>>;
type UnknownsInLanes<M, const W: usize, const BITS: usize> = <<M as Mechanism>::With<
    Lanes<W, BITS, <M as Mechanism>::Scalar>,
> as Mechanism>::Unknowns<Lanes<W, BITS, <M as Mechanism>::Scalar>>;
type PreparedInLanes<M, const W: usize, const BITS: usize> =
    <<M as Mechanism>::With<Lanes<W, BITS, <M as Mechanism>::Scalar>> as Mechanism>::Prepared;

/// The entries of the transmission angles of a declared mechanism.
pub(super) type AngleEntries<'t, M> = TransmissionColumns<EntriesOf<'t, M>, <M as Mechanism>::Dyads<EntriesOf<'t, M>>>;

/// Many poses of one mechanism, or of many that differ in their dimensions: columns in, columns out.
///
/// The method `batch` of a mechanism makes it. [`new`](Self::new) and [`near`](Self::near) make it for any mechanism,
/// with the columns in the order of parameters, inputs and unknowns. `G` is the choice among several positions, which
/// these methods set.
///
/// | for | see |
/// |---|---|
/// | the motions of all poses, in columns | [`solve`](Self::solve) |
/// | summaries of their numbers, without storing the poses | [`fold`](Self::fold) |
/// | the balance of loads in all poses | [`balance`](Self::balance) |
/// | all cores | `on_all_cores` (feature `rayon`) |
#[must_use = "`solve` it, `fold` it or ask for its `balance`"]
#[derive(Clone, Copy, Debug)]
pub struct Batch<'a, M: Mechanism, G> {
    pub(super) parameters: M::Parameters<Column<'a, M::Scalar>>,
    pub(super) inputs: M::Inputs<M::Motion<Column<'a, M::Scalar>>>,
    pub(super) guide: G,
    pub(super) vectors: Vectors,
    /// The number of poses of the batch that is solved with this one, if this is a piece of it; otherwise 0.
    pub(super) whole: usize,
}

impl<'a, M: Mechanism> Batch<'a, M, InAssembly<M::Assembly>> {
    /// All poses in one assembly.
    pub fn new(
        parameters: M::Parameters<Column<'a, M::Scalar>>,
        inputs: M::Inputs<M::Motion<Column<'a, M::Scalar>>>,
        assembly: M::Assembly,
    ) -> Self {
        Self {
            parameters,
            inputs,
            guide: InAssembly(assembly),
            vectors: Vectors::widest(),
            whole: 0,
        }
    }
}

impl<'a, M: Mechanism> Batch<'a, M, Nearest<M::Unknowns<Column<'a, M::Scalar>>>> {
    /// Each pose closest to values of the unknowns: a column for each of them.
    pub fn near(
        parameters: M::Parameters<Column<'a, M::Scalar>>,
        inputs: M::Inputs<M::Motion<Column<'a, M::Scalar>>>,
        near: M::Unknowns<Column<'a, M::Scalar>>,
    ) -> Self {
        Self {
            parameters,
            inputs,
            guide: Nearest(near),
            vectors: Vectors::widest(),
            whole: 0,
        }
    }
}

impl<M: Mechanism, G> Batch<'_, M, G> {
    /// Other vectors than the widest of the machine. The numbers of a pose differ between them by rounding.
    pub fn vectors(mut self, vectors: Vectors) -> Self {
        self.vectors = vectors;
        self
    }
}

/// The choice among several positions, for each pose. A new version may add items.
pub trait Guide<'a, M: Mechanism<Scalar: Element>>: Copy {
    /// Whether values near each pose make the choice.
    const IS_NEAR: bool;

    /// The values near each pose, if they make the choice.
    fn near(self) -> M::Unknowns<Column<'a, M::Scalar>>;

    /// The guide restricted to a range of poses.
    fn part<'b>(self, range: Range<usize>) -> impl Guide<'b, M>
    where
        'a: 'b;

    /// Solves one pose, or several.
    ///
    /// # Errors
    /// Those of the solvers.
    fn solve<T: Mechanism<Assembly = M::Assembly>>(
        self,
        mechanism: &T,
        prepared: &T::Prepared,
        inputs: T::Inputs<T::Motion<T::Scalar>>,
        near: T::Unknowns<T::Scalar>,
    ) -> Result<T::Pose, SolveError>;

    /// The balance of one pose.
    ///
    /// # Errors
    /// Those of [`Loaded::balance`](crate::load::Loaded::balance).
    fn balance(
        self,
        mechanism: &M,
        loads: &impl LoadsOf<M>,
        inputs: M::Inputs<M::Motion<M::Scalar>>,
        near: M::Unknowns<M::Scalar>,
    ) -> Result<Balance<M>, LoadError>;
}

/// A guide that chooses positions by assembly.
#[derive(Clone, Copy, Debug)]
pub struct InAssembly<A>(pub(super) A);

/// A guide that chooses the positions closest to values of the unknowns.
#[derive(Clone, Copy, Debug)]
pub struct Nearest<C>(pub(super) C);

impl<'a, M: Mechanism<Scalar: Element>> Guide<'a, M> for InAssembly<M::Assembly> {
    const IS_NEAR: bool = false;

    fn near(self) -> M::Unknowns<Column<'a, M::Scalar>> {
        Row::splat(Column::Same(M::Scalar::nan()))
    }

    fn part<'b>(self, _: Range<usize>) -> impl Guide<'b, M>
    where
        'a: 'b,
    {
        self
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn solve<T: Mechanism<Assembly = M::Assembly>>(
        self,
        mechanism: &T,
        prepared: &T::Prepared,
        inputs: T::Inputs<T::Motion<T::Scalar>>,
        _: T::Unknowns<T::Scalar>,
    ) -> Result<T::Pose, SolveError> {
        mechanism.solve_prepared(prepared, inputs, self.0)
    }

    fn balance(
        self,
        mechanism: &M,
        loads: &impl LoadsOf<M>,
        inputs: M::Inputs<M::Motion<M::Scalar>>,
        _: M::Unknowns<M::Scalar>,
    ) -> Result<Balance<M>, LoadError> {
        mechanism.balance(loads, inputs, self.0)
    }
}

impl<'a, M: Mechanism<Scalar: Element>, C: Row<Column<'a, M::Scalar>>> Guide<'a, M> for Nearest<C> {
    const IS_NEAR: bool = true;

    fn near(self) -> M::Unknowns<Column<'a, M::Scalar>> {
        Row::from_fn(|unknown| self.0[unknown])
    }

    fn part<'b>(self, range: Range<usize>) -> impl Guide<'b, M>
    where
        'a: 'b,
    {
        let near: M::Unknowns<Column<'b, M::Scalar>> = Row::from_fn(|unknown| self.0[unknown].part(range.clone()));
        Nearest(near)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn solve<T: Mechanism<Assembly = M::Assembly>>(
        self,
        mechanism: &T,
        _: &T::Prepared,
        inputs: T::Inputs<T::Motion<T::Scalar>>,
        near: T::Unknowns<T::Scalar>,
    ) -> Result<T::Pose, SolveError> {
        mechanism.solve_near(inputs, near)
    }

    fn balance(
        self,
        mechanism: &M,
        loads: &impl LoadsOf<M>,
        inputs: M::Inputs<M::Motion<M::Scalar>>,
        near: M::Unknowns<M::Scalar>,
    ) -> Result<Balance<M>, LoadError> {
        mechanism.balance_near(loads, inputs, near)
    }
}

impl<'a, M: Mechanism<Scalar: Element>, G: Guide<'a, M>> Batch<'a, M, G> {
    /// Solves all poses: writes their motions to the columns of `poses`, and an outcome for each pose. Nothing is
    /// allocated.
    ///
    /// # Errors
    /// [`LengthMismatch`] if the length of a column differs from the number of outcomes. Nothing is solved then. The
    /// outcome of a pose says whether it was solved.
    pub fn solve<P: Columns<C>, C: Target<M::Scalar>>(
        &self,
        poses: &mut P,
        outcomes: &mut [Outcome],
    ) -> Result<Summary, LengthMismatch> {
        self.check_lengths(outcomes.len())?;
        self.sweep(poses, outcomes)
    }

    /// [`solve`](Self::solve) with input columns whose lengths have been checked.
    pub(super) fn sweep<P: Columns<C>, C: Target<M::Scalar>>(
        &self,
        poses: &mut P,
        outcomes: &mut [Outcome],
    ) -> Result<Summary, LengthMismatch> {
        let mut destination = Destination::nowhere();
        destination.find(poses, outcomes.len())?;
        let nowhere: EntriesOf<'_, M> = &[];
        let angles = TransmissionColumns::nowhere(Row::splat(nowhere));
        Ok(self.store(&destination, &angles, outcomes))
    }

    /// Solves poses and stores their numbers and their transmission angles.
    pub(super) fn store<'d>(
        &self,
        destination: &Destination<M, EntriesOf<'d, M>>,
        angles: &AngleEntries<'d, M>,
        outcomes: &mut [Outcome],
    ) -> Summary {
        self.vectors.run(BatchRun {
            alone: PoseByPose {
                batch: self,
                near: &self.guide.near(),
                destination,
                angles,
            },
            outcomes,
        })
    }

    /// The columns of a range of poses.
    pub(super) fn part<'b>(&self, range: Range<usize>) -> Batch<'b, M, impl Guide<'b, M>>
    where
        'a: 'b,
    {
        let (parameters, inputs) = (self.parameters.as_ref(), self.inputs.as_ref());
        Batch {
            vectors: self.vectors,
            whole: self.whole,
            parameters: Row::from_fn(|parameter| parameters[parameter].part(range.clone())),
            inputs: M::Inputs::from_fn(|input| {
                let motion = inputs[input].as_ref();
                <M::Motion<Column<'b, M::Scalar>> as Row<Column<'b, M::Scalar>>>::from_fn(|order| {
                    motion[order].part(range.clone())
                })
            }),
            guide: self.guide.part(range),
        }
    }

    pub(super) fn check_lengths(&self, count: usize) -> Result<(), LengthMismatch> {
        let description = M::DESCRIPTION;
        let check = |quantity: &'static str, length: Option<usize>| match length {
            Some(length) if length != count => Err(LengthMismatch {
                quantity: quantity.into(),
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
        for (column, quantity) in self.guide.near().as_ref().iter().zip(description.unknowns) {
            check(quantity.name, column.length())?;
        }
        Ok(())
    }
}

/// A batch with the columns for its results.
struct BatchRun<'p, 'd, 'a, M: Mechanism<Scalar: Element>, G> {
    alone: PoseByPose<'p, 'd, 'a, M, G>,
    outcomes: &'p mut [Outcome],
}

/// A batch whose poses can be solved alone.
struct PoseByPose<'p, 'd, 'a, M: Mechanism<Scalar: Element>, G> {
    batch: &'p Batch<'a, M, G>,
    near: &'p M::Unknowns<Column<'a, M::Scalar>>,
    destination: &'p Destination<M, EntriesOf<'d, M>>,
    angles: &'p AngleEntries<'d, M>,
}

impl<'a, M: Mechanism<Scalar: Element>, G: Guide<'a, M>> PoseByPose<'_, '_, 'a, M, G> {
    /// Solves a pose alone and stores it.
    #[cold]
    #[inline(never)]
    fn settle(&self, index: usize) -> Result<(), SolveError> {
        let (parameters, inputs) = (self.batch.parameters.as_ref(), self.batch.inputs.as_ref());
        let mechanism = M::from_parameters(Row::from_fn(|parameter| parameters[parameter].at(index)));
        let inputs = M::Inputs::from_fn(|input| M::Motion::from_fn(|order| inputs[input][order].at(index)));
        let near = M::Unknowns::from_fn(|unknown| self.near[unknown].at(index));
        let nothing = M::Motion::splat(M::Scalar::nan());
        let prepared = mechanism.prepare();
        let (unknowns, sines, outputs, result) = match self.batch.guide.solve(&mechanism, &prepared, inputs, near) {
            Ok(pose) => {
                if self.angles.are_wanted() {
                    self.angles.store(index, angles_at(&mechanism, &inputs, &pose).as_ref());
                }
                (
                    pose.unknown_columns(),
                    pose.unknown_sines(),
                    pose.output_motions(),
                    Ok(()),
                )
            }
            Err(error) => {
                self.angles.leave_out(index);
                (
                    Row::splat(nothing),
                    Row::splat(Some(M::Scalar::nan())),
                    Row::splat(nothing),
                    Err(error),
                )
            }
        };
        self.destination.store_inputs(index, inputs.as_ref());
        self.destination
            .store(Ordinary, index, unknowns.as_ref(), sines.as_ref(), outputs.as_ref());
        result
    }
}

impl<'a, M: Mechanism<Scalar: Element>, G: Guide<'a, M>> Kernel for BatchRun<'_, '_, 'a, M, G> {
    type Result = Summary;
    type Element = M::Scalar;

    #[inline]
    fn is_slow_in_halves(&self) -> bool {
        is_slow_in_halves(M::ASSEMBLY_COUNT, numbers::<M>(), self.outcomes.len())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<const W: usize, const BITS: usize>(self) -> Summary {
        let Self { alone, outcomes } = self;
        let batch = alone.batch;
        let count = outcomes.len();
        let mut conclusion = Conclusion::of(count);
        // Assume every pose is solved; failures overwrite this below. Copy in chunks, because single stores would use
        // the narrowest instructions.
        let (chunks, rest) = outcomes.as_chunks_mut::<W>();
        for chunk in chunks {
            chunk.copy_from_slice(const { &[Outcome::Solved; W] });
        }
        rest.fill(Outcome::Solved);
        let zero = Lanes::<W, BITS, M::Scalar>::constant(0.0);
        let spare = core::array::from_fn(|_| Cell::new(M::Scalar::zero()));
        let mut chunks = alone.destination.in_chunks(&spare);
        let mut of_dyads = M::Dyads::splat(View::same(&spare));
        look_at_entries(of_dyads.as_mut(), alone.angles.of_dyads.as_ref(), &spare);
        let angles = TransmissionColumns {
            of_dyads,
            smallest: View::each(alone.angles.smallest, &spare),
        };
        let (columns, mut same) = (batch.parameters.as_ref(), M::Parameters::splat(zero));
        repeat(same.as_mut(), columns);
        let mut parameters = M::Parameters::splat(View::same(&zero.0));
        look(parameters.as_mut(), columns, same.as_ref());
        let (columns, mut same) = (batch.inputs.as_ref(), M::Inputs::splat(M::Motion::splat(zero)));
        for (same, columns) in same.as_mut().iter_mut().zip(columns) {
            repeat(same.as_mut(), columns.as_ref());
        }
        let mut inputs = M::Inputs::splat(M::Motion::splat(View::same(&zero.0)));
        for ((views, columns), same) in inputs.as_mut().iter_mut().zip(columns).zip(same.as_ref()) {
            look(views.as_mut(), columns.as_ref(), same.as_ref());
        }
        let (columns, mut same) = (alone.near.as_ref(), M::Unknowns::splat(zero));
        let mut near = M::Unknowns::splat(View::same(&zero.0));
        if G::IS_NEAR {
            repeat(same.as_mut(), columns);
            look(near.as_mut(), columns, same.as_ref());
        }
        let second = if const { M::ASSEMBLY_COUNT > 0 } {
            alone.destination.second_chunk::<W>()
        } else {
            W
        };
        let mut stages = None;
        let whole = count.max(batch.whole);
        let mut streams = Streams::new(alone.destination, whole, second + W, &mut stages, &spare);
        let run = ChunkRun {
            guide: batch.guide,
            parameters,
            inputs,
            near,
            angles,
            has_inputs: alone.destination.has_inputs(),
            has_angles: alone.angles.are_wanted(),
            are_same: batch.parameters.as_ref().iter().all(|column| column.length().is_none()),
        };
        let mut kept = Kept {
            dimensions: Row::splat(zero),
            prepared: None,
            is_prepared: false,
        };
        let has_sines = alone.destination.has_sines();
        // the first pose without an outcome
        let mut next = 0;
        // If there are fewer poses than lanes, they are solved one by one.
        while next < count && count >= W {
            // The last chunk overlaps the one before it, and the second one may. The overlapped poses are solved twice,
            // with the same result.
            let start = if next == W { second } else { next }.min(count - W);
            let sum = if const { Streams::<M, W, BITS>::PAST } && streams.passes(start) {
                run.solve::<true, _>(start, &mut kept, &mut streams, &mut chunks)
            } else {
                run.solve::<false, _>(start, &mut kept, &mut streams, &mut chunks)
            };
            if sum.is_finite_throughout() {
                streams.advance();
                next = start + W;
                continue;
            }
            streams.interrupt(start, &mut chunks);
            chunks.clear(start, sum.gaps());
            let squares = run.clear(start, &mut kept, sum.gaps());
            let chunk = Chunk {
                start,
                next,
                sum,
                squares,
            };
            conclusion.add(chunk, outcomes, |index| alone.settle(index));
            if has_sines {
                for (index, outcome) in outcomes.iter().enumerate().skip(start).take(W) {
                    if !outcome.is_solved() {
                        alone.destination.leave_out_sines(index);
                    }
                }
            }
            next = start + W;
        }
        streams.end();
        conclusion.end(next, outcomes, |index| alone.settle(index))
    }
}

/// What is given for the chunks of a batch, with the columns in the form in which lanes read them.
struct ChunkRun<'s, M: Mechanism<Scalar: Element>, G, const W: usize> {
    guide: G,
    parameters: M::Parameters<View<'s, M::Scalar, W>>,
    inputs: M::Inputs<M::Motion<View<'s, M::Scalar, W>>>,
    near: M::Unknowns<View<'s, M::Scalar, W>>,
    angles: TransmissionColumns<ViewOf<'s, M, W>, M::Dyads<ViewOf<'s, M, W>>>,
    has_inputs: bool,
    has_angles: bool,
    /// Whether the parameters of all poses are the same.
    are_same: bool,
}

/// What is kept from one chunk to the next.
struct Kept<M: Mechanism<Scalar: Element>, const W: usize, const BITS: usize> {
    dimensions: ParametersInLanes<M, W, BITS>,
    prepared: Option<PreparedInLanes<M, W, BITS>>,
    /// Whether dimensions and what is prepared are those of all chunks.
    is_prepared: bool,
}

impl<'a, 's, M: Mechanism<Scalar: Element>, G: Guide<'a, M>, const W: usize> ChunkRun<'s, M, G, W> {
    /// Solves the chunk that starts at a given pose and stores its numbers, which [pass](Streams::passes) the caches or
    /// not. Returns the sum of all numbers of each pose: NaN if the chunk fails as a whole.
    ///
    /// The given numbers are gathered where they are needed, and again where they are needed later: if they were kept,
    /// those that are found would not fit into the registers. For the same reason all numbers are stored before they
    /// are tested.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn solve<const PASSES: bool, const BITS: usize>(
        &self,
        start: usize,
        kept: &mut Kept<M, W, BITS>,
        streams: &mut Streams<'s, '_, M, W, BITS>,
        chunks: &mut Destination<M, ViewOf<'s, M, W>>,
    ) -> Lanes<W, BITS, M::Scalar> {
        let zero = Lanes::constant(0.0);
        let mut motions: MotionsInLanes<M, W, BITS> = Row::splat(Row::splat(zero));
        let mut guess: UnknownsInLanes<M, W, BITS> = Row::splat(zero);
        if self.has_inputs {
            gather_all(&mut motions, self.inputs.as_ref(), start);
            chunks.store_inputs(start, motions.as_ref());
        }
        // those of the chunk before are still there if they are the same for all poses
        if !kept.is_prepared {
            gather(&mut kept.dimensions, self.parameters.as_ref(), start);
        }
        if G::IS_NEAR {
            gather(&mut guess, self.near.as_ref(), start);
        }
        gather_all(&mut motions, self.inputs.as_ref(), start);
        let mechanism = M::With::from_parameters(kept.dimensions);
        verdicts::forget::<M::Scalar>();
        if !kept.is_prepared {
            kept.prepared = Some(mechanism.prepare());
            // a verdict about the parameters is left again for each chunk
            kept.is_prepared = self.are_same && verdicts::are_none::<W, BITS, M::Scalar>();
        }
        let Some(prepared) = &kept.prepared else {
            return Lanes([M::Scalar::nan(); W]);
        };
        let Ok(pose) = self.guide.solve(&mechanism, prepared, motions, guess) else {
            return Lanes([M::Scalar::nan(); W]);
        };
        let (unknowns, sines, outputs) = (pose.unknown_columns(), pose.unknown_sines(), pose.output_motions());
        let (unknowns, sines, outputs) = (unknowns.as_ref(), sines.as_ref(), outputs.as_ref());
        let mut sum = streams.store::<PASSES, _>(start, chunks, unknowns, sines, outputs);
        if self.has_angles {
            gather(&mut kept.dimensions, self.parameters.as_ref(), start);
            gather_all(&mut motions, self.inputs.as_ref(), start);
            let mechanism = M::With::from_parameters(kept.dimensions);
            let angles = angles_at(&mechanism, &motions, &pose);
            sum = sum + self.angles.store(start, angles.as_ref());
        }
        sum
    }

    /// Stores NaN in the place of the transmission angles of some poses: where `gone` is NaN. It is a negative zero for
    /// the others. Returns the sum of the squares of parameters and inputs.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn clear<const BITS: usize>(
        &self,
        start: usize,
        kept: &mut Kept<M, W, BITS>,
        gone: Lanes<W, BITS, M::Scalar>,
    ) -> Lanes<W, BITS, M::Scalar> {
        let mut motions: MotionsInLanes<M, W, BITS> = Row::splat(Row::splat(Lanes::constant(0.0)));
        self.angles.clear(start, gone);
        gather(&mut kept.dimensions, self.parameters.as_ref(), start);
        gather_all(&mut motions, self.inputs.as_ref(), start);
        let mut squares = Lanes::constant(0.0);
        for entry in kept.dimensions.as_ref() {
            squares = squares.plus_product(*entry, *entry);
        }
        for motion in motions.as_ref() {
            squares = squares.plus_product(motion[0], motion[0]);
        }
        squares
    }
}
