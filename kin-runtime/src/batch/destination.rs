//! The columns into which a batch stores its numbers, looked up once.

use core::cell::Cell;

use super::line::LINE;
use super::outcome::LengthMismatch;
use super::target::{Columns, Slot, Target, Visitor};
use super::view::{View, look_at_entries};
use crate::batch::lanes::{Element, Lanes};
use crate::mechanism::{Mechanism, Pose};
use crate::number::{Number, Row};
use num_traits::Float;

/// The column of one number of each pose, empty if the number is not wanted. It consists of cells because rows are
/// copied.
pub(super) type Entries<'t, E> = &'t [Cell<E>];

type InputColumns<M, C> = <M as Mechanism>::Inputs<<M as Mechanism>::Motion<C>>;
type UnknownColumns<M, C> = <M as Mechanism>::Unknowns<<M as Mechanism>::Motion<C>>;
type OutputColumns<M, C> = <<M as Mechanism>::Pose as Pose>::Outputs<<M as Mechanism>::Motion<C>>;

/// The column of one number of each pose of a mechanism.
pub(super) type EntriesOf<'t, M> = Entries<'t, <M as Mechanism>::Scalar>;

/// The column of one number of each pose of a mechanism, as lanes store it.
pub(super) type ViewOf<'t, M, const W: usize> = View<'t, Cell<<M as Mechanism>::Scalar>, W>;

/// The number of chunks from which a column is long. One chunk more adds at most a part of 1/32 then.
const LONG: usize = 32;

/// The numbers that are found for a pose, without sines.
pub(super) const fn numbers<M: Mechanism>() -> usize {
    <M::Results<f64> as Row<f64>>::LENGTH * <M::Motion<f64> as Row<f64>>::LENGTH
}

/// The columns of all numbers: a `C` for each.
pub(super) struct Destination<M: Mechanism, C: Copy> {
    inputs: InputColumns<M, C>,
    unknowns: UnknownColumns<M, C>,
    /// The columns of the sines of unknowns that are directions.
    sines: M::Unknowns<C>,
    outputs: OutputColumns<M, C>,
}

impl<M: Mechanism<Scalar: Element>, C: Copy> Destination<M, C> {
    pub(super) fn splat(column: C) -> Self {
        let motion = M::Motion::splat(column);
        Self {
            inputs: Row::splat(motion),
            unknowns: Row::splat(motion),
            sines: Row::splat(column),
            outputs: Row::splat(motion),
        }
    }

    /// The columns of the numbers that are found, in rows.
    pub(super) fn rows(&self) -> impl Iterator<Item = &[C]> {
        let unknowns = self.unknowns.as_ref().iter().map(AsRef::as_ref);
        let outputs = self.outputs.as_ref().iter().map(AsRef::as_ref);
        unknowns.chain([self.sines.as_ref()]).chain(outputs)
    }

    /// [`rows`](Self::rows) to be changed.
    pub(super) fn rows_mut(&mut self) -> impl Iterator<Item = &mut [C]> {
        let unknowns = self.unknowns.as_mut().iter_mut().map(AsMut::as_mut);
        let outputs = self.outputs.as_mut().iter_mut().map(AsMut::as_mut);
        unknowns.chain([self.sines.as_mut()]).chain(outputs)
    }

    /// Stores the motions of the inputs, starting at a given pose.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn store_inputs<V: Stored<C>, R: Row<V>>(&self, start: usize, inputs: &[R]) {
        store_all(Ordinary, start, inputs, self.inputs.as_ref());
    }

    /// Stores the motions that have been found, starting at a given pose. Returns their sum: it is finite if and only
    /// if all numbers are, unless the sum itself overflows.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn store<V: Stored<C>, R: Row<V>>(
        &self,
        way: impl Way<C, V>,
        start: usize,
        unknowns: &[R],
        sines: &[Option<V>],
        outputs: &[R],
    ) -> V {
        let mut sum = store_all(way, start, unknowns, self.unknowns.as_ref());
        for (sine, column) in sines.iter().zip(self.sines.as_ref()) {
            if let Some(sine) = sine {
                sum = sum + *sine;
                way.store(*sine, *column, start);
            }
        }
        sum + store_all(way, start, outputs, self.outputs.as_ref())
    }
}

impl<'t, M: Mechanism<Scalar: Element>> Destination<M, EntriesOf<'t, M>> {
    /// The destination of a pose of which nothing is wanted.
    pub(super) fn nowhere() -> Self {
        Self::splat(&[])
    }

    /// The same in the form in which lanes store numbers. Those that are not wanted go to a spare chunk.
    pub(super) fn in_chunks<'v, const W: usize>(
        &self,
        spare: &'v [Cell<M::Scalar>; W],
    ) -> Destination<M, ViewOf<'v, M, W>>
    where
        't: 'v,
    {
        let mut chunks = Destination::<M, ViewOf<'v, M, W>>::splat(View::same(spare));
        look_at_motions(chunks.inputs.as_mut(), self.inputs.as_ref(), spare);
        look_at_motions(chunks.unknowns.as_mut(), self.unknowns.as_ref(), spare);
        look_at_entries(chunks.sines.as_mut(), self.sines.as_ref(), spare);
        look_at_motions(chunks.outputs.as_mut(), self.outputs.as_ref(), spare);
        chunks
    }

    /// The entries of a slot, which are empty if its number is not wanted.
    pub(super) fn entries(&mut self, slot: Slot) -> &mut EntriesOf<'t, M> {
        match slot {
            Slot::Input(index, order) => &mut self.inputs[index][order],
            Slot::Unknown(index, order) => &mut self.unknowns[index][order],
            Slot::Sine(index) => &mut self.sines[index],
            Slot::Output(index, order) => &mut self.outputs[index][order],
        }
    }

    /// Looks up the columns of all wanted numbers.
    ///
    /// # Errors
    /// Fails if the length of a column differs from the number of poses.
    pub(super) fn find<P: Columns<C>, C: Target<M::Scalar> + 't>(
        &mut self,
        poses: &'t mut P,
        count: usize,
    ) -> Result<(), LengthMismatch> {
        let mut search = ColumnSearch {
            found: self,
            count,
            mismatch: None,
        };
        poses.each(&mut search);
        search.mismatch.map_or(Ok(()), |(slot, length)| {
            let description = M::DESCRIPTION;
            let quantity = match slot {
                Slot::Input(index, _) => &description.inputs[index],
                Slot::Unknown(index, _) | Slot::Sine(index) => &description.unknowns[index],
                Slot::Output(index, _) => &description.outputs[index],
            };
            Err(LengthMismatch {
                quantity: quantity.name.into(),
                poses: count,
                length,
            })
        })
    }

    /// The pose at which the second chunk of `W` poses starts, if the numbers of a pose do not depend on those beside
    /// it.
    ///
    /// It lies at the start of a cache line in the first column that is wanted. Vectors have pages of their own if they
    /// are long, and start at the same place of a page. So most chunks are whole lines of all columns then. If they
    /// were parts of two lines each, both would compete with those of all other columns for the same few places of the
    /// cache: a four-bar linkage takes a third longer. The second chunk overlaps the first one for this, which pays in
    /// columns of many chunks.
    pub(super) fn second_chunk<const W: usize>(&self) -> usize {
        let column = self.rows().flatten().find(|column| column.len() >= LONG * W);
        match column.map_or(0, |column| column.as_ptr().align_offset(LINE) % W) {
            0 => W,
            second => second,
        }
    }

    /// Whether every wanted column gets the numbers of all poses that are solved: that of a sine gets those of a
    /// direction only.
    pub(super) fn are_filled(&self) -> bool {
        let mut sines = self.sines.as_ref().iter().zip(M::DESCRIPTION.unknowns);
        sines.all(|(column, unknown)| column.is_empty() || unknown.is_direction)
    }

    /// The numbers before the first whole line of every column, if that is the same place in all of them and every
    /// number is wanted: there is no line for the others.
    pub(super) fn before_lines(&self) -> Option<usize> {
        let sines = self.sines.as_ref().iter().zip(M::DESCRIPTION.unknowns);
        let sines = sines.filter_map(|(column, unknown)| unknown.is_direction.then_some(column));
        let unknowns = self.unknowns.as_ref().iter().flat_map(AsRef::as_ref);
        let outputs = self.outputs.as_ref().iter().flat_map(AsRef::as_ref);
        let mut columns = unknowns.chain(outputs).chain(sines);
        let before = columns.next()?.as_ptr().align_offset(LINE);
        columns
            .all(|column| !column.is_empty() && column.as_ptr().align_offset(LINE) == before)
            .then_some(before)
    }

    /// The bytes of the wanted columns of so many poses.
    pub(super) fn bytes(&self, count: usize) -> usize {
        let wanted = self.rows().flatten().filter(|column| !column.is_empty()).count();
        wanted * count * size_of::<M::Scalar>()
    }

    /// Whether the motion of an input is wanted.
    pub(super) fn has_inputs(&self) -> bool {
        let mut columns = self.inputs.as_ref().iter().flat_map(AsRef::as_ref);
        columns.any(|columns| !columns.is_empty())
    }

    /// Whether a sine is wanted.
    pub(super) fn has_sines(&self) -> bool {
        self.sines.as_ref().iter().any(|columns| !columns.is_empty())
    }

    /// Stores NaN as the sines of a pose that has failed. A pose that is solved has sines of directions only, and
    /// leaves the other columns as they are.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn leave_out_sines(&self, index: usize) {
        for entries in self.sines.as_ref() {
            M::Scalar::nan().store(entries, index);
        }
    }
}

impl<M: Mechanism<Scalar: Element>, const W: usize> Destination<M, ViewOf<'_, M, W>> {
    /// Stores NaN in the place of the motions that have been found, starting at a given pose: where `gone` is NaN. It
    /// is a negative zero for the others.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn clear<const BITS: usize>(&self, start: usize, gone: Lanes<W, BITS, M::Scalar>) {
        for columns in self.unknowns.as_ref() {
            for view in columns.as_ref() {
                view.clear(start, gone);
            }
        }
        for columns in self.outputs.as_ref() {
            for view in columns.as_ref() {
                view.clear(start, gone);
            }
        }
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn store_all<C: Copy, V: Stored<C>, R: Row<V>>(
    way: impl Way<C, V>,
    start: usize,
    motions: &[R],
    columns: &[impl Row<C>],
) -> V {
    // The compiler knows that adding a negative zero changes nothing.
    let mut sum = V::constant(-0.0);
    for (motion, columns) in motions.iter().zip(columns) {
        // a chain for each motion, since a single one would be longer than the calculation of the next chunk can hide
        let mut own = V::constant(-0.0);
        for order in 0..R::LENGTH {
            own = own + motion[order];
            way.store(motion[order], columns[order], start);
        }
        sum = sum + own;
    }
    sum
}

/// [`look_at_entries`] for the columns of all orders of several numbers.
fn look_at_motions<'v, 't: 'v, const W: usize, E: Element>(
    views: &mut [impl Row<View<'v, Cell<E>, W>>],
    columns: &[impl Row<Entries<'t, E>>],
    spare: &'v [Cell<E>; W],
) {
    for (views, columns) in views.iter_mut().zip(columns) {
        look_at_entries(views.as_mut(), columns.as_ref(), spare);
    }
}

/// A number of one pose or of several, which is stored in a column of the form `C`.
pub(super) trait Stored<C>: Number {
    /// Stores the number, starting at a given pose, unless it is not wanted.
    fn store(self, column: C, start: usize);
}

/// A way of numbers into columns of the form `C`.
///
/// This is a trait and not a closure, because closures cannot be marked for inlining.
pub(super) trait Way<C, V>: Copy {
    /// Stores a number, starting at a given pose, unless it is not wanted.
    fn store(self, number: V, column: C, start: usize);
}

/// The way of ordinary stores.
#[derive(Clone, Copy)]
pub(super) struct Ordinary;

impl<C, V: Stored<C>> Way<C, V> for Ordinary {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn store(self, number: V, column: C, start: usize) {
        number.store(column, start);
    }
}

impl<E: Element> Stored<Entries<'_, E>> for E {
    fn store(self, column: Entries<'_, E>, start: usize) {
        if let Some(entry) = column.get(start) {
            entry.set(self);
        }
    }
}

impl<const W: usize, const BITS: usize, E: Element> Stored<View<'_, Cell<E>, W>> for Lanes<W, BITS, E> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn store(self, column: View<'_, Cell<E>, W>, start: usize) {
        column.store(start, self);
    }
}

struct ColumnSearch<'s, 't, M: Mechanism> {
    found: &'s mut Destination<M, EntriesOf<'t, M>>,
    count: usize,
    /// The slot of the first column with a wrong length, and that length.
    mismatch: Option<(Slot, usize)>,
}

impl<'t, M: Mechanism<Scalar: Element>, C: Target<M::Scalar>> Visitor<'t, C> for ColumnSearch<'_, 't, M> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn visit(&mut self, slot: Slot, there: &'t mut C) {
        let Some(slice) = there.slice() else {
            return;
        };
        if slice.len() != self.count {
            self.mismatch = self.mismatch.or(Some((slot, slice.len())));
            return;
        }
        *self.found.entries(slot) = Cell::from_mut(slice).as_slice_of_cells();
    }
}
