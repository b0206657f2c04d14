//! Columns in the form in which lanes read them.

use super::Column;
use crate::batch::lanes::{Element, Lanes};
use crate::number::Row;

/// A column whose chunks are all read in the same way, with one comparison: either the next numbers, or the same
/// numbers every time.
#[derive(Clone, Copy)]
pub(super) struct View<'v, E> {
    numbers: &'v [E],
    /// The mask of the bits of an index that count: all bits, or none.
    mask: usize,
}

impl<E> Default for View<'_, E> {
    fn default() -> Self {
        Self { numbers: &[], mask: 0 }
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
/// This is a separate function: if the compiler sees that a mask is one of two, it tests it in every chunk.
#[inline(never)]
pub(super) fn look<'v, const W: usize, const BITS: usize, E: Element>(
    views: &mut [View<'v, E>],
    columns: &[Column<'v, E>],
    same: &'v [Lanes<W, BITS, E>],
) {
    for ((view, column), same) in views.iter_mut().zip(columns).zip(same) {
        *view = match column {
            Column::Same(_) => View {
                numbers: &same.0,
                mask: 0,
            },
            Column::Each(numbers) => View {
                numbers,
                mask: usize::MAX,
            },
        };
    }
}

/// Fills in the numbers of some columns, starting at a given pose.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn gather<R: Row<Lanes<W, BITS, E>>, const W: usize, const BITS: usize, E: Element>(
    numbers: &mut R,
    views: &[View<'_, E>],
    start: usize,
) {
    for (lanes, view) in numbers.as_mut().iter_mut().zip(views) {
        let start = start & view.mask;
        // All columns are long enough, but the compiler does not know it.
        lanes.0.copy_from_slice(&view.numbers[start..start + W]);
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
    V: AsRef<[View<'v, E>]>,
{
    for (numbers, views) in numbers.as_mut().iter_mut().zip(views) {
        gather(numbers, views.as_ref(), start);
    }
}
