//! Batches of a solver that works on slices.

use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use core::any::Any;
use core::cell::Cell;
use core::fmt;
use core::ops::Range;

use super::conclusion::{Chunk, Conclusion};
use super::destination::{Entries, Stored};
use super::dispatch::{Kernel, Vectors, is_slow_in_halves};
use super::fold::{Piece, check_numbers, entries, fold_pieces};
use super::lanes::{Lanes, verdicts};
use super::outcome::{LengthMismatch, Outcome, Summary};
use super::transmission::TransmissionColumns;
use super::untyped::{ColumnChoice, GivenColumns, WantedColumns};
use super::view::{View, repeat};
use super::{Column, Fold, FoldError, FoldedNumber, InputGrid, Poses, Slot};
use crate::any::{Described, PositionChoice};
use crate::failure::SolveError;
use crate::number::Number;
use crate::picture::TransmissionAngle;
use crate::quantity::{Name, NameKind};
use crate::solve::Scalar;

/// A solver in numbers of any type, with memory that serves many poses.
pub trait SliceSolver: Described {
    /// The memory of the solver, which may be that of another solver of the same type.
    type Memory<T: Send + 'static>: Default + Send + 'static;

    /// Makes the memory large enough for so many chunks of poses.
    fn prepare<T: Scalar + Send + 'static>(&self, memory: &mut Self::Memory<T>, chunks: usize);

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

    /// Solves a chunk of poses, or `CHUNKS` of them side by side: as many as numbers are to be found for. The
    /// parameters and inputs of a chunk stand behind those of the chunk before; inputs are given with all orders.
    /// Values nearby choose the position of a single chunk only.
    ///
    /// # Errors
    /// Those of the solver, in the first chunk that fails as a whole. Numbers may be found that are not finite.
    fn solve<T: Scalar + Send + 'static, const CHUNKS: usize>(
        &self,
        memory: &mut Self::Memory<T>,
        parameters: &[T],
        inputs: &[T],
        choice: PositionChoice<'_, T>,
        found: &mut [Numbers<T>],
    ) -> Result<(), SolveError>;

    /// Calculates the transmission angles of a pose, or of a chunk of poses, from the inputs with all orders and the
    /// positions of the unknowns.
    fn angles_of_dyads<T: Scalar + Send + 'static>(
        &self,
        memory: &mut Self::Memory<T>,
        parameters: &[T],
        inputs: &[T],
        unknowns: &[T],
        angles: &mut [TransmissionAngle<T>],
    );
}

/// Memory that is kept from one batch to the next. A declared mechanism that runs without rustc takes it from here, and
/// a compiled one needs none.
#[derive(Default)]
pub struct KeptMemory(Option<Box<dyn Any + Send>>);

impl fmt::Debug for KeptMemory {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("KeptMemory").finish_non_exhaustive()
    }
}

impl KeptMemory {
    /// The memory of this type, which is empty if that of another type was kept.
    fn of<R: Default + Send + 'static>(&mut self) -> &mut R {
        if !self.0.as_ref().is_some_and(|kept| kept.is::<R>()) {
            self.0 = Some(Box::new(R::default()));
        }
        let kept = self.0.as_mut().and_then(|kept| kept.downcast_mut());
        kept.unwrap_or_else(|| unreachable!("memory of this type has just been put there"))
    }
}

/// The numbers of a pose, or of several.
#[derive(Debug)]
pub struct Numbers<T> {
    /// The positions of the unknowns, of directions the angles. It is empty where no transmission angles are wanted.
    pub positions: Vec<T>,
    /// The motions of the unknowns, one after the other. A direction has its cosine instead of its angle.
    pub unknowns: Vec<T>,
    /// The sines of directions.
    pub sines: Vec<Option<T>>,
    /// The motions of the outputs.
    pub outputs: Vec<T>,
}

impl<T> Default for Numbers<T> {
    fn default() -> Self {
        Self {
            positions: Vec::new(),
            unknowns: Vec::new(),
            sines: Vec::new(),
            outputs: Vec::new(),
        }
    }
}

impl<T: Scalar> Numbers<T> {
    /// Makes room for the numbers of a solver.
    fn prepare(&mut self, solver: &impl Described, has_angles: bool) {
        let description = solver.description();
        let (orders, unknowns) = (description.order + 1, description.unknowns.len());
        let zero = T::constant(0.0);
        self.positions.resize(if has_angles { unknowns } else { 0 }, zero);
        self.unknowns.resize(unknowns * orders, zero);
        self.sines.clear();
        self.sines.resize(unknowns, None);
        self.outputs.resize(description.outputs.len() * orders, zero);
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

/// What is given to a solver: the columns of its parameters, of all orders of its first input, of the second, …, and of
/// values nearby, unless the assembly is chosen.
struct Given<'g> {
    parameters: &'g [Column<'g>],
    inputs: Vec<Column<'g>>,
    near: &'g [Column<'g>],
    assembly: Option<usize>,
}

impl<'g> Given<'g> {
    /// The columns that a solver takes, or `None` if it has no such assembly.
    fn of(solver: &impl Described, given: GivenColumns<'g>) -> Option<Self> {
        let description = solver.description();
        let orders = description.order + 1;
        let assemblies = solver.assembly_count();
        let (assembly, near) = match given.choice {
            ColumnChoice::Near(near) if assemblies == 0 => (None, &near[..description.unknowns.len()]),
            ColumnChoice::Assembly(index) if index < assemblies => (Some(index), [].as_slice()),
            _ => return None,
        };
        let inputs = given.inputs[..description.inputs.len()].iter();
        let every_order = inputs
            .flat_map(|columns| (0..orders).map(|order| columns.get(order).copied().unwrap_or(Column::Same(0.0))));
        Some(Self {
            parameters: &given.parameters[..description.parameters.len()],
            inputs: every_order.collect(),
            near,
            assembly,
        })
    }

    /// Refuses columns of another length than there are poses.
    fn check(&self, solver: &impl Described, count: usize) -> Result<(), LengthMismatch> {
        let orders = solver.description().order + 1;
        let columns = [
            (NameKind::Parameter, self.parameters, 1),
            (NameKind::Input, &self.inputs, orders),
            (NameKind::Unknown, self.near, 1),
        ];
        for (kind, columns, orders) in columns {
            for (index, column) in columns.iter().enumerate() {
                check_length(solver, kind, index / orders, column.length(), count)?;
            }
        }
        Ok(())
    }
}

/// Refuses a column of another length than there are poses.
pub(crate) fn check_length(
    solver: &(impl Described + ?Sized),
    kind: NameKind,
    index: usize,
    length: Option<usize>,
    count: usize,
) -> Result<(), LengthMismatch> {
    match length {
        Some(length) if length != count => Err(LengthMismatch {
            quantity: solver.name(kind, index),
            poses: count,
            length,
        }),
        _ => Ok(()),
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
fn gather_each<const W: usize, const BITS: usize>(
    numbers: &mut [Lanes<W, BITS>],
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
    let count = outcomes.len();
    let Some(given) = Given::of(solver, given) else {
        outcomes.fill(Outcome::Failed);
        return Ok(Summary {
            failed: count,
            ..Summary::default()
        });
    };
    given.check(solver, count)?;
    let mut entries = Vec::new();
    for (slot, column) in wanted.iter_mut() {
        let (kind, index) = match *slot {
            Slot::Input(index, _) => (NameKind::Input, index),
            Slot::Unknown(index, _) | Slot::Sine(index) => (NameKind::Unknown, index),
            Slot::Output(index, _) => (NameKind::Output, index),
        };
        check_length(solver, kind, index, Some(column.len()), count)?;
        entries.push((*slot, Cell::from_mut(&mut **column).as_slice_of_cells()));
    }
    Ok(vectors.run(SliceRun {
        alone: PoseByPose {
            solver,
            parameters: given.parameters,
            inputs: &given.inputs,
            near: given.near,
            assembly: given.assembly,
            entries: &entries,
            angles: &TransmissionColumns::nowhere([].as_slice()),
            orders: solver.description().order + 1,
        },
        outcomes,
        memory: &mut KeptMemory::default(),
    }))
}

/// Summarises poses at evenly spaced values of an input, of a solver that works on slices, as
/// [`AnyFold`](super::AnyFold) does.
///
/// # Errors
/// Those of [`AnyFold`](super::AnyFold).
pub fn fold_slices<S: SliceSolver>(
    solver: &S,
    grid: InputGrid,
    given: GivenColumns<'_>,
    folds: &mut [Fold],
    memory: &mut KeptMemory,
    vectors: Vectors,
) -> Result<Summary, FoldError> {
    let orders = solver.description().order + 1;
    let missing = FoldError::NoSuchInput { input: grid.input };
    let given = Given::of(solver, given).filter(|given| given.assembly.is_some());
    let mut given = given.ok_or(missing)?;
    *given.inputs.get_mut(grid.input * orders).ok_or(missing)? = Column::Same(f64::NAN);
    check_numbers(folds, solver.description(), solver.dyad_count())?;
    given.check(solver, grid.poses)?;
    Ok(fold_pieces(&Poses::Grid(grid), folds, vectors, |piece| {
        let Piece {
            range,
            varied,
            folds,
            outcomes,
        } = piece;
        let (parameters, mut inputs) = (parts(given.parameters, &range), parts(&given.inputs, &range));
        inputs[grid.input * orders] = Column::Each(varied);
        let mut stored = Vec::with_capacity(folds.len());
        let of_dyads: Vec<Entries<'_, f64>> = vec![&[]; solver.dyad_count()];
        let mut angles = TransmissionColumns::nowhere(of_dyads);
        for (number, entries) in entries(folds, outcomes.len()) {
            match number {
                FoldedNumber::At(slot) => stored.push((slot, entries)),
                FoldedNumber::TransmissionAngle(dyad) => angles.of_dyads[dyad] = entries,
                FoldedNumber::SmallestTransmissionAngle => angles.smallest = entries,
            }
        }
        vectors.run(SliceRun {
            alone: PoseByPose {
                solver,
                parameters: &parameters,
                inputs: &inputs,
                near: &[],
                assembly: given.assembly,
                entries: &stored,
                angles: &TransmissionColumns {
                    of_dyads: angles.of_dyads.as_slice(),
                    smallest: angles.smallest,
                },
                orders,
            },
            outcomes,
            memory: &mut *memory,
        })
    }))
}

/// The columns of a range of poses.
fn parts<'c>(columns: &[Column<'c>], range: &Range<usize>) -> Vec<Column<'c>> {
    let columns = columns.iter();
    columns.map(|column| column.part(range.clone())).collect()
}

/// A batch with the columns for its results.
struct SliceRun<'r, S> {
    alone: PoseByPose<'r, S>,
    outcomes: &'r mut [Outcome],
    memory: &'r mut KeptMemory,
}

/// What a batch in lanes takes from memory that is kept.
struct Room<T, M> {
    /// The numbers that are the same in all poses: those of parameters, of inputs, and nearby.
    same: [Vec<T>; 3],
    parameters: Vec<T>,
    inputs: Vec<T>,
    near: Vec<T>,
    found: Vec<Numbers<T>>,
    angles: Vec<TransmissionAngle<T>>,
    solver: M,
}

impl<T, M: Default> Default for Room<T, M> {
    fn default() -> Self {
        Self {
            same: Default::default(),
            parameters: Vec::new(),
            inputs: Vec::new(),
            near: Vec::new(),
            found: Vec::new(),
            angles: Vec::new(),
            solver: M::default(),
        }
    }
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
    entries: &'r [(Slot, Entries<'r, f64>)],
    angles: &'r TransmissionColumns<Entries<'r, f64>, &'r [Entries<'r, f64>]>,
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
        let mut found = Numbers::default();
        let angles_are_wanted = self.angles.are_wanted();
        found.prepare(self.solver, angles_are_wanted);
        let result = self
            .solver
            .solve_alone(&parameters, &inputs, self.choice(&near), &mut found);
        if result.is_ok() {
            if angles_are_wanted {
                let (mut memory, mut angles) = (S::Memory::default(), self.no_angles());
                self.solver.prepare(&mut memory, 1);
                self.solver
                    .angles_of_dyads(&mut memory, &parameters, &inputs, &found.positions, &mut angles);
                self.angles.store(index, &angles);
            }
        } else {
            self.angles.leave_out(index);
            found.unknowns.fill(f64::NAN);
            found.sines.fill(Some(f64::NAN));
            found.outputs.fill(f64::NAN);
        }
        self.store(self.entries, index, &inputs, &found);
        result
    }

    /// Stores the numbers that are wanted in their columns, starting at a pose.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn store<C: Copy, V: Stored<C>>(&self, columns: &[(Slot, C)], start: usize, inputs: &[V], found: &Numbers<V>) {
        for (slot, column) in columns {
            match *slot {
                Slot::Input(index, order) => inputs[index * self.orders + order].store(*column, start),
                Slot::Unknown(index, order) => found.unknowns[index * self.orders + order].store(*column, start),
                Slot::Sine(index) => {
                    if let Some(sine) = found.sines[index] {
                        sine.store(*column, start);
                    }
                }
                Slot::Output(index, order) => found.outputs[index * self.orders + order].store(*column, start),
            }
        }
    }

    /// Room for the transmission angles, if any are wanted.
    fn no_angles<V: Scalar>(&self) -> Vec<TransmissionAngle<V>> {
        let zero = V::constant(0.0);
        let count = if self.angles.are_wanted() {
            self.solver.dyad_count()
        } else {
            0
        };
        vec![TransmissionAngle::of(Name::NONE, zero, zero); count]
    }

    /// Stores NaN as the sines of a pose that has failed.
    fn leave_out_sines(&self, index: usize) {
        for (slot, entries) in self.entries {
            if matches!(slot, Slot::Sine(_)) {
                f64::NAN.store(entries, index);
            }
        }
    }
}

impl<S: SliceSolver> Kernel for SliceRun<'_, S> {
    type Result = Summary;
    type Element = f64;

    /// As of a compiled mechanism, because the numbers of Newton's method depend on the poses that are solved together.
    #[inline]
    fn is_slow_in_halves(&self) -> bool {
        let solver = self.alone.solver;
        let description = solver.description();
        let results = description.unknowns.len() + description.outputs.len();
        is_slow_in_halves(
            solver.assembly_count(),
            results * self.alone.orders,
            self.outcomes.len(),
        )
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<const W: usize, const BITS: usize>(self) -> Summary {
        // in a constant, so that only one of the two is compiled
        if const { W > 8 } {
            self.run_in_chunks::<W, BITS, 4>()
        } else {
            self.run_in_chunks::<W, BITS, 8>()
        }
    }
}

impl<'r, S: SliceSolver> SliceRun<'r, S> {
    /// Solves `CHUNKS` chunks of `W` poses side by side: an operation is looked up once for all of them.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run_in_chunks<const W: usize, const BITS: usize, const CHUNKS: usize>(self) -> Summary {
        let Self {
            alone,
            outcomes,
            memory,
        } = self;
        let count = outcomes.len();
        let mut conclusion = Conclusion::of(count);
        outcomes.fill(Outcome::Solved);
        let zero = Lanes::<W, BITS>::constant(0.0);
        let Room {
            same,
            parameters,
            inputs,
            near,
            found,
            angles,
            solver: memory,
        } = memory.of::<Room<Lanes<W, BITS>, S::Memory<Lanes<W, BITS>>>>();
        let given = [alone.parameters, alone.inputs, alone.near];
        for (same, columns) in same.iter_mut().zip(given) {
            same.resize(columns.len(), zero);
            repeat(same, columns);
        }
        // the numbers of columns that are the same for all poses stay where they are
        let [parameter_columns, input_columns, near_columns] = given.map(each);
        let (parameter_count, input_count) = (alone.parameters.len(), alone.inputs.len());
        for (numbers, chunks, same) in [
            (&mut *parameters, CHUNKS, &same[0]),
            (&mut *inputs, CHUNKS, &same[1]),
            (&mut *near, 1, &same[2]),
        ] {
            numbers.clear();
            for _ in 0..chunks {
                numbers.extend_from_slice(same);
            }
        }
        alone.solver.prepare(memory, CHUNKS);
        found.resize_with(CHUNKS, Numbers::default);
        for found in found.iter_mut() {
            found.prepare(alone.solver, alone.angles.are_wanted());
        }
        *angles = alone.no_angles();
        let spare = core::array::from_fn(|_| Cell::new(0.0));
        let view = |entries: &Entries<'r, f64>| View::each(entries, &spare);
        let columns: Vec<_> = alone
            .entries
            .iter()
            .map(|(slot, entries)| (*slot, view(entries)))
            .collect();
        let angle_columns = TransmissionColumns {
            of_dyads: alone.angles.of_dyads.iter().map(view).collect::<Vec<_>>(),
            smallest: view(&alone.angles.smallest),
        };
        let mut next = 0;
        // The poses before this one are solved chunk by chunk, because some of them fail.
        let mut one_by_one = 0;
        // If there are fewer poses than lanes, they are solved one by one.
        while next < count && count >= W {
            // The last chunks overlap those before them. The overlapped poses are solved twice, with the same result.
            // None of them has failed, since what is stored of a failed pose would not be found again.
            let wide_start = next.min(count.saturating_sub(CHUNKS * W));
            let is_wide =
                alone.assembly.is_some() && wide_start >= one_by_one && next + W < count && count >= CHUNKS * W;
            let (chunks, start) = if is_wide {
                (CHUNKS, wide_start)
            } else {
                (1, next.min(count - W))
            };
            for chunk in 0..chunks {
                let (first_parameter, first_input) = (chunk * parameter_count, chunk * input_count);
                let start = start + chunk * W;
                gather_each(&mut parameters[first_parameter..], &parameter_columns, start);
                gather_each(&mut inputs[first_input..], &input_columns, start);
            }
            gather_each(near, &near_columns, start);
            verdicts::forget::<f64>();
            let result = alone.solver.solve::<_, CHUNKS>(
                memory,
                &parameters[..chunks * parameter_count],
                &inputs[..chunks * input_count],
                alone.choice(near),
                &mut found[..chunks],
            );
            let is_found = result.is_ok();
            let mut sum = Lanes([f64::NAN; W]);
            let mut is_finite = is_found;
            for (chunk, found) in found[..chunks].iter().enumerate() {
                if !is_finite {
                    break;
                }
                let parameters = &parameters[chunk * parameter_count..(chunk + 1) * parameter_count];
                let motions = &inputs[chunk * input_count..(chunk + 1) * input_count];
                sum = found.sum();
                if alone.angles.are_wanted() {
                    alone
                        .solver
                        .angles_of_dyads(memory, parameters, motions, &found.positions, angles);
                    sum = sum + angle_columns.store(start + chunk * W, angles);
                }
                is_finite = sum.is_finite_throughout();
            }
            if is_finite {
                for (chunk, found) in found[..chunks].iter().enumerate() {
                    let inputs = &inputs[chunk * input_count..(chunk + 1) * input_count];
                    alone.store(&columns, start + chunk * W, inputs, found);
                }
                next = start + chunks * W;
                continue;
            }
            if is_wide {
                one_by_one = start + CHUNKS * W;
                continue;
            }
            let (parameters, inputs, found) = (&parameters[..parameter_count], &inputs[..input_count], &mut found[0]);
            if !is_found {
                found.sines.fill(None);
            }
            alone.store(&columns, start, inputs, found);
            for (slot, view) in &columns {
                if matches!(slot, Slot::Unknown(..) | Slot::Output(..)) {
                    view.clear(start, sum.gaps());
                }
            }
            angle_columns.clear(start, sum.gaps());
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
