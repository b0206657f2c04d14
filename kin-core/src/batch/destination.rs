//! The places where a batch stores its numbers, looked up once.

use core::cell::Cell;

use super::outcome::LengthMismatch;
use super::target::{Columns, Place, Target, Visitor};
use crate::batch::lanes::Lanes;
use crate::mechanism::{Mechanism, Pose};
use crate::number::Row;

/// The place for one number of each pose, empty if the number is not wanted. It consists of cells because rows are
/// copied.
type Entries<'t> = &'t [Cell<f64>];

type Inputs<M, V> = <M as Mechanism>::Inputs<<M as Mechanism>::Motion<V>>;
type Unknowns<M, V> = <M as Mechanism>::Unknowns<<M as Mechanism>::Motion<V>>;
type Outputs<M, V> = <<M as Mechanism>::Pose as Pose>::Outputs<<M as Mechanism>::Motion<V>>;

/// The places of all numbers.
pub(super) struct Destination<'t, M: Mechanism> {
    inputs: Inputs<M, Entries<'t>>,
    unknowns: Unknowns<M, Entries<'t>>,
    /// The places of the sines of unknowns that are directions.
    sines: M::Unknowns<Entries<'t>>,
    outputs: Outputs<M, Entries<'t>>,
}

impl<'t, M: Mechanism> Destination<'t, M> {
    /// The destination of a pose of which nothing is wanted.
    pub(super) fn nowhere() -> Self {
        let nowhere = |_| -> M::Motion<Entries<'t>> { Row::from_fn(|_| -> Entries<'t> { &[] }) };
        Self {
            inputs: Row::from_fn(nowhere),
            unknowns: Row::from_fn(nowhere),
            sines: Row::from_fn(|_| -> Entries<'t> { &[] }),
            outputs: Row::from_fn(nowhere),
        }
    }

    /// Looks up the places of all wanted numbers.
    ///
    /// # Errors
    /// Fails if the length of a place differs from the number of poses.
    pub(super) fn find<P: Columns<C>, C: Target + 't>(
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
        search.mismatch.map_or(Ok(()), |(place, length)| {
            let description = M::DESCRIPTION;
            let quantity = match place {
                Place::Input(index, _) => &description.inputs[index],
                Place::Unknown(index, _) | Place::Sine(index) => &description.unknowns[index],
                Place::Output(index, _) => &description.outputs[index],
            };
            Err(LengthMismatch {
                quantity: quantity.name,
                poses: count,
                length,
            })
        })
    }

    /// Stores motions, starting at a given pose.
    #[inline(always)]
    pub(super) fn store<V: Stored, R: Row<V>>(
        &self,
        start: usize,
        inputs: &[R],
        unknowns: &[R],
        sines: &[Option<V>],
        outputs: &[R],
    ) {
        store_all(start, inputs, self.inputs.as_ref());
        store_all(start, unknowns, self.unknowns.as_ref());
        for (sine, entries) in sines.iter().zip(self.sines.as_ref()) {
            if let Some(sine) = sine {
                sine.store(entries, start);
            }
        }
        store_all(start, outputs, self.outputs.as_ref());
    }
}

#[inline(always)]
fn store_all<'t, V: Stored, R: Row<V>>(start: usize, motions: &[R], places: &[impl Row<Entries<'t>>]) {
    for (motion, places) in motions.iter().zip(places) {
        for (number, entries) in motion.as_ref().iter().zip(places.as_ref()) {
            number.store(entries, start);
        }
    }
}

/// The stored form of a number: one pose or several.
pub(super) trait Stored: Copy {
    /// Stores the number, starting at a given pose, unless it is not wanted.
    fn store(self, entries: Entries<'_>, start: usize);
}

impl Stored for f64 {
    fn store(self, entries: Entries<'_>, start: usize) {
        if let Some(entry) = entries.get(start) {
            entry.set(self);
        }
    }
}

impl<const W: usize, const FUSED: bool> Stored for Lanes<W, FUSED> {
    #[inline(always)]
    fn store(self, entries: Entries<'_>, start: usize) {
        // A wanted place is always long enough, but the compiler does not know it.
        if let Some(entries) = entries.get(start..start + W) {
            for (entry, number) in entries.iter().zip(self.0) {
                entry.set(number);
            }
        }
    }
}

struct ColumnSearch<'s, 't, M: Mechanism> {
    found: &'s mut Destination<'t, M>,
    count: usize,
    /// The first place with a wrong length, and that length.
    mismatch: Option<(Place, usize)>,
}

impl<'t, M: Mechanism, C: Target> Visitor<'t, C> for ColumnSearch<'_, 't, M> {
    #[inline(always)]
    fn visit(&mut self, place: Place, there: &'t mut C) {
        let Some(slice) = there.slice() else {
            return;
        };
        if slice.len() != self.count {
            self.mismatch = self.mismatch.or(Some((place, slice.len())));
            return;
        }
        let entries = match place {
            Place::Input(index, order) => &mut self.found.inputs[index][order],
            Place::Unknown(index, order) => &mut self.found.unknowns[index][order],
            Place::Sine(index) => &mut self.found.sines[index],
            Place::Output(index, order) => &mut self.found.outputs[index][order],
        };
        *entries = Cell::from_mut(slice).as_slice_of_cells();
    }
}
