//! Columns in the form in which lanes read them.

use super::Column;
use crate::batch::lanes::Lanes;
use crate::number::Row;

/// A column whose chunks are all read in the same way, with one comparison: either the next numbers, or the same
/// numbers every time.
#[derive(Clone, Copy, Default)]
pub(super) struct View<'v> {
    numbers: &'v [f64],
    /// The mask of the bits of an index that count: all bits, or none.
    mask: usize,
}

/// Fills in the lanes of columns that are the same for all poses.
#[inline(always)]
pub(super) fn repeat<const W: usize, const FUSED: bool>(same: &mut [Lanes<W, FUSED>], columns: &[Column<'_>]) {
    for (lanes, column) in same.iter_mut().zip(columns) {
        let value = match column {
            Column::Same(value) => *value,
            Column::Each(_) => f64::NAN,
        };
        *lanes = Lanes([value; W]);
    }
}

/// Views of some columns, with the [repeated](repeat) lanes of each.
///
/// This is a separate function: if the compiler sees that a mask is one of two, it tests it in every chunk.
#[inline(never)]
pub(super) fn look<'v, const W: usize, const FUSED: bool>(
    views: &mut [View<'v>],
    columns: &[Column<'v>],
    same: &'v [Lanes<W, FUSED>],
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
#[inline(always)]
pub(super) fn gather<R: Row<Lanes<W, FUSED>>, const W: usize, const FUSED: bool>(
    numbers: &mut R,
    views: &[View<'_>],
    start: usize,
) {
    for (lanes, view) in numbers.as_mut().iter_mut().zip(views) {
        let start = start & view.mask;
        // All columns are long enough, but the compiler does not know it.
        let chunk = &view.numbers[start..start + W];
        for (entry, number) in lanes.0.iter_mut().zip(chunk) {
            *entry = *number;
        }
    }
}
