//! Batches of a solver that works on slices.

use alloc::vec;
use alloc::vec::Vec;
use core::cell::Cell;

use super::conclusion::{Chunk, Conclusion};
use super::destination::{Entries, Stored};
use super::dispatch::{Kernel, Vectors};
use super::lanes::{Lanes, verdicts};
use super::outcome::{LengthMismatch, Outcome, Summary};
use super::untyped::{ColumnChoice, GivenColumns, WantedColumns};
use super::view::repeat;
use super::{Column, Place};
use crate::any::{Described, PositionChoice};
use crate::failure::SolveError;
use crate::number::Number;
use crate::quantity::NameKind;
use crate::solve::Scalar;

/// A solver in numbers of any type, with memory that serves many poses.
pub trait SliceSolver: Described {
    /// The memory of the solver.
    type Memory<T>;

    /// Memory for numbers of one type, for [`CHUNKS`] chunks of poses.
    fn memory<T: Scalar>(&self) -> Self::Memory<T>;

    /// Solves a pose, as [`AnyMechanism`](crate::any::AnyMechanism) does.
    ///
    /// # Errors
    /// Those of the solver.
    fn solve_alone(
        &self,
        parameters: &[f64],
        inputs: &[f64],
        choice: PositionChoice<'_, f64>,
        found: &mut Numbers<f64>,
    ) -> Result<(), SolveError>;

    /// Solves a chunk of poses, or [`CHUNKS`] of them side by side: as many as numbers are to be found for. The parameters
    /// and inputs of a chunk stand behind those of the chunk before; inputs are given with all orders. Values nearby choose the
    /// position of a single chunk only.
    ///
    /// # Errors
    /// Those of the solver, in the first chunk that fails as a whole. Numbers may be found that are not finite.
    fn solve<T: Scalar>(
        &self,
        memory: &mut Self::Memory<T>,
        parameters: &[T],
        inputs: &[T],
        choice: PositionChoice<'_, T>,
        found: &mut [Numbers<T>],
    ) -> Result<(), SolveError>;
}

/// The chunks that are solved side by side: an operation is looked up once for all of them.
pub const CHUNKS: usize = 4;

/// The numbers of a pose, or of several.
#[derive(Debug)]
pub struct Numbers<T> {
    /// The motions of the unknowns, one after the other. A direction has its cosine in the place of its angle.
    pub unknowns: Vec<T>,
    /// The sines of directions.
    pub sines: Vec<Option<T>>,
    /// The motions of the outputs.
    pub outputs: Vec<T>,
}

impl<T: Scalar> Numbers<T> {
    fn of(solver: &impl Described) -> Self {
        let description = solver.description();
        let orders = description.order + 1;
        let zero = T::constant(0.0);
        Self {
            unknowns: vec![zero; description.unknowns.len() * orders],
            sines: vec![None; description.unknowns.len()],
            outputs: vec![zero; description.outputs.len() * orders],
        }
    }

    /// The sum of all numbers, which is finite if and only if all of them are, unless the sum itself overflows.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sum(&self) -> T {
        let mut sum = T::constant(-0.0);
        for entry in &self.unknowns {
            sum = sum + *entry;
        }
        for sine in self.sines.iter().flatten() {
            sum = sum + *sine;
        }
        for entry in &self.outputs {
            sum = sum + *entry;
        }
        sum
    }
}

/// The columns that differ from pose to pose, each with its index.
fn each<'c>(columns: &[Column<'c>]) -> Vec<(usize, &'c [f64])> {
    let columns = columns.iter().enumerate();
    let columns = columns.filter_map(|(index, column)| match column {
        Column::Each(numbers) => Some((index, *numbers)),
        Column::Same(_) => None,
    });
    columns.collect()
}

/// Fills in the numbers of such columns, starting at a given pose.
#[cfg_attr(not(debug_assertions), inline(always))]
fn gather_each<const W: usize, const FUSED: bool>(
    numbers: &mut [Lanes<W, FUSED>],
    columns: &[(usize, &[f64])],
    start: usize,
) {
    for (index, column) in columns {
        numbers[*index].0.copy_from_slice(&column[start..start + W]);
    }
}

/// Solves a batch of a solver that works on slices, as [`AnyBatch`](super::AnyBatch) does.
///
/// # Errors
/// [`LengthMismatch`] if the length of a column differs from the number of outcomes.
pub fn solve_slices<S: SliceSolver>(
    solver: &S,
    given: GivenColumns<'_>,
    wanted: &mut WantedColumns<'_>,
    outcomes: &mut [Outcome],
    vectors: Vectors,
) -> Result<Summary, LengthMismatch> {
    let description = solver.description();
    let orders = description.order + 1;
    let count = outcomes.len();
    let assemblies = solver.assembly_count();
    let (guide, near) = match given.choice {
        ColumnChoice::Near(near) if assemblies == 0 => (None, near),
        ColumnChoice::Assembly(index) if index < assemblies => (Some(index), [].as_slice()),
        _ => {
            outcomes.fill(Outcome::Failed);
            return Ok(Summary {
                failed: count,
                ..Summary::default()
            });
        }
    };
    let inputs: Vec<Column<'_>> = given.inputs[..description.inputs.len()]
        .iter()
        .flat_map(|columns| (0..orders).map(|order| columns.get(order).copied().unwrap_or(Column::Same(0.0))))
        .collect();
    let check = |kind, index: usize, length: Option<usize>| match length {
        Some(length) if length != count => Err(LengthMismatch {
            quantity: solver.name(kind, index),
            poses: count,
            length,
        }),
        _ => Ok(()),
    };
    let parameters = &given.parameters[..description.parameters.len()];
    let near = &near[..if guide.is_none() { description.unknowns.len() } else { 0 }];
    for (index, column) in parameters.iter().enumerate() {
        check(NameKind::Parameter, index, column.length())?;
    }
    for (index, column) in inputs.iter().enumerate() {
        check(NameKind::Input, index / orders, column.length())?;
    }
    for (index, column) in near.iter().enumerate() {
        check(NameKind::Unknown, index, column.length())?;
    }
    let mut entries = Vec::new();
    for (place, column) in wanted.iter_mut() {
        let (kind, index) = match *place {
            Place::Input(index, _) => (NameKind::Input, index),
            Place::Unknown(index, _) | Place::Sine(index) => (NameKind::Unknown, index),
            Place::Output(index, _) => (NameKind::Output, index),
        };
        check(kind, index, Some(column.len()))?;
        entries.push((*place, Cell::from_mut(&mut **column).as_slice_of_cells()));
    }
    Ok(vectors.run(SliceRun {
        alone: PoseByPose {
            solver,
            parameters,
            inputs: &inputs,
            near,
            assembly: guide,
            entries: &entries,
            orders,
        },
        outcomes,
    }))
}

/// A batch with the places for its results.
struct SliceRun<'r, S> {
    alone: PoseByPose<'r, S>,
    outcomes: &'r mut [Outcome],
}

/// A batch whose poses can be solved alone.
struct PoseByPose<'r, S> {
    solver: &'r S,
    parameters: &'r [Column<'r>],
    /// All orders of the first input, then of the second, ….
    inputs: &'r [Column<'r>],
    near: &'r [Column<'r>],
    /// The assembly, unless values nearby choose the position.
    assembly: Option<usize>,
    entries: &'r [(Place, Entries<'r, f64>)],
    orders: usize,
}

impl<S: SliceSolver> PoseByPose<'_, S> {
    fn choice<'n, T>(&self, near: &'n [T]) -> PositionChoice<'n, T> {
        self.assembly
            .map_or(PositionChoice::Near(near), PositionChoice::Assembly)
    }

    /// Solves a pose alone and stores it.
    #[cold]
    #[inline(never)]
    fn settle(&self, index: usize) -> Result<(), SolveError> {
        let at = |columns: &[Column<'_>]| columns.iter().map(|column| column.at(index)).collect::<Vec<f64>>();
        let (parameters, inputs, near) = (at(self.parameters), at(self.inputs), at(self.near));
        let mut found = Numbers::of(self.solver);
        let result = self
            .solver
            .solve_alone(&parameters, &inputs, self.choice(&near), &mut found);
        if result.is_err() {
            found.unknowns.fill(f64::NAN);
            found.sines.fill(Some(f64::NAN));
            found.outputs.fill(f64::NAN);
        }
        self.store(index, &inputs, &found, None);
        result
    }

    /// Stores the numbers that are wanted, starting at a pose. If poses have failed, `gone` is NaN for these and zero for
    /// the others, and is taken away from all numbers except those of the inputs.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn store<V: Stored<Element = f64>>(&self, start: usize, inputs: &[V], found: &Numbers<V>, gone: Option<V>) {
        let less = |number: V| gone.map_or(number, |gone| number - gone);
        for (place, entries) in self.entries {
            match *place {
                Place::Input(index, order) => inputs[index * self.orders + order].store(entries, start),
                Place::Unknown(index, order) => {
                    less(found.unknowns[index * self.orders + order]).store(entries, start);
                }
                Place::Sine(index) => {
                    if let Some(sine) = found.sines[index] {
                        less(sine).store(entries, start);
                    }
                }
                Place::Output(index, order) => less(found.outputs[index * self.orders + order]).store(entries, start),
            }
        }
    }

    /// Stores NaN in the place of the sines of a pose that has failed.
    fn leave_out_sines(&self, index: usize) {
        for (place, entries) in self.entries {
            if matches!(place, Place::Sine(_)) {
                f64::NAN.store(entries, index);
            }
        }
    }
}

impl<S: SliceSolver> Kernel for SliceRun<'_, S> {
    type Result = Summary;
    type Element = f64;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<const W: usize, const FUSED: bool>(self) -> Summary {
        let Self { alone, outcomes } = self;
        let count = outcomes.len();
        let mut conclusion = Conclusion::of(count);
        outcomes.fill(Outcome::Solved);
        let zero = Lanes::<W, FUSED>::constant(0.0);
        let lanes = |columns: &[Column<'_>]| {
            let mut same = vec![zero; columns.len()];
            repeat(&mut same, columns);
            same
        };
        let (same_parameters, same_inputs, same_near) =
            (lanes(alone.parameters), lanes(alone.inputs), lanes(alone.near));
        // the numbers of columns that are the same for all poses stay where they are
        let [parameter_columns, input_columns, near_columns] = [alone.parameters, alone.inputs, alone.near].map(each);
        let mut near = same_near;
        let (mut parameters, mut inputs) = (same_parameters.repeat(CHUNKS), same_inputs.repeat(CHUNKS));
        let (parameter_count, input_count) = (alone.parameters.len(), alone.inputs.len());
        let mut memory = alone.solver.memory::<Lanes<W, FUSED>>();
        let mut found: Vec<_> = (0..CHUNKS)
            .map(|_| Numbers::<Lanes<W, FUSED>>::of(alone.solver))
            .collect();
        let mut next = 0;
        // The poses before this one are solved chunk by chunk, because some of them fail.
        let mut one_by_one = 0;
        // If there are fewer poses than lanes, they are solved one by one.
        while next < count && count >= W {
            let is_wide = alone.assembly.is_some() && next >= one_by_one && next + CHUNKS * W <= count;
            let chunks = if is_wide { CHUNKS } else { 1 };
            // The last chunk overlaps the one before it. The overlapped poses are solved twice, with the same result.
            let start = next.min(count - W);
            for chunk in 0..chunks {
                let (own, first) = (chunk * parameter_count, chunk * input_count);
                let start = start + chunk * W;
                gather_each(&mut parameters[own..], &parameter_columns, start);
                gather_each(&mut inputs[first..], &input_columns, start);
            }
            gather_each(&mut near, &near_columns, start);
            verdicts::forget::<f64>();
            let result = alone.solver.solve(
                &mut memory,
                &parameters[..chunks * parameter_count],
                &inputs[..chunks * input_count],
                alone.choice(&near),
                &mut found[..chunks],
            );
            let is_found = result.is_ok();
            if is_found && found[..chunks].iter().all(|found| found.sum().is_finite_throughout()) {
                for (chunk, found) in found[..chunks].iter().enumerate() {
                    let own = &inputs[chunk * input_count..(chunk + 1) * input_count];
                    alone.store(start + chunk * W, own, found, None);
                }
                next = start + chunks * W;
                continue;
            }
            if is_wide {
                one_by_one = next + CHUNKS * W;
                continue;
            }
            let (parameters, inputs, found) = (&parameters[..parameter_count], &inputs[..input_count], &mut found[0]);
            let mut sum = Lanes([f64::NAN; W]);
            if is_found {
                sum = found.sum();
                alone.store(start, inputs, found, Some(sum.gaps()));
            } else {
                found.unknowns.fill(sum);
                found.outputs.fill(sum);
                found.sines.fill(None);
                alone.store(start, inputs, found, None);
            }
            let mut squares = Lanes::constant(0.0);
            for entry in parameters {
                squares = squares.plus_product(*entry, *entry);
            }
            for entry in inputs.iter().step_by(alone.orders) {
                squares = squares.plus_product(*entry, *entry);
            }
            let chunk = Chunk {
                start,
                next,
                sum,
                squares,
            };
            conclusion.add(chunk, outcomes, |index| alone.settle(index));
            for (index, outcome) in outcomes.iter().enumerate().skip(start).take(W) {
                if !outcome.is_solved() {
                    alone.leave_out_sines(index);
                }
            }
            next = start + W;
        }
        conclusion.end(next, outcomes, |index| alone.settle(index))
    }
}
