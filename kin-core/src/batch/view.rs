//! Columns as lanes read them.

use super::Column;
use crate::batch::lanes::Lanes;
use crate::number::Row;

/// A column of which each chunk is read in the same way, by one comparison: the next numbers, or the same ones every time.
#[derive(Clone, Copy, Default)]
pub(super) struct View<'v> {
    numbers: &'v [f64],
    /// Which bits of a place count: all, or none.
    mask: usize,
}

/// Fills in what is read in every chunk of columns that are the same for all poses.
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

/// Views of some columns, with what is the [same](repeat) in each.
///
/// By itself: where the compiler sees that a mask is one of two, it chooses between them in every chunk.
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

/// Fills in the numbers of some columns from a pose on.
#[inline(always)]
pub(super) fn gather<R: Row<Lanes<W, FUSED>>, const W: usize, const FUSED: bool>(
    numbers: &mut R,
    views: &[View<'_>],
    start: usize,
) {
    for (lanes, view) in numbers.as_mut().iter_mut().zip(views) {
        let start = start & view.mask;
        // All columns are long enough, and the compiler does not know.
        let chunk = &view.numbers[start..start + W];
        for (entry, number) in lanes.0.iter_mut().zip(chunk) {
            *entry = *number;
        }
    }
}
