//! The parts of a batch that threads solve.

use std::num::NonZero;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};
use std::thread;

use kin_core::SolveError;
use kin_core::batch::{Column, Outcome, Slot, angles_from_cosines};

use crate::arguments::Group;

/// The poses that a thread solves in one go: a multiple of all widths of vectors, so that no pose depends on the number
/// of threads.
const PIECE: usize = 8192;

/// The fewest poses of a piece. Fewer than a vector are solved one by one, and rounded differently.
const FEWEST: usize = 512;

/// The memory of a thread, which its pieces use again.
pub(super) struct Scratch {
    pub(super) outcomes: Vec<Outcome>,
    /// For each unknown that is a direction.
    pub(super) sines: Vec<f64>,
}

/// The part of a batch that one thread solves.
pub(super) struct Piece<'w> {
    pub(super) from: usize,
    pub(super) wanted: Vec<(Slot, &'w mut [f64])>,
    pub(super) outcomes: OutcomeColumns<'w>,
}

/// The memory of how poses end.
pub(super) struct OutcomeColumns<'w> {
    pub(super) solved: &'w mut [bool],
    pub(super) singular: &'w mut [bool],
    pub(super) margin: &'w mut [f64],
}

impl OutcomeColumns<'_> {
    fn split_at(self, length: usize) -> [Self; 2] {
        let (solved, other_solved) = self.solved.split_at_mut(length);
        let (singular, other_singular) = self.singular.split_at_mut(length);
        let (margin, other_margin) = self.margin.split_at_mut(length);
        let rest = Self {
            solved: other_solved,
            singular: other_singular,
            margin: other_margin,
        };
        [
            Self {
                solved,
                singular,
                margin,
            },
            rest,
        ]
    }

    pub(super) fn write(self, outcomes: &[Outcome], are_solved: bool) {
        // nearly always, and faster
        if are_solved {
            self.solved.fill(true);
            self.singular.fill(false);
            self.margin.fill(f64::NAN);
            return;
        }
        for (index, outcome) in outcomes.iter().enumerate() {
            self.solved[index] = outcome.is_solved();
            self.singular[index] = matches!(outcome, Outcome::Singular);
            self.margin[index] = outcome.margin().unwrap_or(f64::NAN);
        }
    }
}

/// The numbers of the memory of a batch, array after array.
pub(super) struct Columns<'d, 'a> {
    pub(super) groups: &'a [(Group<'d>, bool)],
    pub(super) orders: usize,
    pub(super) count: usize,
    pub(super) numbers: Vec<&'a mut [f64]>,
}

impl Columns<'_, '_> {
    /// The pieces that threads solve.
    pub(super) fn pieces<'w>(&'w mut self, outcomes: OutcomeColumns<'w>) -> Vec<Piece<'w>> {
        let mut rest: Vec<(Slot, &'w mut [f64])> = Vec::new();
        for (index, numbers) in self.numbers.iter_mut().enumerate() {
            let (group, is_output) = &self.groups[index / self.orders];
            let order = index % self.orders;
            let coordinates = numbers.chunks_exact_mut(self.count.max(1)).take(group.coordinates);
            for (coordinate, numbers) in coordinates.enumerate() {
                let scalar = group.first + coordinate;
                let slot = if *is_output {
                    Slot::Output(scalar, order)
                } else {
                    Slot::Unknown(scalar, order)
                };
                rest.push((slot, numbers));
            }
        }

        let (mut outcomes, mut from, mut pieces) = (outcomes, 0, Vec::new());
        while from < self.count {
            let left = self.count - from;
            let length = if left < PIECE + FEWEST { left } else { PIECE };
            let [part, others] = outcomes.split_at(length);
            let split = |(slot, numbers): &mut (Slot, &'w mut [f64])| {
                let (part, others) = std::mem::take(numbers).split_at_mut(length);
                *numbers = others;
                (*slot, part)
            };
            pieces.push(Piece {
                from,
                wanted: rest.iter_mut().map(split).collect(),
                outcomes: part,
            });
            (outcomes, from) = (others, from + length);
        }
        pieces
    }
}

/// Makes angles of an unknown that is a direction, of which a batch stores the cosines and sines.
pub(super) fn make_angles(columns: &mut [(Slot, &mut [f64])], unknown: usize, sines: &[f64]) {
    let is_meant = |slot: &Slot| matches!(slot, Slot::Unknown(index, 0) if *index == unknown);
    for (_, cosines) in columns.iter_mut().filter(|(slot, _)| is_meant(slot)) {
        angles_from_cosines(cosines, sines);
    }
}

/// The parts of columns for a range of poses.
pub(super) fn parts<'a>(columns: &[Column<'a>], range: &Range<usize>) -> Vec<Column<'a>> {
    columns.iter().map(|column| column.part(range.clone())).collect()
}

/// The number of threads that is wished: zero or none is one for each core.
pub(super) fn threads(wished: Option<usize>) -> usize {
    let all = || thread::available_parallelism().map_or(1, NonZero::get);
    wished.filter(|threads| *threads > 0).unwrap_or_else(all)
}

/// Solves all pieces, and returns the failure with the lowest index.
pub(super) fn on_threads(
    pieces: Vec<Piece<'_>>,
    threads: usize,
    solve: impl Fn(&mut Scratch, Piece<'_>) -> Option<(usize, SolveError)> + Sync,
) -> Option<(usize, SolveError)> {
    let threads = threads.min(pieces.len());
    let solve_all = |pieces: &mut dyn Iterator<Item = Piece<'_>>| -> Vec<(usize, SolveError)> {
        let mut scratch = Scratch {
            outcomes: Vec::new(),
            sines: Vec::new(),
        };
        pieces.filter_map(|piece| solve(&mut scratch, piece)).collect()
    };
    let failures: Vec<(usize, SolveError)> = if threads <= 1 {
        solve_all(&mut pieces.into_iter())
    } else {
        // Threads of this call only: a process that is forked later has no thread that waits for work.
        let pieces = Mutex::new(pieces.into_iter());
        let next = || pieces.lock().unwrap_or_else(PoisonError::into_inner).next();
        thread::scope(|scope| {
            let work = || solve_all(&mut std::iter::from_fn(next));
            let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
            let found = workers.into_iter().flat_map(|worker| match worker.join() {
                Ok(found) => found,
                Err(panic) => std::panic::resume_unwind(panic),
            });
            found.collect()
        })
    };
    failures.into_iter().min_by_key(|(index, _)| *index)
}
