//! The summary of a piece of poses, in vectors.
#![expect(clippy::needless_range_loop, reason = "lanes are an index into several arrays")]

use super::folded::{Folded, count};
use super::number::FoldedNumber;
use crate::batch::dispatch::{Kernel, MOST_LANES};
use crate::batch::target::Slot;

/// The number of poses of a piece, whose values are added up together. The order of additions depends on nothing else.
pub(super) const PIECE: usize = 512;

/// The number of values that are summarised side by side, whatever the vectors of the machine. A sum is therefore the
/// same in all vectors if its terms are.
const ABREAST: usize = 16;

/// Room for the poses of a piece. The last one takes up to 15 more: poses that are fewer than lanes would be solved one
/// by one.
pub(super) const ROOM: usize = PIECE + MOST_LANES;

/// Room for the values of a piece, on separate cache lines.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub(super) struct Room(pub(super) [f64; ROOM]);

/// A number to be folded over many poses, with its summary and with room for the values of a few hundred poses: about
/// four kilobytes.
///
/// Use it again for the next batch: [`fold`](crate::batch::Batch::fold) starts the summary anew.
#[derive(Clone, Copy, Debug)]
pub struct Fold {
    pub(super) number: FoldedNumber,
    pub(super) folded: Folded,
    pub(super) room: Room,
}

impl Fold {
    /// A fold of a number, over no poses yet.
    #[must_use]
    pub fn of(number: impl Into<FoldedNumber>) -> Self {
        Self {
            number: number.into(),
            folded: Folded::default(),
            room: Room([f64::NAN; ROOM]),
        }
    }

    /// The number.
    #[must_use]
    pub const fn number(&self) -> FoldedNumber {
        self.number
    }

    /// The summary over the poses of the last call.
    #[must_use]
    pub const fn folded(&self) -> &Folded {
        &self.folded
    }
}

/// Summarises the values that a piece has left in the room of each fold.
pub(super) struct Reduction<'f> {
    pub(super) folds: &'f mut [Fold],
    /// The index of the first pose of the piece.
    pub(super) first: usize,
    /// The number of poses of the piece.
    pub(super) count: usize,
    /// Whether every pose was found.
    pub(super) is_complete: bool,
}

impl Kernel for Reduction<'_> {
    type Result = ();
    type Element = f64;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<const W: usize, const BITS: usize>(self) {
        for fold in self.folds {
            let values = &fold.room.0[..self.count];
            // The sine of an unknown that is not a direction is missing in every pose.
            let can_be_missing = matches!(fold.number, FoldedNumber::At(Slot::Sine(_)));
            if self.is_complete && !can_be_missing {
                reduce::<true>(values, self.first, &mut fold.folded);
            } else {
                reduce::<false>(values, self.first, &mut fold.folded);
            }
        }
    }
}

/// Adds the values of a piece to a summary. If they are `COMPLETE`, none is NaN. The index of the first pose is
/// `first`.
#[cfg_attr(not(debug_assertions), inline(always))]
fn reduce<const COMPLETE: bool>(values: &[f64], first: usize, folded: &mut Folded) {
    let (rows, rest) = values.as_chunks::<ABREAST>();
    let (mut running, missing) = of_rows::<COMPLETE>(rows);
    let mut present = values.len() - if COMPLETE { 0 } else { total(&missing) };
    if !rest.is_empty() {
        let mut last = [f64::NAN; ABREAST];
        last[..rest.len()].copy_from_slice(rest);
        running.compare(&last);
        running.add(&without_nan(&last));
        for value in rest {
            present -= usize::from(value.is_nan());
        }
    }
    let RunningRow {
        least,
        greatest,
        sum,
        sum_of_squares,
    } = running.joined();
    if least < folded.least.map_or(f64::INFINITY, |(_, before)| before) {
        folded.least = first_of(values, least).map(|(index, value)| (first + index, value));
    }
    if greatest > folded.greatest.map_or(f64::NEG_INFINITY, |(_, before)| before) {
        folded.greatest = first_of(values, greatest).map(|(index, value)| (first + index, value));
    }
    folded.count += present;
    folded.sum += sum;
    folded.sum_of_squares += sum_of_squares;
}

/// What is known of some rows, and how many values each lane lacks.
///
/// The running values stay here, and the caller gets copies. If another function were given the address of the running
/// values, the compiler would store them in every row. A store across two pages takes longer than all the rest of the
/// row.
#[cfg_attr(not(debug_assertions), inline(always))]
fn of_rows<const COMPLETE: bool>(rows: &[[f64; ABREAST]]) -> (Running, [u64; ABREAST]) {
    let mut running = Running::NONE;
    let mut missing = [0_u64; ABREAST];
    for row in rows {
        running.compare(row);
    }
    for row in rows {
        if COMPLETE {
            running.add(row);
        } else {
            for lane in 0..ABREAST {
                missing[lane] += u64::from(row[lane].is_nan());
            }
            running.add(&without_nan(row));
        }
    }
    (running.clone(), missing)
}

/// What is known of the values so far: one set for each lane of a row, or one for all of them.
#[derive(Clone)]
struct RunningRow<V> {
    least: V,
    greatest: V,
    sum: V,
    sum_of_squares: V,
}

type Running = RunningRow<[f64; ABREAST]>;

impl Running {
    const NONE: Self = Self {
        least: [f64::INFINITY; ABREAST],
        greatest: [f64::NEG_INFINITY; ABREAST],
        sum: [0.0; ABREAST],
        sum_of_squares: [0.0; ABREAST],
    };

    /// Compares a row with the least and the greatest values. A comparison with NaN does not hold, so NaN is left out.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn compare(&mut self, row: &[f64; ABREAST]) {
        for lane in 0..ABREAST {
            self.least[lane] = lesser(row[lane], self.least[lane]);
        }
        for lane in 0..ABREAST {
            self.greatest[lane] = greater(row[lane], self.greatest[lane]);
        }
    }

    /// Adds a row, and its squares.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn add(&mut self, row: &[f64; ABREAST]) {
        for lane in 0..ABREAST {
            self.sum[lane] += row[lane];
        }
        for lane in 0..ABREAST {
            self.sum_of_squares[lane] += row[lane] * row[lane];
        }
    }

    /// One set for all lanes.
    ///
    /// This is a separate function: a compiler that sees how the lanes are joined arranges everything before in vectors
    /// of two.
    #[inline(never)]
    fn joined(&self) -> RunningRow<f64> {
        RunningRow {
            least: in_halves(self.least, lesser),
            greatest: in_halves(self.greatest, greater),
            sum: in_halves(self.sum, |one, other| one + other),
            sum_of_squares: in_halves(self.sum_of_squares, |one, other| one + other),
        }
    }
}

/// A row with zero instead of NaN.
#[cfg_attr(not(debug_assertions), inline(always))]
fn without_nan(row: &[f64; ABREAST]) -> [f64; ABREAST] {
    let mut numbers = [0.0; ABREAST];
    for lane in 0..ABREAST {
        numbers[lane] = if row[lane].is_nan() { 0.0 } else { row[lane] };
    }
    numbers
}

/// The sum of a few small counts. A separate function, as [`Running::joined`] is.
#[inline(never)]
fn total(counts: &[u64; ABREAST]) -> usize {
    let sum: u64 = counts.iter().sum();
    usize::try_from(sum).unwrap_or(usize::MAX)
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn lesser(value: f64, than: f64) -> f64 {
    if value < than { value } else { than }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn greater(value: f64, than: f64) -> f64 {
    if value > than { value } else { than }
}

/// Combines the first half of the lanes with the second half, until one lane is left.
#[cfg_attr(not(debug_assertions), inline(always))]
fn in_halves(mut lanes: [f64; ABREAST], combine: impl Fn(f64, f64) -> f64) -> f64 {
    for half in const { [ABREAST / 2, ABREAST / 4, ABREAST / 8, ABREAST / 16] } {
        for lane in 0..half {
            lanes[lane] = combine(lanes[lane], lanes[lane + half]);
        }
    }
    lanes[0]
}

/// The first index of this value, and the value there, which may be another zero.
#[cfg_attr(not(debug_assertions), inline(always))]
fn first_of(values: &[f64], wanted: f64) -> Option<(usize, f64)> {
    let (rows, rest) = values.as_chunks::<ABREAST>();
    let found = first_rows(rows, wanted);
    let index = first_index(&found).unwrap_or_else(|| {
        #[expect(clippy::float_cmp, reason = "it is one of these values")]
        let offset = rest.iter().position(|value| *value == wanted);
        values.len() - rest.len() + offset.unwrap_or(rest.len())
    });
    values.get(index).map(|value| (index, *value))
}

/// The start of the first row in which each lane has this value, infinity if none has it. The caller gets a copy, as
/// from [`of_rows`].
#[cfg_attr(not(debug_assertions), inline(always))]
fn first_rows(rows: &[[f64; ABREAST]], wanted: f64) -> [f64; ABREAST] {
    // From the last row to the first, so that the first of equal values remains. A loop that stops at it takes longer.
    let mut found = [f64::INFINITY; ABREAST];
    let mut start = [count(ABREAST * rows.len()); ABREAST];
    for row in rows.iter().rev() {
        for lane in 0..ABREAST {
            start[lane] -= const { count(ABREAST) };
        }
        let mut here = [f64::INFINITY; ABREAST];
        for lane in 0..ABREAST {
            #[expect(clippy::float_cmp, reason = "it is one of these values")]
            let is_it = row[lane] == wanted;
            here[lane] = if is_it { start[lane] } else { f64::INFINITY };
        }
        for lane in 0..ABREAST {
            found[lane] = lesser(here[lane], found[lane]);
        }
    }
    found
}

/// The first index that was found, from the start of the row in which each lane found it. A separate function, as
/// [`Running::joined`] is.
#[inline(never)]
fn first_index(found: &[f64; ABREAST]) -> Option<usize> {
    let mut first = f64::INFINITY;
    for (lane, start) in found.iter().enumerate() {
        first = lesser(start + count(lane), first);
    }
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "an index among a few hundred"
    )]
    let index = first as usize;
    first.is_finite().then_some(index)
}
