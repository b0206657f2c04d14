//! Columns in the form in which lanes read and write them.
#![expect(
    unsafe_code,
    reason = "a chunk lies within its column by the invariant of a view, which a compiler cannot see"
)]

use core::cell::Cell;

use super::Column;
use super::destination::Entries;
use crate::batch::lanes::{Element, Lanes, for_each_lane};
use crate::number::Row;

/// A column whose chunks of `W` numbers are read or written without a branch: either the numbers from a given pose on,
/// or the same chunk for every pose.
///
/// A pose has dozens of columns. A branch for each of them would divide the calculation of a chunk into as many blocks,
/// and a compiler arranges instructions within blocks only: Jansen's leg then takes a quarter longer.
pub(super) struct View<'v, T, const W: usize> {
    numbers: &'v [T],
    /// The index at which the last chunk starts. Invariant: `last + W <= numbers.len()`.
    last: usize,
}

// not derived, because cells are not copied, but references to them are
impl<T, const W: usize> Copy for View<'_, T, W> {}

impl<T, const W: usize> Clone for View<'_, T, W> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<'v, T, const W: usize> View<'v, T, W> {
    /// The same chunk for every pose.
    pub(super) const fn same(chunk: &'v [T; W]) -> Self {
        Self {
            numbers: chunk,
            last: 0,
        }
    }

    /// The numbers of a column, or the same chunk for every pose if the column is shorter than a chunk.
    pub(super) const fn each(numbers: &'v [T], otherwise: &'v [T; W]) -> Self {
        match numbers.len().checked_sub(W) {
            Some(last) => Self { numbers, last },
            None => Self::same(otherwise),
        }
    }

    /// The chunk that starts at a given pose, or the last one if there are not so many poses.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn chunk(&self, start: usize) -> &'v [T; W] {
        let first = start.min(self.last);
        // SAFETY: `first <= last`, so that `first + W <= numbers.len()` by the invariant of `last`: the array lies
        // within the slice, whose lifetime it has. An array has the alignment of its entries.
        unsafe { &*self.numbers.as_ptr().add(first).cast() }
    }
}

impl<E: Element, const W: usize> View<'_, Cell<E>, W> {
    /// Stores a chunk.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn store<const BITS: usize>(&self, start: usize, numbers: Lanes<W, BITS, E>) {
        let chunk = self.chunk(start);
        for_each_lane!(lane in 0..W {
            chunk[lane].set(numbers.0[lane]);
        });
    }

    /// Stores NaN where `gone` is NaN. It is a negative zero for the other poses, whose addition changes nothing.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn clear<const BITS: usize>(&self, start: usize, gone: Lanes<W, BITS, E>) {
        let chunk = self.chunk(start);
        let numbers = Lanes::from_fn(|lane| chunk[lane].get());
        // A selection would become a masked store, which is slow on some processors.
        self.store(start, gone + numbers);
    }
}

/// Views of the entries in which numbers are stored. Numbers that are not wanted go to the spare chunk.
///
/// This is a separate function, as [`look`] is.
#[inline(never)]
pub(super) fn look_at_entries<'v, const W: usize, E: Element>(
    views: &mut [View<'v, Cell<E>, W>],
    columns: &[Entries<'v, E>],
    spare: &'v [Cell<E>; W],
) {
    for (view, entries) in views.iter_mut().zip(columns) {
        *view = View::each(entries, spare);
    }
}

/// Fills in the lanes of columns that are the same for all poses.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn repeat<const W: usize, const BITS: usize, E: Element>(
    same: &mut [Lanes<W, BITS, E>],
    columns: &[Column<'_, E>],
) {
    for (lanes, column) in same.iter_mut().zip(columns) {
        let value = match column {
            Column::Same(value) => *value,
            Column::Each(_) => E::nan(),
        };
        *lanes = Lanes([value; W]);
    }
}

/// Views of some columns, with the [repeated](repeat) lanes of each.
///
/// This is a separate function: if the compiler sees that a view is one of two, it tests it in every chunk.
#[inline(never)]
pub(super) fn look<'v, const W: usize, const BITS: usize, E: Element>(
    views: &mut [View<'v, E, W>],
    columns: &[Column<'v, E>],
    same: &'v [Lanes<W, BITS, E>],
) {
    for ((view, column), same) in views.iter_mut().zip(columns).zip(same) {
        *view = match column {
            Column::Same(_) => View::same(&same.0),
            Column::Each(numbers) => View::each(numbers, &same.0),
        };
    }
}

/// Fills in the numbers of some columns, starting at a given pose.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn gather<R: Row<Lanes<W, BITS, E>>, const W: usize, const BITS: usize, E: Element>(
    numbers: &mut R,
    views: &[View<'_, E, W>],
    start: usize,
) {
    for (lanes, view) in numbers.as_mut().iter_mut().zip(views) {
        lanes.0 = *view.chunk(start);
    }
}

/// [`gather`] for the columns of all orders of several numbers.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn gather_all<'v, I, R, V, const W: usize, const BITS: usize, E: Element + 'v>(
    numbers: &mut I,
    views: &[V],
    start: usize,
) where
    I: Row<R>,
    R: Row<Lanes<W, BITS, E>>,
    V: AsRef<[View<'v, E, W>]>,
{
    for (numbers, views) in numbers.as_mut().iter_mut().zip(views) {
        gather(numbers, views.as_ref(), start);
    }
}
