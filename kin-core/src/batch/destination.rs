//! The columns into which a batch stores its numbers, looked up once.

use core::cell::Cell;

use super::outcome::LengthMismatch;
use super::target::{Columns, Slot, Target, Visitor};
use crate::batch::lanes::{Element, Lanes, for_each_lane};
use crate::mechanism::{Mechanism, Pose};
use crate::number::Row;
use num_traits::Float;

/// The column of one number of each pose, empty if the number is not wanted. It consists of cells because rows are
/// copied.
pub(super) type Entries<'t, E> = &'t [Cell<E>];

type InputColumns<M, V> = <M as Mechanism>::Inputs<<M as Mechanism>::Motion<V>>;
type UnknownColumns<M, V> = <M as Mechanism>::Unknowns<<M as Mechanism>::Motion<V>>;
type OutputColumns<M, V> = <<M as Mechanism>::Pose as Pose>::Outputs<<M as Mechanism>::Motion<V>>;

/// The column of one number of each pose of a mechanism.
type EntriesOf<'t, M> = Entries<'t, <M as Mechanism>::Scalar>;

/// The columns of all numbers.
pub(super) struct Destination<'t, M: Mechanism> {
    inputs: InputColumns<M, EntriesOf<'t, M>>,
    unknowns: UnknownColumns<M, EntriesOf<'t, M>>,
    /// The columns of the sines of unknowns that are directions.
    sines: M::Unknowns<EntriesOf<'t, M>>,
    outputs: OutputColumns<M, EntriesOf<'t, M>>,
}

impl<'t, M: Mechanism<Scalar: Element>> Destination<'t, M> {
    /// The destination of a pose of which nothing is wanted.
    pub(super) fn nowhere() -> Self {
        let nowhere: EntriesOf<'t, M> = &[];
        let motion = M::Motion::splat(nowhere);
        Self {
            inputs: Row::splat(motion),
            unknowns: Row::splat(motion),
            sines: Row::splat(nowhere),
            outputs: Row::splat(motion),
        }
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

    /// Stores the motions of the inputs, starting at a given pose.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn store_inputs<V: Stored<Element = M::Scalar>, R: Row<V>>(&self, start: usize, inputs: &[R]) {
        store_all(start, inputs, self.inputs.as_ref());
    }

    /// Stores the motions that have been found, starting at a given pose.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn store<V: Stored<Element = M::Scalar>, R: Row<V>>(
        &self,
        start: usize,
        unknowns: &[R],
        sines: &[Option<V>],
        outputs: &[R],
    ) {
        store_all(start, unknowns, self.unknowns.as_ref());
        for (sine, entries) in sines.iter().zip(self.sines.as_ref()) {
            if let Some(sine) = sine {
                sine.store(entries, start);
            }
        }
        store_all(start, outputs, self.outputs.as_ref());
    }

    /// Stores NaN in the place of the motions that have been found, starting at a given pose: where `gone` is NaN. It
    /// is a negative zero for the others.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn clear<const W: usize, const BITS: usize>(&self, start: usize, gone: Lanes<W, BITS, M::Scalar>) {
        for columns in self.unknowns.as_ref() {
            for entries in columns.as_ref() {
                clear(gone, entries, start);
            }
        }
        for columns in self.outputs.as_ref() {
            for entries in columns.as_ref() {
                clear(gone, entries, start);
            }
        }
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

#[cfg_attr(not(debug_assertions), inline(always))]
fn store_all<'t, V: Stored, R: Row<V>>(start: usize, motions: &[R], columns: &[impl Row<Entries<'t, V::Element>>]) {
    for (motion, columns) in motions.iter().zip(columns) {
        for order in 0..R::LENGTH {
            motion[order].store(columns[order], start);
        }
    }
}

/// Stores NaN, starting at a given pose: where `gone` is NaN. It is a negative zero for the others, whose addition
/// changes nothing.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn clear<const W: usize, const BITS: usize, E: Element>(
    gone: Lanes<W, BITS, E>,
    entries: Entries<'_, E>,
    start: usize,
) {
    if let Some(group) = entries.get(start..start + W) {
        let numbers = Lanes::<W, BITS, E>::from_fn(|lane| group[lane].get());
        // A selection would become a masked store, which is slow on some processors.
        (gone + numbers).store(entries, start);
    }
}

/// The stored form of a number: one pose or several.
pub(super) trait Stored: Copy {
    /// The stored numbers.
    type Element: Element;

    /// Stores the number, starting at a given pose, unless it is not wanted.
    fn store(self, entries: Entries<'_, Self::Element>, start: usize);
}

impl<E: Element> Stored for E {
    type Element = E;

    fn store(self, entries: Entries<'_, E>, start: usize) {
        if let Some(entry) = entries.get(start) {
            entry.set(self);
        }
    }
}

impl<const W: usize, const BITS: usize, E: Element> Stored for Lanes<W, BITS, E> {
    type Element = E;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn store(self, entries: Entries<'_, E>, start: usize) {
        // A wanted column is always long enough, but the compiler does not know it.
        if let Some(entries) = entries.get(start..start + W) {
            for_each_lane!(lane in 0..W {
                entries[lane].set(self.0[lane]);
            });
        }
    }
}

struct ColumnSearch<'s, 't, M: Mechanism> {
    found: &'s mut Destination<'t, M>,
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
