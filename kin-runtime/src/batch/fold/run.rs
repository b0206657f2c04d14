//! Folds over the poses of a batch, piece by piece.

use core::cell::Cell;
use core::ops::Range;

use super::folded::Folded;
use super::number::{FoldError, FoldedNumber};
use super::poses::{InputGrid, Poses};
use super::reduce::{Fold, PIECE, ROOM, Reduction, Room};
use crate::batch::Column;
use crate::batch::destination::{Destination, Entries};
use crate::batch::dispatch::{MOST_LANES, Vectors};
use crate::batch::outcome::{Outcome, Summary};
use crate::batch::sweep::{Batch, Guide};
use crate::batch::target::Slot;
use crate::batch::transmission::TransmissionColumns;
use crate::mechanism::{Description, Mechanism};
use crate::number::Row;

impl<'a, M: Mechanism<Scalar = f64>, G: Guide<'a, M>> Batch<'a, M, G> {
    /// Solves all poses, as [`solve`](Self::solve) does, and summarises numbers of them instead of storing them.
    ///
    /// `poses` is the number of poses, or a [`InputGrid`]. Each [`Fold`] then holds the summary of its number over the
    /// poses that close; the returned [`Summary`] counts these and those that fail. Nothing is allocated.
    ///
    /// The minima and the maxima, and their poses, are those of the numbers that a batch in the same vectors stores, to
    /// the last bit. Each sum adds the values of 512 poses in 16 running sums, joins these in pairs, and adds the sums
    /// of these pieces from the first to the last. The order is the same in all vectors, whatever their width; the sums
    /// themselves differ as the poses do, by rounding.
    ///
    /// # Errors
    /// Returns a [`FoldError`] if the length of a column differs from the number of poses, or if the mechanism does not
    /// have a number or the input of the grid. Nothing is solved then.
    ///
    /// ```
    /// use kin_core::batch::{Column, Fold, FoldedNumber, Slot, InputGrid};
    /// use kin_core::library::FourBar;
    /// use kin_core::prelude::*;
    ///
    /// let linkage = FourBar { r1: 90.0, r2: 30.0, r3: 80.0, r4: 60.0 };
    /// let mut folds = [
    ///     Fold::of(Slot::Unknown(1, 0)),
    ///     Fold::of(Slot::Unknown(1, 4)),
    ///     Fold::of(FoldedNumber::SmallestTransmissionAngle),
    /// ];
    /// let crank = Motion::at_constant_speed(0.0, 10.0).map(Column::Same);
    /// let summary = linkage.batch(crank, Assembly::Open).fold(InputGrid::revolution(0, 360), &mut folds)?;
    /// assert_eq!(summary.share_solved(), Some(1.0));
    ///
    /// let [rocker, snap, transmission] = folds.map(|fold| *fold.folded());
    /// // the transmission angle is smallest where the crank lies on the ground line
    /// assert_eq!(transmission.least.map(|(pose, _)| pose), Some(0));
    /// println!("swing {:?}, peak snap {:?}", rocker.range(), snap.peak());
    /// # Ok::<(), kin_core::batch::FoldError>(())
    /// ```
    pub fn fold(mut self, poses: impl Into<Poses>, folds: &mut [Fold]) -> Result<Summary, FoldError> {
        let poses = poses.into();
        self.check(&poses, folds)?;
        Ok(fold_pieces(&poses, folds, self.vectors, |piece| {
            self.fold_piece(&poses, piece)
        }))
    }

    /// Takes the column of the input of the grid out of the batch, and checks all others.
    fn check(&mut self, poses: &Poses, folds: &[Fold]) -> Result<(), FoldError> {
        if let Poses::Grid(InputGrid { input, .. }) = *poses {
            let motion = self.inputs.as_mut().get_mut(input);
            motion.ok_or(FoldError::NoSuchInput { input })?[0] = Column::Same(f64::NAN);
        }
        check_numbers(folds, &M::DESCRIPTION, M::Dyads::<f64>::LENGTH)?;
        Ok(self.check_lengths(poses.count())?)
    }

    /// Solves a piece.
    fn fold_piece(&self, poses: &Poses, piece: Piece<'_>) -> Summary {
        let mut batch = self.part(piece.range);
        if let Poses::Grid(grid) = poses {
            batch.inputs[grid.input][0] = Column::Each(piece.varied);
        }
        let mut destination = Destination::nowhere();
        let mut angles = TransmissionColumns::nowhere(M::Dyads::<Entries<'_, f64>>::splat(&[]));
        for (number, entries) in entries(piece.folds, piece.outcomes.len()) {
            match number {
                FoldedNumber::At(slot) => *destination.entries(slot) = entries,
                FoldedNumber::TransmissionAngle(dyad) => angles.of_dyads[dyad] = entries,
                FoldedNumber::SmallestTransmissionAngle => angles.smallest = entries,
            }
        }
        batch.store(&destination, &angles, piece.outcomes)
    }
}

/// Refuses folds of numbers that a mechanism with so many dyads does not have.
pub(in crate::batch) fn check_numbers(
    folds: &[Fold],
    description: &Description<'_>,
    dyads: usize,
) -> Result<(), FoldError> {
    let missing = folds.iter().find(|fold| !fold.number.is_of(description, dyads));
    missing.map_or(Ok(()), |fold| Err(FoldError::NoSuchNumber { number: fold.number }))
}

/// A piece of the poses of a fold, which are to be solved.
pub(in crate::batch) struct Piece<'p> {
    /// The poses.
    pub(in crate::batch) range: Range<usize>,
    /// The values of the input of the grid, if there is one.
    pub(in crate::batch) varied: &'p [f64],
    /// The folds, in whose [room](entries) the numbers are stored.
    pub(in crate::batch) folds: &'p mut [Fold],
    /// An outcome for each pose.
    pub(in crate::batch) outcomes: &'p mut [Outcome],
}

/// The entries of the folded numbers of so many poses. Of folds of the same number the last one has its values.
pub(in crate::batch) fn entries(
    folds: &mut [Fold],
    count: usize,
) -> impl Iterator<Item = (FoldedNumber, Entries<'_, f64>)> {
    folds.iter_mut().map(move |fold| {
        let room = Cell::from_mut(&mut fold.room.0[..count]);
        (fold.number, room.as_slice_of_cells())
    })
}

/// Solves poses piece by piece, and adds each piece to the summaries.
pub(in crate::batch) fn fold_pieces(
    poses: &Poses,
    folds: &mut [Fold],
    vectors: Vectors,
    mut solve: impl FnMut(Piece<'_>) -> Summary,
) -> Summary {
    start(folds);
    let mut scratch = Scratch {
        varied: Room([0.0; ROOM]),
        outcomes: [Outcome::Unsolved; ROOM],
    };
    let (mut summary, mut first) = (Summary::default(), 0);
    while first < poses.count() {
        let range = piece(first, poses.count());
        let end = range.end;
        let count = range.len();
        let (varied, outcomes) = (&mut scratch.varied.0[..count], &mut scratch.outcomes[..count]);
        if let Poses::Grid(grid) = poses {
            grid.fill(first, varied);
        }
        let mut piece_summary = solve(Piece {
            range,
            varied,
            folds: &mut *folds,
            outcomes: &mut *outcomes,
        });
        if let Some((index, _)) = &mut piece_summary.first_failure {
            *index += first;
        }
        if piece_summary.failed > 0 {
            leave_out(folds, outcomes);
        }
        vectors.run(Reduction {
            folds: &mut *folds,
            first,
            count,
            is_complete: piece_summary.failed == 0,
        });
        summary = summary.and(piece_summary);
        first = end;
    }
    copy_twins(folds);
    summary
}

/// Room for what a piece needs besides the values of its folds.
struct Scratch {
    /// The values of the input of the grid.
    varied: Room,
    outcomes: [Outcome; ROOM],
}

/// The piece that starts at a pose. None but the only one has fewer poses than lanes: they would be solved one by one
/// and rounded differently.
fn piece(first: usize, count: usize) -> Range<usize> {
    first..if count - first < PIECE + MOST_LANES {
        count
    } else {
        first + PIECE
    }
}

/// Starts the summaries anew.
fn start(folds: &mut [Fold]) {
    for fold in folds {
        fold.folded = Folded::default();
        if let FoldedNumber::At(Slot::Sine(_)) = fold.number {
            // Only directions have a sine. Without one, nothing is stored.
            fold.room = Room([f64::NAN; ROOM]);
        }
    }
}

/// Leaves out the inputs of poses that fail: a batch stores them, because they are given.
fn leave_out(folds: &mut [Fold], outcomes: &[Outcome]) {
    let of_input = |fold: &&mut Fold| matches!(fold.number, FoldedNumber::At(Slot::Input(..)));
    for fold in folds.iter_mut().filter(of_input) {
        for (value, outcome) in fold.room.0.iter_mut().zip(outcomes) {
            *value = if outcome.is_solved() { *value } else { f64::NAN };
        }
    }
}

/// Copies the summary of a number to all folds of it: its values were stored for the last one only.
fn copy_twins(folds: &mut [Fold]) {
    for index in (0..folds.len()).rev() {
        let Fold { number, folded, .. } = folds[index];
        for twin in &mut folds[..index] {
            if twin.number == number {
                twin.folded = folded;
            }
        }
    }
}
